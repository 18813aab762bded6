// Where the frames of a moving picture go: numbered files, or a video.
#pragma once

#include <memory>
#include <string>

#include "library.h"
#include "parse.h"
#include "render_settings.h"

namespace gp::tool {

class FrameWriter {
public:
    virtual ~FrameWriter() = default;
    // What DISPLAY and COLOR of the frame show becomes the picture of this number. Throws RunError.
    virtual void write(GpDevice device, GpFrame frame, std::uint32_t number) = 0;
    // The file is whole; without it, a video is not kept. Throws RunError.
    virtual void finish() = 0;
    // For people: of everything that was written.
    virtual std::string name() const = 0;
};

// Whether the path names a video (.mp4, .mkv, .webm), by its ending.
bool isVideo(const std::string& path);

// "dir/%04d.png" and a number as a path; "%%" is a percent sign.
std::string numberedPath(const std::string& pattern, std::uint32_t number);

// Throws UsageError where the path is neither a video nor a pattern with one number, or where the
// size is not for videos; RunError where nothing can be written there.
void checkFrameOutput(const std::string& path, Size size);

struct VideoFormat {
    Size size;
    double framesPerSecond = 24;
};

// A video needs the program ffmpeg, which starts now: RunError where there is none.
std::unique_ptr<FrameWriter> newFrameWriter(const std::string& path, const VideoFormat& format,
                                            const GpSaveOptions& save);
std::unique_ptr<FrameWriter> newVideoWriter(const std::string& path, const VideoFormat& format);

}  // namespace gp::tool
