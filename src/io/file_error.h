// A file that cannot be used: one clear line that names the file and the thing.
#pragma once

#include <stdexcept>
#include <string>

namespace gp::io {

struct FileError : std::runtime_error {
    enum class Kind { notFound, invalid, unsupported, writeFailed };
    Kind kind;
    FileError(Kind k, const std::string& path, const std::string& what)
        : std::runtime_error(path + ": " + what), kind(k) {}
};

}  // namespace gp::io
