#include "reflectance.h"

#include <cmath>

#include "parse.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;

// A text of the library: first its size, then itself.
template <class Call>
Json readDescription(GpDevice device, const Call& call) {
    std::size_t size = 0;
    check(device, call(nullptr, 0, &size));
    std::string text(size, '\0');
    check(device, call(text.data(), text.size(), nullptr));
    return Json::parse(text.c_str());
}

// To unit length before the conversion to float, so that long ones keep their direction.
std::array<float, 3> unit(const Direction& d) {
    const double largest = std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
    if (!(largest > 0)) {
        throw RunError("a direction has no length");
    }
    const double x = d[0] / largest, y = d[1] / largest, z = d[2] / largest;
    const double length = std::sqrt(x * x + y * y + z * z);
    return {static_cast<float>(x / length), static_cast<float>(y / length),
            static_cast<float>(z / length)};
}

}  // namespace

Device newModelDevice() {
    GpDeviceDesc desc{};
    desc.backend = GP_BACKEND_NULL;
    return newDevice(desc);
}

Bsdf newBsdf(GpDevice device, const std::string& model, GpBsdfDialect dialect,
             const ParameterWords& parameters) {
    std::vector<GpBsdfParameter> list;
    for (const auto& [name, value] : parameters) {
        list.push_back({name.c_str(), value.c_str()});
    }
    GpBsdfDesc desc{};
    desc.model = model.c_str();
    desc.dialect = dialect;
    desc.parameters = list.data();
    desc.parameterCount = static_cast<std::uint32_t>(list.size());
    Bsdf bsdf(gpNewBsdf(device, &desc));
    if (!bsdf) {
        check(device, GP_ERROR_UNKNOWN);
    }
    return bsdf;
}

Json describeModels(GpDevice device) {
    return readDescription(device, [&](char* text, std::size_t size, std::size_t* needed) {
        return gpDescribeBsdfModels(device, text, size, needed);
    });
}

Json describePresets(GpDevice device, const std::string& path) {
    return readDescription(device, [&](char* text, std::size_t size, std::size_t* needed) {
        return gpDescribePresets(device, path.empty() ? nullptr : path.c_str(), text, size, needed);
    });
}

Json describeBsdf(GpDevice device, const Bsdf& bsdf) {
    return readDescription(device, [&](char* text, std::size_t size, std::size_t* needed) {
        return gpDescribeBsdf(bsdf.get(), text, size, needed);
    });
}

GpBsdfValue evaluate(GpDevice device, const Bsdf& bsdf, const Direction& wi, const Direction& wo) {
    const std::array<float, 3> i = unit(wi), o = unit(wo);
    GpBsdfValue value{};
    check(device, gpEvaluateBsdf(bsdf.get(), 1, i.data(), o.data(), &value));
    return value;
}

std::vector<GpBsdfValue> evaluate(GpDevice device, const Bsdf& bsdf,
                                  const std::vector<glm::vec3>& wi,
                                  const std::vector<glm::vec3>& wo) {
    std::vector<GpBsdfValue> values(wi.size());
    if (!wi.empty()) {
        check(device, gpEvaluateBsdf(bsdf.get(), wi.size(), &wi[0].x, &wo[0].x,
                                     values.data()));
    }
    return values;
}

std::vector<GpBsdfSample> sample(GpDevice device, const Bsdf& bsdf,
                                 const std::vector<glm::vec3>& wo,
                                 const std::vector<glm::vec3>& u) {
    std::vector<GpBsdfSample> samples(wo.size());
    if (!wo.empty()) {
        check(device, gpSampleBsdf(bsdf.get(), wo.size(), &wo[0].x, &u[0].x, samples.data()));
    }
    return samples;
}

GpBsdfDialect parseDialect(const std::string& word) {
    constexpr std::pair<const char*, GpBsdfDialect> choices[] = {
        {"own", GP_DIALECT_OWN}, {"wdas", GP_DIALECT_WDAS}, {"bbm", GP_DIALECT_BBM}};
    return parseChoice("--dialect", word, choices);
}

}  // namespace gp::tool
