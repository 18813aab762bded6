// Videos through the program ffmpeg: it gets the frames through a pipe, writes under a temporary
// name, and what it says last is our error message.
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <vector>

#include "animate/frame_writer.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

// What each ending stands for: container and codec, as ffmpeg calls them, and the codec's settings.
// The quality is one at which people see no difference from the frames.
struct Container {
    const char* ending;
    const char* muxer;
    std::vector<const char*> codec;
};
const std::array<Container, 3> kContainers = {{
    {".mp4", "mp4", {"-c:v", "libx264", "-crf", "16", "-movflags", "+faststart"}},
    {".mkv", "matroska", {"-c:v", "libx264", "-crf", "16"}},
    {".webm", "webm", {"-c:v", "libvpx-vp9", "-crf", "20", "-b:v", "0", "-row-mt", "1"}},
}};

const Container* containerOf(const std::string& path) {
    for (const Container& container : kContainers) {
        if (path.ends_with(container.ending)) {
            return &container;
        }
    }
    return nullptr;
}

// A program that reads our frames. Whatever happens, it is gone when this is.
class Encoder {
public:
    Encoder(const Container& container, const std::string& path, const VideoFormat& format)
        : m_messages(std::tmpfile()) {
        // Frames go through a pipe whose reader may end early: that is an error of write(), no
        // signal.
        std::signal(SIGPIPE, SIG_IGN);
        int ends[2];
        if (m_messages == nullptr || pipe2(ends, O_CLOEXEC) != 0) {
            const std::string reason = std::strerror(errno);
            release();
            throw RunError(fmt::format("cannot talk to ffmpeg: {}", reason));
        }
        m_pipe = ends[1];
        const int error = spawn(wordsFor(container, path, format), ends[0]);
        close(ends[0]);
        if (error == 0) {
            return;
        }
        release();
        if (error == ENOENT) {
            throw RunError("videos need the program ffmpeg on the PATH (Debian: ffmpeg)");
        }
        throw RunError(fmt::format("cannot start ffmpeg: {}", std::strerror(error)));
    }
    ~Encoder() {
        if (m_child > 0) {
            kill(m_child, SIGKILL);
            wait();
        }
        release();
    }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    void send(const std::vector<unsigned char>& bytes) {
        std::size_t sent = 0;
        while (sent < bytes.size()) {
            const ssize_t count = ::write(m_pipe, bytes.data() + sent, bytes.size() - sent);
            if (count < 0 && errno == EINTR) {
                continue;
            }
            if (count <= 0) {
                finish();
                throw RunError("ffmpeg stopped reading before the last frame");
            }
            sent += static_cast<std::size_t>(count);
        }
    }

    // Tells the program that this was all, and waits. Throws RunError with its words if it failed.
    void finish() {
        close(m_pipe);
        m_pipe = -1;
        const int status = wait();
        if (WIFSIGNALED(status)) {
            throw RunError(fmt::format("ffmpeg was ended by signal {}", WTERMSIG(status)));
        }
        if (WEXITSTATUS(status) != 0) {
            throw RunError(
                fmt::format("ffmpeg failed ({}): {}", WEXITSTATUS(status), lastMessage()));
        }
    }

private:
    // The frames are sRGB with all of its range; the video says so, and how it was converted.
    static std::vector<std::string> wordsFor(const Container& container, const std::string& path,
                                             const VideoFormat& format) {
        std::vector<std::string> words = {
            "ffmpeg", "-hide_banner", "-loglevel", "error", "-nostdin", "-f", "rawvideo",
            "-pix_fmt", "rgba", "-s:v", fmt::format("{}x{}", format.size.width, format.size.height),
            "-r", fmt::format("{}", format.framesPerSecond), "-i", "pipe:0",
            "-vf", "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd",
            "-pix_fmt", "yuv420p", "-colorspace", "bt709", "-color_primaries", "bt709",
            "-color_trc", "iec61966-2-1", "-color_range", "tv"};
        words.insert(words.end(), container.codec.begin(), container.codec.end());
        words.insert(words.end(), {"-f", container.muxer, "-y", "file:" + path});
        return words;
    }

    int spawn(std::vector<std::string> words, int readEnd) {
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, readEnd, STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&actions, fileno(m_messages), STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions, fileno(m_messages), STDERR_FILENO);
        // In a group of its own, Ctrl-C is ours alone: the frames so far become a whole video.
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
        posix_spawnattr_setpgroup(&attributes, 0);
        sigset_t normal;  // what we ignore, it need not
        sigemptyset(&normal);
        sigaddset(&normal, SIGPIPE);
        posix_spawnattr_setsigdefault(&attributes, &normal);
        std::vector<char*> arguments;
        for (std::string& word : words) {
            arguments.push_back(word.data());
        }
        arguments.push_back(nullptr);
        const int error =
            posix_spawnp(&m_child, "ffmpeg", &actions, &attributes, arguments.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        posix_spawnattr_destroy(&attributes);
        if (error != 0) {
            m_child = 0;
        }
        return error;
    }

    int wait() {
        int status = 0;
        while (waitpid(m_child, &status, 0) < 0 && errno == EINTR) {
        }
        m_child = 0;
        return status;
    }

    void release() {
        if (m_pipe >= 0) {
            close(m_pipe);
        }
        if (m_messages != nullptr) {
            std::fclose(m_messages);
        }
        m_pipe = -1;
        m_messages = nullptr;
    }

    std::string lastMessage() const {
        std::rewind(m_messages);
        std::string last = "it said nothing";
        std::array<char, 1024> line{};
        while (std::fgets(line.data(), line.size(), m_messages) != nullptr) {
            const std::string text(line.data(), std::strcspn(line.data(), "\r\n"));
            if (!text.empty()) {
                last = text;
            }
        }
        return last;
    }

    std::FILE* m_messages = nullptr;
    int m_pipe = -1;
    pid_t m_child = 0;
};

class VideoWriter final : public FrameWriter {
public:
    VideoWriter(std::string path, const VideoFormat& format)
        : m_path(std::move(path)), m_part(fmt::format("{}.part{}", m_path, ::getpid())),
          m_encoder(std::make_unique<Encoder>(*containerOf(m_path), m_part, format)),
          m_pixels(std::size_t{4} * format.size.width * format.size.height) {}
    ~VideoWriter() override {
        m_encoder.reset();  // before the file goes that it writes
        if (!m_whole) {
            std::remove(m_part.c_str());
        }
    }

    void write(GpDevice device, GpFrame frame, std::uint32_t) override {
        check(device, gpReadFrameImage(frame, GP_IMAGE_DISPLAY, m_pixels.data(), m_pixels.size()));
        m_encoder->send(m_pixels);
    }
    void finish() override {
        m_encoder->finish();
        if (std::rename(m_part.c_str(), m_path.c_str()) != 0) {
            throw RunError(fmt::format("{}: cannot write: {}", m_path, std::strerror(errno)));
        }
        m_whole = true;
    }
    std::string name() const override { return m_path; }

private:
    std::string m_path, m_part;
    std::unique_ptr<Encoder> m_encoder;
    std::vector<unsigned char> m_pixels;
    bool m_whole = false;
};

}  // namespace

bool isVideo(const std::string& path) {
    return containerOf(path) != nullptr;
}

std::unique_ptr<FrameWriter> newVideoWriter(const std::string& path, const VideoFormat& format) {
    return std::make_unique<VideoWriter>(path, format);
}

}  // namespace gp::tool
