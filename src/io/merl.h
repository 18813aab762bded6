// Measured materials: MERL's .binary files.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "io/file_error.h"
#include "scene/measured_brdf.h"

namespace gp::io {

// By the ending, as people write it.
bool isMerlName(std::string_view name);

// Throws FileError: no file, another size, other dimensions, a number that is none, nothing
// measured. While somebody has the table of an unchanged file, readMerl gives out the same.
std::shared_ptr<const MeasuredBrdf> readMerl(const std::string& path);
std::shared_ptr<const MeasuredBrdf> parseMerl(const std::string& path,
                                              std::span<const std::byte> bytes);

// The file appears when it is whole. `cells` as makeMeasuredBrdf takes them. Throws FileError.
void writeMerl(const std::string& path, std::span<const float> cells);

}  // namespace gp::io
