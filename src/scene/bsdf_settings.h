// From settings to what the shading functions take. To be included after shading/shading.h: like
// all of shading, the parameters are a type of each translation unit.
#pragma once

#include "scene/bsdf_registry.h"
#include "scene/glint_dictionary.h"
#include "scene/measured_brdf.h"
#include "shading/shading.h"

namespace gp {
namespace {

// Without what models derive from their parameters: bsdfParamsFrom is for everyone else.
[[maybe_unused]] shading::BsdfParams bareBsdfParams(const BsdfSettings& settings) {
    using namespace shading;
    BsdfParams m = bsdf_params_of(settings.model->number);
    uint32_t row = 0;
    // Colors take all of the value, everything else its first component.
#define GP_VALUE_FLOAT value->x
#define GP_VALUE_COLOR *value
#define GP_VALUE_BOOL value->x
#define GP_VALUE_FLAG value->x
#define GP_VALUE_CHOICE value->x
#define GP_SET_ROW(type, where)                                             \
    if (const vec3* value = settings.valueOfRow(row)) {                      \
        BSDF_SET_##type(m.where, (GP_VALUE_##type))                          \
    }                                                                        \
    ++row;
#define BSDF_FIELD(number, name, type, field, initial, minimum, maximum, outside, unit, text) \
    GP_SET_ROW(type, field)
#define BSDF_PARAMETER(number, accessor, name, type, slot, initial, minimum, maximum, outside, \
                       unit, text)                                                             \
    GP_SET_ROW(type, slot)
#include "shading/bsdf/parameters.def"
#undef BSDF_FIELD
#undef BSDF_PARAMETER
#undef GP_SET_ROW
#undef GP_VALUE_FLOAT
#undef GP_VALUE_COLOR
#undef GP_VALUE_BOOL
#undef GP_VALUE_FLAG
#undef GP_VALUE_CHOICE
    if (settings.model->number == MODEL_GLINT) m.table = glintDictionary();
    if (settings.measured) m.table = settings.measured->address();
    return m;
}

[[maybe_unused]] shading::BsdfParams bsdfParamsFrom(const BsdfSettings& settings) {
    return shading::bsdf_prepared(bareBsdfParams(settings));
}

}  // namespace
}  // namespace gp
