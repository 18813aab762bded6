#include "scene/bsdf_registry.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/find_by_name.h"
#include "scene/measured_brdf.h"
#include "shading/shading.h"

namespace gp {
namespace {

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    for (;;) {
        const std::size_t at = text.find(separator);
        parts.emplace_back(text.substr(0, at));
        if (at == std::string_view::npos) return parts;
        text.remove_prefix(at + 1);
    }
}

// As parameters.def spells them; rows need not use all of them.
[[maybe_unused]] constexpr BsdfParameterType FLOAT = BsdfParameterType::number;
[[maybe_unused]] constexpr BsdfParameterType COLOR = BsdfParameterType::color;
[[maybe_unused]] constexpr BsdfParameterType BOOL = BsdfParameterType::boolean;
[[maybe_unused]] constexpr BsdfParameterType FLAG = BsdfParameterType::boolean;
[[maybe_unused]] constexpr BsdfParameterType CHOICE = BsdfParameterType::choice;
[[maybe_unused]] constexpr bool CLAMPED = false;
[[maybe_unused]] constexpr bool ALLOWED = true;

struct ParameterRow {
    uint32_t model;
    const char* name;
    BsdfParameterType type;
    glm::vec3 initial;
    float minimum, maximum;
    bool mayExceed;
    const char* unit;
    const char* text;
};

const std::vector<ParameterRow>& parameterRows() {
    using namespace shading;
    static const std::vector<ParameterRow> rows = {
#define BSDF_FIELD(number, name, type, field, initial, minimum, maximum, outside, unit, text) \
    {number, name, type, glm::vec3(initial), minimum, maximum, outside, unit, text},
#define BSDF_PARAMETER(number, accessor, name, type, slot, initial, minimum, maximum, outside, \
                       unit, text) \
    {number, name, type, glm::vec3(initial), minimum, maximum, outside, unit, text},
#include "shading/bsdf/parameters.def"
#undef BSDF_FIELD
#undef BSDF_PARAMETER
    };
    return rows;
}

std::vector<BsdfParameterInfo> parametersOf(uint32_t model) {
    std::vector<BsdfParameterInfo> list;
    uint32_t number = 0;
    for (const ParameterRow& row : parameterRows()) {
        const uint32_t index = number++;
        if (row.model != model) continue;
        BsdfParameterInfo info;
        info.name = row.name;
        info.type = row.type;
        info.initial = row.initial;
        info.minimum = row.minimum;
        info.maximum = row.maximum;
        info.mayExceed = row.mayExceed;
        if (row.type == BsdfParameterType::choice) {
            info.choices = split(row.unit, '|');
        } else {
            info.unit = row.unit;
        }
        info.text = row.text;
        info.row = index;
        list.push_back(std::move(info));
    }
    return list;
}

std::vector<BsdfModelInfo> makeModels() {
    using namespace shading;
    std::vector<BsdfModelInfo> models;
    const auto add = [&](uint number, const char* name, uint flags, const char* reference,
                         const char* text) {
        BsdfModelInfo info;
        info.number = number;
        info.name = name;
        info.reciprocal = (flags & BSDF_RECIPROCAL) != 0u;
        info.conserving = (flags & BSDF_CONSERVING) != 0u;
        info.transmissive = (flags & BSDF_TRANSMISSIVE) != 0u;
        info.fromFile = (flags & BSDF_FROM_FILE) != 0u;
        info.reference = reference;
        info.text = text;
        info.parameters = parametersOf(number);
        models.push_back(std::move(info));
    };
#define BSDF_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text) \
    add(number, #name, flags, #cite, text);
#include "shading/bsdf/models.def"
#undef BSDF_MODEL
    return models;
}

template <class List>
const auto& findByName(const List& list, const std::string& what, const std::string& name) {
    std::vector<std::string> names;
    for (const auto& entry : list) {
        if (entry.name == name) return entry;
        names.push_back(entry.name);
    }
    throwUnknown(what, name, names);
}

template <class... Args>
[[noreturn]] void refuse(const BsdfModelInfo& model, const BsdfParameterInfo& parameter,
                         fmt::format_string<Args...> format, Args&&... args) {
    throw BsdfError(fmt::format("{}: {}: {}", model.name, parameter.name,
                                fmt::format(format, std::forward<Args>(args)...)));
}

float readNumber(const BsdfModelInfo& model, const BsdfParameterInfo& parameter,
                 std::string_view text) {
    double value = 0;
    std::string_view word = text;
    if (word.starts_with('+')) word.remove_prefix(1);  // from_chars knows no plus sign
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(static_cast<float>(value))) {
        refuse(model, parameter, "'{}' is not a finite number", text);
    }
    return static_cast<float>(value);
}

float readBoolean(const BsdfModelInfo& model, const BsdfParameterInfo& parameter,
                  std::string_view text) {
    if (text == "true" || text == "1" || text == "on" || text == "yes") return 1.0f;
    if (text == "false" || text == "0" || text == "off" || text == "no") return 0.0f;
    refuse(model, parameter, "'{}' is neither true nor false", text);
}

float readChoice(const BsdfModelInfo& model, const BsdfParameterInfo& parameter,
                 std::string_view text) {
    const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), text);
    if (found == parameter.choices.end()) {
        refuse(model, parameter, "unknown '{}' (there are: {})", text,
               fmt::join(parameter.choices, ", "));
    }
    return static_cast<float>(found - parameter.choices.begin());
}

glm::vec3 readColor(const BsdfModelInfo& model, const BsdfParameterInfo& parameter,
                    std::string_view text) {
    const std::vector<std::string> parts = split(text, ',');
    if (parts.size() != 1 && parts.size() != 3) {
        refuse(model, parameter, "'{}' is neither one number nor three with commas", text);
    }
    glm::vec3 color(readNumber(model, parameter, parts[0]));
    if (parts.size() == 3) {
        color.y = readNumber(model, parameter, parts[1]);
        color.z = readNumber(model, parameter, parts[2]);
    }
    return color;
}

}  // namespace

const std::vector<BsdfModelInfo>& bsdfModels() {
    static const std::vector<BsdfModelInfo> models = makeModels();
    return models;
}

const BsdfModelInfo& findBsdfModel(const std::string& name) {
    return findByName(bsdfModels(), "model", name);
}

const BsdfParameterInfo& findBsdfParameter(const BsdfModelInfo& model, const std::string& name) {
    return findByName(model.parameters, fmt::format("parameter of {}", model.name), name);
}

BsdfSettings::BsdfSettings(const BsdfModelInfo& info) : model(&info) {
    for (const BsdfParameterInfo& parameter : info.parameters) values.push_back(parameter.initial);
}

void BsdfSettings::set(const std::string& name, std::string_view text) {
    const BsdfParameterInfo& parameter = findBsdfParameter(*model, name);
    glm::vec3 value(0.0f);
    switch (parameter.type) {
    case BsdfParameterType::number: value = glm::vec3(readNumber(*model, parameter, text)); break;
    case BsdfParameterType::color: value = readColor(*model, parameter, text); break;
    case BsdfParameterType::boolean: value = glm::vec3(readBoolean(*model, parameter, text)); break;
    case BsdfParameterType::choice: value = glm::vec3(readChoice(*model, parameter, text)); break;
    }
    const std::string start = fmt::format("{}: {}: ", model->name, name);
    std::erase_if(notices, [&](const std::string& n) { return n.starts_with(start); });
    const bool ranged = parameter.type == BsdfParameterType::number
                     || parameter.type == BsdfParameterType::color;
    if (ranged && !parameter.mayExceed) {
        const glm::vec3 given = value;
        value = glm::clamp(given, parameter.minimum, parameter.maximum);
        if (value != given) {
            notices.push_back(fmt::format("{}{} is outside of {:g}..{:g}; {} is used", start, text,
                                          parameter.minimum, parameter.maximum,
                                          bsdfValueText(parameter, value)));
        }
    }
    values[static_cast<std::size_t>(&parameter - model->parameters.data())] = value;
}

const glm::vec3* BsdfSettings::valueOfRow(uint32_t row) const {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (model->parameters[i].row == row) return &values[i];
    }
    return nullptr;
}

bool BsdfModelInfo::hasBaseColor() const {
    return std::any_of(parameters.begin(), parameters.end(),
                       [](const BsdfParameterInfo& p) { return p.name == "base_color"; });
}

std::string whyNotBlended(const BsdfSettings& below, const BsdfSettings& above) {
    if (below.model != above.model) {
        return fmt::format("{} cannot be blended over {}: layers are parameters of one model",
                           above.model->name, below.model->name);
    }
    if (below.measured && above.measured && below.measured->name != above.measured->name) {
        return fmt::format("{} is another file than {}, and there is nothing in between",
                           above.measured->name, below.measured->name);
    }
    for (std::size_t i = 0; i < below.values.size(); ++i) {
        const BsdfParameterInfo& p = below.model->parameters[i];
        const bool steps = p.type == BsdfParameterType::boolean
                        || p.type == BsdfParameterType::choice;
        if (steps && below.values[i].x != above.values[i].x) {
            return fmt::format("{} is {} below and {} above, and has nothing in between", p.name,
                               bsdfValueText(p, below.values[i]),
                               bsdfValueText(p, above.values[i]));
        }
    }
    return {};
}

BsdfSettings blended(const BsdfSettings& below, const BsdfSettings& above, float share) {
    BsdfSettings result = below;
    for (std::size_t i = 0; i < result.values.size(); ++i)
        result.values[i] = glm::mix(below.values[i], above.values[i], share);
    return result;
}

std::string bsdfValueText(const BsdfParameterInfo& parameter, const glm::vec3& value) {
    switch (parameter.type) {
    case BsdfParameterType::boolean: return value.x > 0.5f ? "true" : "false";
    case BsdfParameterType::choice: return parameter.choices[static_cast<std::size_t>(value.x)];
    case BsdfParameterType::color:
        if (value.x != value.y || value.x != value.z) {
            return fmt::format("{},{},{}", value.x, value.y, value.z);
        }
        [[fallthrough]];
    case BsdfParameterType::number: break;
    }
    return fmt::format("{}", value.x);
}

}  // namespace gp
