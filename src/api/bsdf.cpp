#include <nlohmann/json.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "api/check.h"
#include "io/bsdf_source.h"
#include "scene/bsdf_evaluate.h"
#include "scene/measured_brdf.h"

namespace gp::api {

static_assert(GP_LOBE_DIFFUSE == int(bsdfLobeDiffuse) && GP_LOBE_GLOSSY == int(bsdfLobeGlossy)
              && GP_LOBE_SPECULAR == int(bsdfLobeSpecular)
              && GP_LOBE_TRANSMISSION == int(bsdfLobeTransmission));
static_assert(GP_DIALECT_WDAS == int(BsdfDialect::wdas) && GP_DIALECT_BBM == int(BsdfDialect::bbm));

namespace {

using Json = nlohmann::ordered_json;

constexpr size_t valueLimit = size_t(1) << 26;  // 1 GiB of values, 2 of samples

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

Json jsonOf(const BsdfSettings& settings) {
    Json parameters = Json::object();
    for (size_t i = 0; i < settings.values.size(); ++i) {
        const BsdfParameterInfo& p = settings.model->parameters[i];
        parameters[p.name] = jsonOf(p, settings.values[i]);
    }
    Json all = {{"model", settings.model->name},
                {"parameters", parameters},
                {"notices", settings.notices}};
    if (settings.measured) all["file"] = settings.measured->name;
    return all;
}

std::string describePresets(const std::vector<io::Preset>& presets) {
    Json all = Json::array();
    for (const io::Preset& preset : presets) {
        Json layers = Json::array();
        for (const io::PresetLayer& layer : preset.layers) {
            Json j = jsonOf(layer.bsdf);
            j["weight"] = layer.weight;
            if (!layer.maskPath.empty()) {
                j["mask"] = layer.maskPath;
                j["channel"] = layer.channel;
            }
            layers.push_back(std::move(j));
        }
        all.push_back({{"name", preset.name},
                       {"title", preset.title},
                       {"group", preset.group},
                       {"reference", preset.reference},
                       {"layers", std::move(layers)}});
    }
    return all.dump(1, ' ', false, Json::error_handler_t::replace);
}

std::string describe(const BsdfSettings& settings) {
    const Json all = jsonOf(settings);
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
        return io::bsdfFromName(dialect, desc.model, words);
    } catch (const BsdfError& error) {
        fail(GP_ERROR_INVALID_ARGUMENT, "{}", error.what());
    }
}

// Every one before any is used, so that the first wrong one is named, whatever the threads do.
void checkDirections(const float* all, size_t count, const char* field) {
    checkPointer(all, field);
    for (size_t i = 0; i < count; ++i) {
        const float* v = all + 3 * i;
        const bool finite = std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
        if (!finite) checkFinite(v, 3, fmt::format("{}[{}]", field, i));
        if (allZero(v, 3)) fail(GP_ERROR_OUT_OF_RANGE, "{}[{}] has no length", field, i);
    }
}

void checkRandomNumbers(const float* u, size_t count) {
    checkPointer(u, "u");
    for (size_t i = 0; i < 3 * count; ++i) {
        if (!(u[i] >= 0.0f && u[i] < 1.0f))
            fail(std::isfinite(u[i]) ? GP_ERROR_OUT_OF_RANGE : GP_ERROR_NOT_FINITE,
                 "u[{}][{}] is {}, which is not at least 0 and below 1", i / 3, i % 3, u[i]);
    }
}

void checkCount(size_t count) {
    if (count > valueLimit)
        fail(GP_ERROR_TOO_LARGE, "count is {}, more than {}", count, valueLimit);
}

// Normalised in double: the float's own error is all that is left.
glm::vec3 directionAt(const float* all, size_t index) {
    return glm::vec3(glm::normalize(glm::dvec3(vec3From(all + 3 * index))));
}

// body(index) for all of them, on the device's threads where there are many.
template <class Body>
void forEachIndex(const BsdfObject& object, size_t count, const Body& body) {
    constexpr size_t grain = 1024;  // some hundred microseconds, as threads take time to wake
    const auto part = [&](const tbb::blocked_range<size_t>& range) {
        for (size_t i = range.begin(); i < range.end(); ++i) body(i);
    };
    const tbb::blocked_range<size_t> all(0, count, grain);
    if (count <= grain) return part(all);
    const uint32_t threads = object.device->threads;
    tbb::task_arena arena(threads > 0 ? int(threads) : tbb::task_arena::automatic);
    arena.execute([&] { tbb::parallel_for(all, part); });
}

// The device is locked: nobody else makes it at the same time.
const PreparedBsdf& preparedOf(BsdfObject& object) {
    if (!object.prepared)
        object.prepared = std::make_unique<const PreparedBsdf>(*object.settings);
    return *object.prepared;
}

GpBsdfValue valueOf(const BsdfReading& reading) {
    return {{reading.f.x, reading.f.y, reading.f.z}, reading.pdf};
}

GpBsdfSample sampleOf(const BsdfDraw& draw) {
    return {{draw.wi.x, draw.wi.y, draw.wi.z}, draw.pdf,
            {draw.weight.x, draw.weight.y, draw.weight.z}, draw.lobe};
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpError gpDescribeBsdfModels(GpDevice device, char* text, size_t size, size_t* needed) {
    return enter("gpDescribeBsdfModels", "device", device,
                 [&](DeviceObject&) { giveText(describeModels(), text, size, needed); });
}

GpError gpDescribePresets(GpDevice device, const char* path, char* text, size_t size,
                          size_t* needed) {
    return enter("gpDescribePresets", "device", device, [&](DeviceObject&) {
        if (path) checkPath(path);
        giveText(describePresets(path ? gp::io::readPresets(path) : gp::io::builtInPresets()),
                 text, size, needed);
    });
}

GpBsdf gpNewBsdf(GpDevice device, const GpBsdfDesc* desc) {
    return enter("gpNewBsdf", "device", device, [&](DeviceObject& d) {
        checkPointer(desc, "desc");
        auto object = std::make_shared<BsdfObject>(d);
        object->settings = std::make_shared<const gp::BsdfSettings>(settingsFrom(*desc));
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
        checkCount(count);
        checkDirections(wi, count, "wi");
        checkDirections(wo, count, "wo");
        checkPointer(values, "values");
        const gp::PreparedBsdf& model = preparedOf(b);
        forEachIndex(b, count, [&](size_t i) {
            values[i] = valueOf(model.evaluate(directionAt(wi, i), directionAt(wo, i)));
        });
    });
}

GpError gpSampleBsdf(GpBsdf bsdf, size_t count, const float* wo, const float* u,
                     GpBsdfSample* samples) {
    return enter("gpSampleBsdf", "bsdf", bsdf, [&](BsdfObject& b) {
        if (count == 0) return;
        checkCount(count);
        checkDirections(wo, count, "wo");
        checkRandomNumbers(u, count);
        checkPointer(samples, "samples");
        const gp::PreparedBsdf& model = preparedOf(b);
        forEachIndex(b, count, [&](size_t i) {
            samples[i] = sampleOf(model.sample(directionAt(wo, i), vec3From(u + 3 * i)));
        });
    });
}

}  // extern "C"
