// A scene in words.
#pragma once

#include <string>

#include "scene/scene.h"

namespace gp::api {

std::string describeScene(const Scene& scene);  // JSON

// Calls visit(name, use) for every texture that a material may have.
template <class F>
void forEachTexture(const Material& m, F&& visit) {
    visit("baseColor", m.baseColorTexture);
    visit("metallicRoughness", m.metallicRoughnessTexture);
    visit("normal", m.normalTexture);
    visit("emission", m.emissionTexture);
    visit("specular", m.specularTexture);
    visit("specularColor", m.specularColorTexture);
    visit("coat", m.coatTexture);
    visit("coatRoughness", m.coatRoughnessTexture);
    visit("coatNormal", m.coatNormalTexture);
    visit("sheenColor", m.sheenColorTexture);
    visit("sheenRoughness", m.sheenRoughnessTexture);
    visit("transmission", m.transmissionTexture);
    visit("anisotropy", m.anisotropyTexture);
    visit("iridescence", m.iridescenceTexture);
    visit("iridescenceThickness", m.iridescenceThicknessTexture);
    constexpr const char* layerNames[] = {"layer1", "layer2"};
    for (size_t i = 0; i < m.textureLayers.size(); ++i)
        visit(layerNames[i], m.textureLayers[i].texture);
    constexpr const char* slopeNames[] = {"slopes1", "slopes2", "slopes3", "slopes4"};
    for (size_t i = 0; i < m.slopeMaps.size(); ++i) visit(slopeNames[i], m.slopeMaps[i].texture);
}

}  // namespace gp::api
