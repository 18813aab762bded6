#include "view/scene_lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "library.h"
#include "parse.h"
#include "tool_error.h"

namespace gp::tool::view {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
// Of `reach`: as large as a bulb in a room, so that shadows are soft, but not much.
constexpr float kNewRadius = 0.02f;
constexpr float kNewSide = 0.25f;
// Irradiance of a new light at `reach`, W/m^2; and of a new sun.
constexpr float kNewIrradiance = 3.0f;
constexpr double kMostIntensity = 1.0e12;

bool isRound(GpLightKind kind) {
    return kind == GP_LIGHT_SPHERE || kind == GP_LIGHT_SPOT;
}

bool isFlat(GpLightKind kind) {
    return kind == GP_LIGHT_RECTANGLE || kind == GP_LIGHT_POLYGON;
}

bool hasDirection(GpLightKind kind) {
    return kind == GP_LIGHT_DIRECTIONAL || kind == GP_LIGHT_SPOT;
}

void setTriple(float* to, const std::string& field, const std::string& value, bool isColor) {
    const std::array<float, 3> numbers = parseTriple(field, value);
    const bool isZero = numbers == std::array<float, 3>{};
    if (isColor && *std::min_element(numbers.begin(), numbers.end()) < 0) {
        throw UsageError(fmt::format("{}: {} is negative", field, value));
    }
    if (!isColor && field == "direction" && isZero) {
        throw UsageError(fmt::format("{}: 0,0,0 leads nowhere", field));
    }
    std::copy(numbers.begin(), numbers.end(), to);
}

float parseDegrees(const std::string& field, const std::string& value) {
    return static_cast<float>(parseNumber(field, value, 0, 90) * kRadiansPerDegree);
}

void setOn(SceneLight& light, const std::string& field, const std::string& value) {
    const std::pair<const char*, bool> words[] = {{"on", true}, {"off", false}};
    light.isOn = parseChoice(field, value, words);
}

// An edge of a rectangle gets this length.
void setEdge(float* edge, const std::string& field, const std::string& value) {
    scaleEdge(edge, static_cast<float>(parseNumberFrom(field, value, 0, true)));
}

struct Field {
    const char* name;
    bool (*belongsTo)(GpLightKind);
    void (*set)(SceneLight&, const std::string& field, const std::string& value);
};

using Text = const std::string&;

const Field kFields[] = {
    {"on", [](GpLightKind) { return true; }, setOn},
    {"color", [](GpLightKind) { return true; },
     [](SceneLight& l, Text f, Text v) { setTriple(l.desc.color, f, v, true); }},
    {"intensity", [](GpLightKind) { return true; },
     [](SceneLight& l, Text f, Text v) {
         l.desc.intensity = static_cast<float>(parseNumber(f, v, 0, kMostIntensity));
     }},
    {"position", [](GpLightKind k) { return isRound(k) || k == GP_LIGHT_RECTANGLE; },
     [](SceneLight& l, Text f, Text v) { setTriple(l.desc.position, f, v, false); }},
    {"direction", hasDirection,
     [](SceneLight& l, Text f, Text v) { setTriple(l.desc.direction, f, v, false); }},
    {"radius", isRound,
     [](SceneLight& l, Text f, Text v) {
         l.desc.radius = static_cast<float>(parseNumber(f, v, 0, 1.0e6));
     }},
    {"angular-radius", [](GpLightKind k) { return k == GP_LIGHT_DIRECTIONAL; },
     [](SceneLight& l, Text f, Text v) { l.desc.angularRadius = parseDegrees(f, v); }},
    {"cone", [](GpLightKind k) { return k == GP_LIGHT_SPOT; },
     [](SceneLight& l, Text f, Text v) {
         // 0 would be the default.
         l.desc.outerAngle = std::max(parseDegrees(f, v), 1.0e-3f);
         l.desc.innerAngle = std::min(l.desc.innerAngle, l.desc.outerAngle);
     }},
    {"width", [](GpLightKind k) { return k == GP_LIGHT_RECTANGLE; },
     [](SceneLight& l, Text f, Text v) { setEdge(l.desc.edgeU, f, v); }},
    {"height", [](GpLightKind k) { return k == GP_LIGHT_RECTANGLE; },
     [](SceneLight& l, Text f, Text v) { setEdge(l.desc.edgeV, f, v); }}};

}  // namespace

float edgeLength(const float* edge) {
    return std::hypot(edge[0], edge[1], edge[2]);
}

void scaleEdge(float* edge, float length) {
    const float factor = length / edgeLength(edge);
    std::for_each(edge, edge + 3, [factor](float& v) { v *= factor; });
}

GpLightDesc SceneLight::shown() const {
    GpLightDesc result = desc;
    result.name = name.c_str();
    result.corners = corners.empty() ? nullptr : corners.data();
    result.intensity = isOn ? desc.intensity : 0.0f;
    // Three zeros would be white.
    if (std::all_of(desc.color, desc.color + 3, [](float c) { return c == 0.0f; })) {
        result.intensity = 0.0f;
    }
    // What it is switched off for must not be seen as a black ball.
    result.invisible = desc.invisible != 0 || result.intensity == 0.0f ? 1 : 0;
    return result;
}

bool operator==(const SceneLight& a, const SceneLight& b) {
    const auto same = [](const float (&x)[3], const float (&y)[3]) {
        return std::equal(x, x + 3, y);
    };
    const GpLightDesc& p = a.desc;
    const GpLightDesc& q = b.desc;
    return a.isOn == b.isOn && a.isRemoved == b.isRemoved && p.kind == q.kind &&
           same(p.color, q.color) && p.intensity == q.intensity && same(p.position, q.position) &&
           same(p.direction, q.direction) && p.radius == q.radius &&
           p.angularRadius == q.angularRadius && p.innerAngle == q.innerAngle &&
           p.outerAngle == q.outerAngle && same(p.edgeU, q.edgeU) && same(p.edgeV, q.edgeV);
}

SceneLights sceneLights(GpDevice device, GpScene scene, std::uint32_t count) {
    auto lights = std::make_shared<std::vector<SceneLight>>();
    for (std::uint32_t i = 0; i < count; ++i) {
        SceneLight light;
        check(device, gpGetSceneLight(scene, i, &light.desc, nullptr));
        light.name = light.desc.name;
        if (light.desc.cornerCount > 0) {
            light.corners.assign(light.desc.corners,
                                 light.desc.corners + 3 * light.desc.cornerCount);
        }
        light.desc.name = nullptr;
        light.desc.corners = nullptr;
        lights->push_back(std::move(light));
    }
    return lights;
}

SceneLight newSceneLight(GpLightKind kind, const GpCameraDesc& camera, float reach) {
    SceneLight light;
    light.isOurs = true;
    light.name = "added";
    GpLightDesc& d = light.desc;
    d.kind = kind;
    d.invisible = 1;  // the camera stands in it
    std::fill_n(d.color, 3, 1.0f);
    std::copy_n(camera.position, 3, d.position);
    for (int i = 0; i < 3; ++i) {
        d.direction[i] = camera.target[i] - camera.position[i];
    }
    if (kind == GP_LIGHT_DIRECTIONAL) {
        d.intensity = kNewIrradiance;
        d.angularRadius = 0.00465f;  // the sun's
    } else if (isRound(kind)) {
        d.intensity = kNewIrradiance * reach * reach;
        d.radius = kNewRadius * reach;
        d.innerAngle = static_cast<float>(20 * kRadiansPerDegree);
        d.outerAngle = static_cast<float>(30 * kRadiansPerDegree);
    } else {
        // Shines down: U x V is -Y.
        const float side = kNewSide * reach;
        d.edgeU[0] = side;
        d.edgeV[2] = side;
        d.position[0] -= 0.5f * side;
        d.position[2] -= 0.5f * side;
        d.intensity = kNewIrradiance / (kNewSide * kNewSide);
    }
    return light;
}

const char* intensityUnit(GpLightKind kind) {
    return kind == GP_LIGHT_DIRECTIONAL ? "W/m2" : isFlat(kind) ? "W/m2 sr" : "W/sr";
}

void setLightField(SceneLight& light, const std::string& field, const std::string& value) {
    std::vector<std::string> names;
    for (const Field& known : kFields) {
        if (!known.belongsTo(light.desc.kind)) {
            continue;
        }
        if (field == known.name) {
            known.set(light, field, value);
            return;
        }
        names.emplace_back(known.name);
    }
    failChoice("light", field, names);
}

}  // namespace gp::tool::view
