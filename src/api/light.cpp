#include <algorithm>
#include <numbers>

#include "api/check.h"
#include "api/scenes.h"
#include "scene/polygon.h"

namespace gp::api {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double lumensPerWatt = 683;  // of the header's UNITS

static_assert(GP_LIGHT_SPHERE == int(LightKind::sphere) && GP_LIGHT_SPOT == int(LightKind::spot) &&
              GP_LIGHT_RECTANGLE == int(LightKind::rectangle) &&
              GP_LIGHT_POLYGON == int(LightKind::polygon));

constexpr uint32_t cornerLimit = 1024;

// What one unit of power makes of this light: radiant intensity, or radiance of a flat one.
double perWatt(const Light& light, double area) {
    if (area == 0) return 1 / (4 * pi);
    return 1 / (pi * area * (light.twoSided ? 2 : 1));
}

// area: of a flat light, else 0.
void readEmission(Light& light, const GpLightDesc& desc, double area) {
    checkNotNegative(desc.color, 3, "color");
    checkNotNegative(desc.intensity, "intensity");
    const uint32_t unit = checkEnum(desc.unit, 4, "unit");
    const bool power = unit == GP_UNIT_POWER_W || unit == GP_UNIT_POWER_LM;
    if (power && light.kind == LightKind::directional)
        fail(GP_ERROR_INVALID_ARGUMENT, "unit is a power, which a directional light does not have");
    double scale = desc.intensity;
    if (unit == GP_UNIT_PHOTOMETRIC || unit == GP_UNIT_POWER_LM) scale /= lumensPerWatt;
    if (power) scale *= perWatt(light, area);
    const glm::dvec3 color(allZero(desc.color, 3) ? glm::vec3(1) : vec3From(desc.color));
    light.emission = glm::vec3(color * scale);
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(light.emission[i]))
            fail(GP_ERROR_OUT_OF_RANGE, "intensity times color[{}] leaves the range of floats", i);
}

void readDirection(Light& light, const GpLightDesc& desc) {
    checkFinite(desc.direction, 3, "direction");
    light.direction = {0, -1, 0};
    if (!allZero(desc.direction, 3))
        light.direction = glm::vec3(glm::normalize(glm::dvec3(vec3From(desc.direction))));
}

void readCone(Light& light, const GpLightDesc& desc) {
    const float outer = desc.outerAngle == 0 ? float(pi / 4) : desc.outerAngle;
    checkRange(outer, 0, float(pi / 2), "outerAngle");
    checkRange(desc.innerAngle, 0, outer, "innerAngle");
    light.cosInner = std::cos(desc.innerAngle);
    light.cosOuter = std::max(0.0f, std::cos(outer));
}

double readEdges(Light& light, const GpLightDesc& desc) {
    checkFinite(desc.edgeU, 3, "edgeU");
    checkFinite(desc.edgeV, 3, "edgeV");
    light.edgeU = vec3From(desc.edgeU);
    light.edgeV = vec3From(desc.edgeV);
    const double u = glm::length(glm::dvec3(light.edgeU)), v = glm::length(glm::dvec3(light.edgeV));
    const double area = glm::length(glm::cross(glm::dvec3(light.edgeU), glm::dvec3(light.edgeV)));
    if (!(area > 1e-6 * u * v) || float(area) < 1e-30f)
        fail(GP_ERROR_OUT_OF_RANGE, "edgeU and edgeV span no area");
    if (!std::isfinite(float(area))) fail(GP_ERROR_OUT_OF_RANGE, "edgeU and edgeV are too long");
    light.twoSided = desc.twoSided != 0;
    return area;
}

double readCorners(Light& light, const GpLightDesc& desc) {
    if (desc.cornerCount < 3)
        fail(GP_ERROR_INVALID_ARGUMENT, "cornerCount is {}, but a polygon has 3 or more",
             desc.cornerCount);
    if (desc.cornerCount > cornerLimit)
        fail(GP_ERROR_TOO_LARGE, "cornerCount is {}, more than {}", desc.cornerCount, cornerLimit);
    checkPointer(desc.corners, "corners");
    checkFinite(desc.corners, size_t(desc.cornerCount) * 3, "corners");
    std::vector<glm::vec3> corners;
    for (uint32_t i = 0; i < desc.cornerCount; ++i)
        corners.push_back(vec3From(desc.corners + size_t(i) * 3));
    Polygon polygon;
    if (const std::string why = makePolygon(corners, polygon); !why.empty())
        fail(GP_ERROR_OUT_OF_RANGE, "{}", why);
    light.corners = std::move(polygon.corners);
    light.direction = polygon.normal;
    light.twoSided = desc.twoSided != 0;
    return polygon.area;
}

// Fields of other kinds of light do not count, and so are not looked at.
Light lightFrom(const GpLightDesc& desc) {
    Light light;
    light.id = desc.id;
    light.name = nameOr(desc.name);
    light.kind = LightKind(checkEnum(desc.kind, 5, "kind"));
    light.visible = !desc.invisible;
    const bool directional = light.kind == LightKind::directional;
    const bool round = light.kind == LightKind::sphere || light.kind == LightKind::spot;
    if (!directional && light.kind != LightKind::polygon) {
        checkFinite(desc.position, 3, "position");
        light.position = vec3From(desc.position);
    }
    if (directional || light.kind == LightKind::spot) readDirection(light, desc);
    if (directional) {
        checkRange(desc.angularRadius, 0, float(pi / 2), "angularRadius");
        light.angularRadius = desc.angularRadius;
    }
    if (round) {
        checkNotNegative(desc.radius, "radius");
        light.radius = desc.radius;
    }
    if (light.kind == LightKind::spot) readCone(light, desc);
    double area = 0;
    if (light.kind == LightKind::rectangle) area = readEdges(light, desc);
    if (light.kind == LightKind::polygon) area = readCorners(light, desc);
    readEmission(light, desc, area);
    return light;
}

GpLight addLight(SceneObject& scene, Light&& light) {
    const uint64_t id = light.id;
    if (id != 0 && scene.lightIds.contains(id))
        fail(GP_ERROR_DUPLICATE_ID, "id {} belongs to another light of the scene", id);
    auto object = std::make_shared<LightObject>(*scene.device);
    object->scene = std::static_pointer_cast<SceneObject>(scene.shared_from_this());
    object->light = std::make_shared<Light>(std::move(light));
    const gp::Light* added = object->light.get();
    scene.lightPlaces[added] = scene.scene.lights.size();
    Undo undoPlace([&] { scene.lightPlaces.erase(added); });
    scene.scene.lights.push_back(object->light);
    Undo undoList([&] { scene.scene.lights.pop_back(); });
    if (id != 0) scene.lightIds.insert(id);
    Undo undoId([&] { scene.lightIds.erase(id); });
    const GpLight handle = publish<GpLight>(std::move(object));
    undoPlace.keep();
    undoList.keep();
    undoId.keep();
    ++scene.scene.revision;
    return handle;
}

// Only what its kind has; the rest stays zero.
GpLightDesc descOf(const Light& light) {
    GpLightDesc desc{};
    desc.id = light.id;
    desc.kind = GpLightKind(light.kind);
    desc.intensity = std::max({light.emission.x, light.emission.y, light.emission.z});
    desc.invisible = !light.visible;
    desc.name = light.name.c_str();
    const bool flat = light.kind == LightKind::rectangle || light.kind == LightKind::polygon;
    const bool spot = light.kind == LightKind::spot;
    const bool directional = light.kind == LightKind::directional;
    for (int i = 0; i < 3; ++i) {
        desc.color[i] = desc.intensity > 0 ? light.emission[i] / desc.intensity : 1.0f;
        if (!directional && light.kind != LightKind::polygon) desc.position[i] = light.position[i];
        if (directional || spot) desc.direction[i] = light.direction[i];
        if (light.kind == LightKind::rectangle)
            desc.edgeU[i] = light.edgeU[i], desc.edgeV[i] = light.edgeV[i];
    }
    desc.radius = light.radius;
    desc.angularRadius = light.angularRadius;
    if (spot) {
        desc.outerAngle = std::acos(light.cosOuter);
        desc.innerAngle = std::min(std::acos(light.cosInner), desc.outerAngle);
    }
    desc.twoSided = flat && light.twoSided;
    if (!light.corners.empty()) desc.corners = &light.corners[0].x;
    desc.cornerCount = uint32_t(light.corners.size());
    return desc;
}

// Another handle may have removed it, or a new sky its sun.
void checkInScene(const LightObject& object) {
    if (!object.light->inScene)
        fail(GP_ERROR_INVALID_OPERATION, "the light is no longer in its scene");
}

// The last light moves to its place: with 100,000 of them, closing each gap would take seconds.
void takeOut(SceneObject& scene, const std::shared_ptr<Light>& light) {
    auto& lights = scene.scene.lights;
    const auto known = scene.lightPlaces.find(light.get());
    size_t place = known == scene.lightPlaces.end() ? lights.size() : known->second;
    if (place >= lights.size() || lights[place] != light)  // a sky or a file came in between
        place = size_t(std::find(lights.begin(), lights.end(), light) - lights.begin());
    scene.lightPlaces.erase(light.get());
    if (place + 1 < lights.size()) {
        lights[place] = std::move(lights.back());
        scene.lightPlaces[lights[place].get()] = place;
    }
    lights.pop_back();
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpLight gpNewLight(GpScene scene, const GpLightDesc* desc) {
    return enter("gpNewLight", "scene", scene, [&](SceneObject& s) {
        checkPointer(desc, "desc");
        return addLight(s, lightFrom(*desc));
    });
}

GpError gpSetLight(GpLight light, const GpLightDesc* desc) {
    return enter("gpSetLight", "light", light, [&](LightObject& object) {
        checkPointer(desc, "desc");
        checkInScene(object);
        gp::Light changed = lightFrom(*desc);
        changed.id = object.light->id;
        changed.ofSky = object.light->ofSky;
        *object.light = std::move(changed);
        ++object.scene->scene.revision;
    });
}

GpError gpRemoveLight(GpLight light) {
    return enter("gpRemoveLight", "light", light, [&](LightObject& object) {
        checkInScene(object);
        object.light->inScene = false;
        object.scene->lightIds.erase(object.light->id);
        takeOut(*object.scene, object.light);
        ++object.scene->scene.revision;
        handles().remove(bitsOf(light));
    });
}

GpError gpReleaseLight(GpLight light) {
    return enter("gpReleaseLight", "light", light,
                 [&](LightObject&) { handles().remove(bitsOf(light)); });
}

GpError gpGetSceneLight(GpScene scene, uint32_t index, GpLightDesc* desc, GpLight* light) {
    return enter("gpGetSceneLight", "scene", scene, [&](SceneObject& s) {
        checkPointer(desc, "desc");
        const auto& lights = s.scene.lights;
        if (index >= lights.size())
            fail(GP_ERROR_OUT_OF_RANGE, "index is {}, but the scene has {} lights", index,
                 lights.size());
        if (light) {
            auto object = std::make_shared<LightObject>(*s.device);
            object->scene = std::static_pointer_cast<SceneObject>(s.shared_from_this());
            object->light = lights[index];
            *light = publish<GpLight>(std::move(object));
        }
        *desc = descOf(*lights[index]);
    });
}

}  // extern "C"
