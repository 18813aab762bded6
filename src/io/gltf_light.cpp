#include "io/gltf_light.h"

#include <cmath>

namespace gp::io {

namespace {

constexpr float lumenPerWatt = 683;  // how photometric inputs become radiometric ones
constexpr float pi = 3.14159265358979f;

// The direction of an axis of the node in the world; `fallback` where its scale is zero.
glm::vec3 axis(const Node& node, int column, glm::vec3 fallback) {
    const glm::vec3 v(node.worldFromNode[column]);
    const float length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : fallback;
}

}  // namespace

void placeLight(const Node& node, Light& light) {
    light.position = glm::vec3(node.worldFromNode[3]);
    light.direction = -axis(node, 2, {0, 0, 1});  // glTF lights shine along -Z
}

void placeCamera(const Node& node, Camera& camera) {
    camera.position = glm::vec3(node.worldFromNode[3]);
    camera.target = camera.position - axis(node, 2, {0, 0, 1});
    camera.up = axis(node, 1, {0, 1, 0});
}

std::shared_ptr<Light> readLight(Document& document, const Node& node) {
    const Value all = document.root()["extensions"]["KHR_lights_punctual"]["lights"];
    if (*node.light >= all.size())
        all.fail("there is no light " + std::to_string(*node.light));
    const Value value = all.at(*node.light);
    auto light = std::make_shared<Light>();
    light->id = node.pathHash ^ 0x6c69676874ull;  // "light": the node's own id is its mesh's
    light->name = value.text("name", node.name);
    light->emission = value.vec<3>("color", glm::vec3(1)) *
                      std::max(value.real("intensity", 1), 0.0f) / lumenPerWatt;
    placeLight(node, *light);
    const std::string type = value["type"].asText();
    if (type == "directional") {
        light->kind = LightKind::directional;
    } else if (type == "point") {
        light->kind = LightKind::sphere;
    } else if (type == "spot") {
        light->kind = LightKind::spot;
        float inner = 0, outer = pi / 4;
        if (const auto spot = value.find("spot")) {
            inner = spot->real("innerConeAngle", inner);
            outer = spot->real("outerConeAngle", outer);
        }
        if (!(inner >= 0 && inner <= outer && outer <= pi / 2 + 1e-4f && outer > 0))
            value.fail("cone angles must satisfy 0 <= inner <= outer <= pi/2");
        light->cosInner = std::cos(inner);
        light->cosOuter = std::max(std::cos(outer), 0.0f);
    } else {
        value.fail("unknown type of light '" + type.substr(0, 20) + "'");
    }
    return light;
}

Camera readCamera(Document& document, const Node& node) {
    const Value value = document.element("cameras", *node.camera);
    Camera c;
    c.name = value.text("name", node.name);
    if (c.name.empty()) c.name = "camera " + std::to_string(*node.camera);
    placeCamera(node, c);
    const std::string type = value["type"].asText();
    if (type == "perspective") {
        c.verticalFov = value["perspective"].real("yfov", 0);
        if (!(c.verticalFov > 0 && c.verticalFov < pi))
            value.fail("yfov must be between 0 and pi");
    } else if (type == "orthographic") {
        c.kind = CameraKind::orthographic;
        c.orthographicHeight = 2 * std::abs(value["orthographic"].real("ymag", 0));
        if (!(c.orthographicHeight > 0)) value.fail("ymag must not be zero");
    } else {
        value.fail("unknown type of camera '" + type.substr(0, 20) + "'");
    }
    return c;
}

}  // namespace gp::io
