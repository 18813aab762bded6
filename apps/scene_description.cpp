#include "scene_description.h"

#include <algorithm>
#include <string>

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;

bool isLamp(const Json& material) {
    float strongest = 0;
    for (const Json& channel : material.at("emission")) {
        strongest = std::max(strongest, channel.get<float>());
    }
    const bool textured =
        material.contains("textures") && material["textures"].contains("emission");
    return strongest > (textured ? 1.0f : 0.0f);
}

}  // namespace

Json describeScene(GpDevice device, GpScene scene) {
    std::size_t size = 0;
    check(device, gpDescribeScene(scene, nullptr, 0, &size));
    std::string text(size, '\0');
    check(device, gpDescribeScene(scene, text.data(), text.size(), nullptr));
    return Json::parse(text.c_str());
}

bool isDark(GpDevice device, GpScene scene) {
    GpSceneInfo info{};
    check(device, gpGetSceneInfo(scene, &info));
    if (info.lights > 0 || info.hasEnvironment != 0) {
        return false;
    }
    if (info.emissiveTriangles == 0) {
        return true;
    }
    const Json description = describeScene(device, scene);
    const Json& materials = description.at("materials");
    return std::none_of(materials.begin(), materials.end(), isLamp);
}

}  // namespace gp::tool
