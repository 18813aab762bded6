#include "frame/denoiser_parameters.h"

namespace gp {
namespace {

constexpr DenoiserParameterInfo infos[] = {
#define X(name, initial, minimum, maximum, text) \
    {#name, initial, minimum, maximum, text, &DenoiserParameters::name},
#include "shared/denoiser_parameters.def"
#undef X
};

// Names tell: the first row whose words a name begins and ends with. What stands in none is of all
// denoisers that filter.
struct User {
    std::string_view begin, end, user, another = {};
};
constexpr User users[] = {
    {"reuse_", "", "light reuse"},
    {"indirect_reuse_", "", "indirect reuse"},
    {"resolve_", "", "anti-aliasing"},
    {"svgf_", "", "svgf", "bmfr"},  // their temporal passes are one
    {"bmfr_", "", "bmfr"},
    {"", "_history_frames", "asvgf"},
    {"", "_antilag", "asvgf"},
    {"antilag_", "", "asvgf"},
    {"filter_luminance", "", "asvgf", "svgf"},  // one frame alone knows no deviation
};

}  // namespace

std::vector<std::string_view> usersOf(const DenoiserParameterInfo& parameter) {
    const std::string_view name = parameter.name;
    for (const User& row : users)
        if (name.starts_with(row.begin) && name.ends_with(row.end)) {
            if (row.another.empty()) return {row.user};
            return {row.user, row.another};
        }
    if (name.starts_with("history_") || name == "firefly_limit")
        return {"asvgf", "svgf", "atrous", "bmfr"};
    return {"asvgf", "svgf", "atrous"};
}

std::span<const DenoiserParameterInfo> denoiserParameters() { return infos; }

}  // namespace gp
