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

// A preset is its colours and its widths; of a model by its name those of the file are kept, but
// for what the word sets itself.
std::uint32_t mapsToKeep(GpDevice device, const ModelWord& word) {
    std::uint32_t keep = GP_MAP_ALL;
    bool isModel = false;
    for (const auto& model : describeModels(device)) {
        isModel = isModel || model.at("name") == word.name;
    }
    if (!isModel) {
        keep &= ~std::uint32_t{GP_MAP_BASE_COLOR | GP_MAP_ROUGHNESS | GP_MAP_METALLIC};
    }
    for (const auto& [name, value] : word.parameters) {
        if (name == "base_color") {
            keep &= ~std::uint32_t{GP_MAP_BASE_COLOR};
        }
        if (name == "roughness" || name == "alpha_x" || name == "alpha_y") {
            keep &= ~std::uint32_t{GP_MAP_ROUGHNESS};
        }
    }
    return keep;
}

std::string mapNames(std::uint32_t maps) {
    const std::pair<std::uint32_t, const char*> names[] = {
        {GP_MAP_BASE_COLOR, "base colour"}, {GP_MAP_NORMAL, "normals"},
        {GP_MAP_SLOPES, "slope maps"},      {GP_MAP_ALPHA, "alpha"},
        {GP_MAP_EMISSION, "emission"},      {GP_MAP_ROUGHNESS, "roughness"},
        {GP_MAP_METALLIC, "metal"},         {GP_MAP_OTHERS, "other textures"}};
    std::string text;
    for (const auto& [map, name] : names) {
        if ((maps & map) != 0) {
            text += (text.empty() ? "" : ", ") + std::string(name);
        }
    }
    return text.empty() ? "nothing" : text;
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

std::vector<std::string> replaceMaterials(GpDevice device, GpScene scene,
                                          const std::vector<std::string>& words) {
    std::vector<std::string> notes;
    for (const std::string& text : words) {
        const MaterialWord word = parseMaterialWord(text);
        Material material;
        try {
            material = newMaterial(device, word);
        } catch (const RunError& error) {
            throw UsageError(fmt::format("--material {}: {}", text, error.what()));
        }
        GpReplacedMaterials replaced{};
        check(device, gpReplaceMaterialModel(scene, word.all ? nullptr : word.name.c_str(),
                                             material.get(), mapsToKeep(device, word.model),
                                             &replaced));
        if (replaced.instances == 0 && !word.all) {
            failUnknown(device, scene, word.name);
        }
        if ((replaced.kept | replaced.left) != 0) {
            notes.push_back(fmt::format("--material {}: of the file {} kept, {} left out", text,
                                        mapNames(replaced.kept), mapNames(replaced.left)));
        }
    }
    return notes;
}

}  // namespace gp::tool
