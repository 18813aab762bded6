#include "io/file.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include <unistd.h>

namespace gp::io {
namespace fs = std::filesystem;

namespace {

struct CloseFile {
    void operator()(std::FILE* f) const { std::fclose(f); }
};
using FilePtr = std::unique_ptr<std::FILE, CloseFile>;

std::string reason(int error) { return std::strerror(error); }

}  // namespace

std::vector<std::byte> readFile(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        throw FileError(FileError::Kind::notFound, path, "no such file");
    // A pipe or a device would block or never end.
    if (!fs::is_regular_file(status))
        throw FileError(FileError::Kind::invalid, path, "not a regular file");
    const FilePtr file(std::fopen(path.c_str(), "rb"));
    if (!file)
        throw FileError(FileError::Kind::notFound, path, "cannot be opened: " + reason(errno));
    const uintmax_t size = fs::file_size(path, error);
    if (error)
        throw FileError(FileError::Kind::notFound, path, "cannot be read: " + error.message());
    std::vector<std::byte> bytes(size);
    if (std::fread(bytes.data(), 1, bytes.size(), file.get()) != bytes.size())
        throw FileError(FileError::Kind::invalid, path, "cannot be read to its end");
    return bytes;
}

AtomicFile::AtomicFile(std::string path) : m_path(std::move(path)) {
    // Unique in the process by the counter, between processes by the process number.
    static std::atomic<unsigned> counter{0};
    m_temporary = m_path + ".part" + std::to_string(getpid()) + "-" + std::to_string(counter++);
}

AtomicFile::~AtomicFile() {
    if (m_committed) return;
    std::error_code ignored;
    fs::remove(m_temporary, ignored);
}

void AtomicFile::write(std::span<const std::byte> bytes) {
    std::FILE* file = std::fopen(m_temporary.c_str(), "wb");
    if (!file)
        throw FileError(FileError::Kind::writeFailed, m_path,
                        "cannot be written: " + reason(errno));
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    // A full disk often shows only when the last buffer is flushed.
    if (std::fclose(file) != 0 || !written)
        throw FileError(FileError::Kind::writeFailed, m_path,
                        "cannot be written: " + reason(errno));
}

void AtomicFile::commit() {
    std::error_code error;
    fs::rename(m_temporary, m_path, error);
    if (error)
        throw FileError(FileError::Kind::writeFailed, m_path,
                        "cannot be written: " + error.message());
    m_committed = true;
}

}  // namespace gp::io
