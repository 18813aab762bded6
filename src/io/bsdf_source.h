// From the word MODEL to parameters: the one place where a name becomes a material. It is a model
// of the registry, a preset of ours, FILE.toml#NAME (a preset of a file; #NAME may be missing where
// there is only one) or FILE.binary (measured).
#pragma once

#include <string>

#include "io/presets.h"
#include "scene/bsdf_dialect.h"

namespace gp::io {

// With `words` over it. Throws BsdfError, FileError.
BsdfSettings bsdfFromName(BsdfDialect dialect, const std::string& name, const BsdfWords& words);

// The same as a stack; models and measured files are one layer.
Preset stackFromName(const std::string& name);

}  // namespace gp::io
