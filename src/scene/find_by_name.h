// The error for a name that nothing has.
#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "nearest_word.h"
#include "scene/bsdf_registry.h"

namespace gp {

// Throws BsdfError: "unknown model 'phon' (did you mean phong?)", or where none is near the first
// names: an error is a line.
[[noreturn]] inline void throwUnknown(const std::string& what, const std::string& name,
                                      const std::vector<std::string>& names) {
    constexpr size_t shown = 12;
    const std::string nearest = nearestWord(name, names);
    const auto end = names.size() > shown ? names.begin() + shown : names.end();
    const std::string hint = !nearest.empty() ? fmt::format("did you mean {}?", nearest)
        : fmt::format("there are: {}{}", fmt::join(names.begin(), end, ", "),
                      end == names.end() ? "" : fmt::format(" and {} more", names.end() - end));
    throw BsdfError(fmt::format("unknown {} '{}' ({})", what, name, hint));
}

}  // namespace gp
