#include <fmt/format.h>

#include <cctype>

#include "animate/frame_writer.h"
#include "output.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

[[noreturn]] void failPattern(const std::string& path, const char* what) {
    throw UsageError(fmt::format("--output: '{}' {}; it must hold one number such as %04d, or end "
                                 "in .mp4, .mkv or .webm", path, what));
}

// The text with each number replaced by `insert(width)`; counts the numbers. Our own reading of
// %d, since a pattern from a command line must never reach printf.
template <class Insert>
std::string expanded(const std::string& pattern, int& numbers, const Insert& insert) {
    std::string text;
    numbers = 0;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (pattern[i] != '%') {
            text += pattern[i];
            continue;
        }
        std::size_t end = i + 1;
        if (end < pattern.size() && pattern[end] == '%') {
            text += '%';
            i = end;
            continue;
        }
        unsigned width = 0;
        if (end + 1 < pattern.size() && pattern[end] == '0' &&
            std::isdigit(static_cast<unsigned char>(pattern[end + 1])) != 0) {
            width = static_cast<unsigned>(pattern[end + 1] - '0');
            end += 2;
        }
        if (end >= pattern.size() || pattern[end] != 'd') {
            failPattern(pattern, "has a % that begins no number");
        }
        text += insert(width);
        ++numbers;
        i = end;
    }
    return text;
}

class NumberedFiles final : public FrameWriter {
public:
    NumberedFiles(std::string pattern, const GpSaveOptions& save)
        : m_pattern(std::move(pattern)), m_save(save) {}

    void write(GpDevice device, GpFrame frame, std::uint32_t number) override {
        const std::string path = numberedPath(m_pattern, number);
        check(device, gpSaveFrame(frame, path.c_str(), &m_save));
    }
    void finish() override {}
    std::string name() const override { return m_pattern; }

private:
    std::string m_pattern;
    GpSaveOptions m_save;
};

}  // namespace

std::string numberedPath(const std::string& pattern, std::uint32_t number) {
    int numbers = 0;
    return expanded(pattern, numbers,
                    [&](unsigned width) { return fmt::format("{:0{}}", number, width); });
}

void checkFrameOutput(const std::string& path, Size size) {
    if (isVideo(path)) {
        // Colour is stored at half the resolution of brightness.
        if (size.width % 2 != 0 || size.height % 2 != 0) {
            throw UsageError(fmt::format("--size: {}x{}: a video needs even numbers", size.width,
                                         size.height));
        }
        checkWritable(path);
        return;
    }
    int numbers = 0;
    expanded(path, numbers, [](unsigned) { return std::string("0"); });
    if (numbers != 1) {
        failPattern(path, numbers == 0 ? "names one file" : "holds several numbers");
    }
    pictureFormat(path);
    checkWritable(numberedPath(path, 0));
}

std::unique_ptr<FrameWriter> newFrameWriter(const std::string& path, const VideoFormat& format,
                                            const GpSaveOptions& save) {
    if (isVideo(path)) {
        return newVideoWriter(path, format);
    }
    return std::make_unique<NumberedFiles>(path, save);
}

}  // namespace gp::tool
