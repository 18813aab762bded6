// Whole files in and out of memory.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "io/file_error.h"

namespace gp::io {

// Throws FileError when there is no such regular file or it cannot be read.
std::vector<std::byte> readFile(const std::string& path);

// A file that appears under its name only once it is whole: it is written under a temporary name
// in the same folder, and commit() renames it. Without commit() the temporary file is removed.
class AtomicFile {
public:
    explicit AtomicFile(std::string path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    const std::string& temporaryPath() const { return m_temporary; }
    void write(std::span<const std::byte> bytes);  // the whole content at once
    void commit();

private:
    std::string m_path;
    std::string m_temporary;
    bool m_committed = false;
};

}  // namespace gp::io
