// What a glTF file refers to: data inside of the uri, or a file in its own folder.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf_json.h"

namespace gp::io {

bool isDataUri(std::string_view uri);

// The bytes of a data uri (base64 or percent-encoded). `value` is where an error points.
std::vector<std::byte> decodeDataUri(const Value& value);

// The path of the file that a relative uri names, `folder` being the glTF file's. An absolute
// path, another scheme, or a path that leaves the folder is an error: files come from strangers.
std::string resolveUri(const Value& value, const std::string& folder);

}  // namespace gp::io
