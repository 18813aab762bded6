// The error for a name that nothing has.
#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "nearest_word.h"
#include "scene/bsdf_registry.h"

namespace gp {

// Throws BsdfError: "unknown model 'phon' (did you mean phong?)", or all names where none is near.
[[noreturn]] inline void throwUnknown(const std::string& what, const std::string& name,
                                      const std::vector<std::string>& names) {
    const std::string nearest = nearestWord(name, names);
    const std::string hint = nearest.empty()
        ? fmt::format("there are: {}", fmt::join(names, ", "))
        : fmt::format("did you mean {}?", nearest);
    throw BsdfError(fmt::format("unknown {} '{}' ({})", what, name, hint));
}

}  // namespace gp
