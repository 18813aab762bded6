// Where results go: a file that appears only when it is whole, or stdout.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace gp::tool {

// Throws RunError where a file could not be written to `path` ("-" is stdout). To be called before
// the long work, so that nobody waits an hour for a missing folder.
void checkWritable(const std::string& path);

// `path` "-" is stdout. Throws RunError.
void writeText(const std::string& path, const std::string& text);
void writeJson(const std::string& path, const nlohmann::ordered_json& json);

// Hours, minutes and seconds as people write them: "0:07", "2:05:00".
std::string clockText(double seconds);
// "12.3 MB"
std::string bytesText(double bytes);

}  // namespace gp::tool
