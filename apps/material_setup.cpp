#include "material_setup.h"

#include <fmt/format.h>

#include "brdf/models.h"
#include "nearest_word.h"
#include "scene_description.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Material = Owner<GpMaterialImpl, &gpReleaseMaterial>;

struct MaterialWord {
    std::string name;  // of the scene's material
    bool all = false;
    ModelWord model;
};

// The "=" of a parameter comes behind the ":" of a model.
MaterialWord parseMaterialWord(const std::string& word) {
    const std::size_t equals = word.find('=');
    MaterialWord result;
    result.all = equals == std::string::npos || equals > word.find(':');
    if (!result.all) {
        result.name = word.substr(0, equals);
    }
    result.model = parseModelWord(result.all ? word : word.substr(equals + 1));
    return result;
}

// By its name alone a preset brings its masks; with parameters it is one set of them.
Material newMaterial(GpDevice device, const MaterialWord& word) {
    GpMaterialDesc desc{};
    desc.name = word.name.empty() ? word.model.name.c_str() : word.name.c_str();
    Bsdf bsdf;
    if (word.model.parameters.empty()) {
        desc.preset = word.model.name.c_str();
    } else {
        bsdf = newBsdf(device, word.model.name, GP_DIALECT_OWN, word.model.parameters);
        desc.bsdf = bsdf.get();
        for (const auto& notice : describeBsdf(device, bsdf).at("notices")) {
            fmt::print(stderr, "glitterpath: note: {}\n", notice.get<std::string>());
        }
    }
    Material material(gpNewMaterial(device, &desc));
    if (!material) {
        check(device, GP_ERROR_UNKNOWN);
    }
    return material;
}

[[noreturn]] void failUnknown(GpDevice device, GpScene scene, const std::string& name) {
    std::vector<std::string> names;
    for (const auto& material : describeScene(device, scene).at("materials")) {
        names.push_back(material.at("name").get<std::string>());
    }
    const std::string nearest = nearestWord(name, names);
    throw UsageError(fmt::format(
        "--material: the scene has no material '{}' ({})", name,
        nearest.empty() ? "`glitterpath info` lists them" : "did you mean " + nearest + "?"));
}

}  // namespace

void replaceMaterials(GpDevice device, GpScene scene, const std::vector<std::string>& words) {
    for (const std::string& text : words) {
        const MaterialWord word = parseMaterialWord(text);
        Material material;
        try {
            material = newMaterial(device, word);
        } catch (const RunError& error) {
            throw UsageError(fmt::format("--material {}: {}", text, error.what()));
        }
        std::uint32_t replaced = 0;
        check(device, gpReplaceMaterial(scene, word.all ? nullptr : word.name.c_str(),
                                        material.get(), &replaced));
        if (replaced == 0 && !word.all) {
            failUnknown(device, scene, word.name);
        }
    }
}

}  // namespace gp::tool
