#include <nlohmann/json.hpp>

#include "api/check.h"
#include "scene/bsdf_dialect.h"
#include "scene/bsdf_evaluate.h"
#include "scene/measured_brdf.h"

namespace gp::api {

static_assert(GP_DIALECT_WDAS == int(BsdfDialect::wdas) && GP_DIALECT_BBM == int(BsdfDialect::bbm));

namespace {

using Json = nlohmann::ordered_json;

constexpr size_t valueLimit = size_t(1) << 26;  // 1 GiB of values

Json jsonOf(const BsdfParameterInfo& p, const glm::vec3& value) {
    if (p.type == BsdfParameterType::boolean) return value.x > 0.5f;
    if (p.type == BsdfParameterType::choice) return bsdfValueText(p, value);
    if (p.type == BsdfParameterType::color) return Json::array({value.x, value.y, value.z});
    return value.x;
}

const char* nameOf(BsdfParameterType type) {
    constexpr const char* names[] = {"number", "color", "boolean", "choice"};
    return names[size_t(type)];
}

Json jsonOf(const BsdfParameterInfo& p) {
    Json j = {{"name", p.name}, {"type", nameOf(p.type)}, {"default", jsonOf(p, p.initial)}};
    if (p.type == BsdfParameterType::choice) j["choices"] = p.choices;
    if (p.type == BsdfParameterType::number || p.type == BsdfParameterType::color) {
        j["minimum"] = p.minimum;
        j["maximum"] = p.maximum;
        j["mayExceed"] = p.mayExceed;
    }
    if (!p.unit.empty()) j["unit"] = p.unit;
    j["text"] = p.text;
    return j;
}

Json jsonOf(const BsdfModelInfo& model) {
    Json j = {{"name", model.name},
              {"text", model.text},
              {"reference", model.reference},
              {"reciprocal", model.reciprocal},
              {"conserving", model.conserving},
              {"transmissive", model.transmissive},
              {"fromFile", model.fromFile},
              {"parameters", Json::array()}};
    for (const BsdfParameterInfo& p : model.parameters) j["parameters"].push_back(jsonOf(p));
    return j;
}

std::string describeModels() {
    Json all = Json::array();
    for (const BsdfModelInfo& model : bsdfModels()) all.push_back(jsonOf(model));
    return all.dump(1, ' ', false, Json::error_handler_t::replace);
}

std::string describe(const BsdfSettings& settings) {
    Json parameters = Json::object();
    for (size_t i = 0; i < settings.values.size(); ++i) {
        const BsdfParameterInfo& p = settings.model->parameters[i];
        parameters[p.name] = jsonOf(p, settings.values[i]);
    }
    Json all = {{"model", settings.model->name},
                {"parameters", parameters},
                {"notices", settings.notices}};
    if (settings.measured) all["file"] = settings.measured->name;
    return all.dump(1, ' ', false, Json::error_handler_t::replace);
}

BsdfSettings settingsFrom(const GpBsdfDesc& desc) {
    checkPointer(desc.model, "model");
    const auto dialect = BsdfDialect(checkEnum(desc.dialect, 3, "dialect"));
    if (desc.parameterCount > 0) checkPointer(desc.parameters, "parameters");
    BsdfWords words;
    for (uint32_t i = 0; i < desc.parameterCount; ++i) {
        checkPointer(desc.parameters[i].name, fmt::format("parameters[{}].name", i).c_str());
        checkPointer(desc.parameters[i].value, fmt::format("parameters[{}].value", i).c_str());
        words.emplace_back(desc.parameters[i].name, desc.parameters[i].value);
    }
    try {
        return bsdfFromWords(dialect, desc.model, words);
    } catch (const BsdfError& error) {
        fail(GP_ERROR_INVALID_ARGUMENT, "{}", error.what());
    }
}

// Normalised in double: the float's own error is all that is left.
glm::vec3 directionFrom(const float* all, size_t index, const char* field) {
    const float* v = all + 3 * index;
    checkFinite(v, 3, fmt::format("{}[{}]", field, index));
    if (allZero(v, 3)) fail(GP_ERROR_OUT_OF_RANGE, "{}[{}] has no length", field, index);
    return glm::vec3(glm::normalize(glm::dvec3(vec3From(v))));
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpError gpDescribeBsdfModels(GpDevice device, char* text, size_t size, size_t* needed) {
    return enter("gpDescribeBsdfModels", "device", device,
                 [&](DeviceObject&) { giveText(describeModels(), text, size, needed); });
}

GpBsdf gpNewBsdf(GpDevice device, const GpBsdfDesc* desc) {
    return enter("gpNewBsdf", "device", device, [&](DeviceObject& d) {
        checkPointer(desc, "desc");
        auto object = std::make_shared<BsdfObject>(d);
        object->settings = std::make_unique<const gp::BsdfSettings>(settingsFrom(*desc));
        return publish<GpBsdf>(object);
    });
}

GpError gpReleaseBsdf(GpBsdf bsdf) {
    return enter("gpReleaseBsdf", "bsdf", bsdf,
                 [&](BsdfObject&) { handles().remove(bitsOf(bsdf)); });
}

GpError gpDescribeBsdf(GpBsdf bsdf, char* text, size_t size, size_t* needed) {
    return enter("gpDescribeBsdf", "bsdf", bsdf,
                 [&](BsdfObject& b) { giveText(describe(*b.settings), text, size, needed); });
}

GpError gpEvaluateBsdf(GpBsdf bsdf, size_t count, const float* wi, const float* wo,
                       GpBsdfValue* values) {
    return enter("gpEvaluateBsdf", "bsdf", bsdf, [&](BsdfObject& b) {
        if (count == 0) return;
        if (count > valueLimit)
            fail(GP_ERROR_TOO_LARGE, "count is {}, more than {}", count, valueLimit);
        checkPointer(wi, "wi");
        checkPointer(wo, "wo");
        checkPointer(values, "values");
        std::vector<GpBsdfValue> results(count);  // so that a failed call changes nothing
        for (size_t i = 0; i < count; ++i) {
            const gp::BsdfReading reading = gp::evaluateBsdf(
                *b.settings, directionFrom(wi, i, "wi"), directionFrom(wo, i, "wo"));
            for (int k = 0; k < 3; ++k) results[i].f[k] = reading.f[k];
            results[i].pdf = reading.pdf;
        }
        std::memcpy(values, results.data(), count * sizeof(GpBsdfValue));
    });
}

}  // extern "C"
