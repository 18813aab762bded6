// The kind of image file that a name asks for.
#pragma once

namespace gp::api {

enum class FileEnding { png, exr, hdr };
FileEnding endingOf(const char* path);  // throws ApiError; capitals count as small letters

}  // namespace gp::api
