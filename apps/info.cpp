// glitterpath info: what is in a scene file.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands.h"
#include "library.h"
#include "output.h"
#include "scene_description.h"
#include "scene_setup.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNotes =
    "--json prints everything, object by object (instances, meshes, materials, textures, lights,\n"
    "cameras, animations, warnings), after the totals.\n\n"
    "Examples:\n"
    "  glitterpath info helmet.glb\n"
    "  glitterpath info helmet.glb --json helmet.json";

// A scene of thousands of materials is not read line by line.
constexpr std::size_t kMaxRows = 40;

struct InfoSettings {
    std::string scenePath, jsonPath;
    bool json = false;
    GpLoadOptions load{};
};

Json totalsJson(const GpSceneInfo& i) {
    Json json;
    json["meshes"] = i.meshes;
    json["triangles"] = i.triangles;
    json["instances"] = i.instances;
    json["instanced_triangles"] = i.instancedTriangles;
    json["materials"] = i.materials;
    json["textures"] = i.textures;
    json["texture_bytes"] = i.textureBytes;
    json["geometry_bytes"] = i.geometryBytes;
    json["lights"] = i.lights;
    json["emissive_triangles"] = i.emissiveTriangles;
    json["cameras"] = i.cameras;
    json["has_environment"] = i.hasEnvironment != 0;
    json["bounds_min"] = {i.boundsMin[0], i.boundsMin[1], i.boundsMin[2]};
    json["bounds_max"] = {i.boundsMax[0], i.boundsMax[1], i.boundsMax[2]};
    return json;
}

Json allJson(const std::string& path, const GpSceneInfo& info, const Json& description) {
    Json json;
    json["file"] = path;
    json["totals"] = totalsJson(info);
    json.update(description);
    return json;
}

std::string grouped(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t i = digits.size(); i > 3; i -= 3) {
        digits.insert(i - 3, 1, ',');
    }
    return digits;
}

std::string totalsText(const std::string& path, const GpSceneInfo& i) {
    std::string text = path + "\n";
    const auto row = [&text](const char* label, const std::string& value) {
        text += fmt::format("  {:<14}{}\n", label, value);
    };
    row("meshes", fmt::format("{}, {} triangles, {}", grouped(i.meshes), grouped(i.triangles),
                              bytesText(static_cast<double>(i.geometryBytes))));
    row("instances", fmt::format("{}, {} triangles", grouped(i.instances),
                                 grouped(i.instancedTriangles)));
    row("materials", grouped(i.materials));
    row("textures", fmt::format("{}, {}", grouped(i.textures),
                                bytesText(static_cast<double>(i.textureBytes))));
    row("lights", fmt::format("{}, emissive triangles {}", grouped(i.lights),
                              grouped(i.emissiveTriangles)));
    row("environment", i.hasEnvironment != 0 ? "yes" : "none");
    row("cameras", grouped(i.cameras));
    const float* a = i.boundsMin;
    const float* b = i.boundsMax;
    row("bounds", fmt::format("({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g}) m", a[0], a[1],
                              a[2], b[0], b[1], b[2]));
    return text;
}

std::string nameOf(const Json& object) {
    if (object.is_string()) {
        return object.get<std::string>();
    }
    const std::string name = object.is_object() ? object.value("name", "") : "";
    return name.empty() ? "(no name)" : name;
}

std::string cameraFacts(const Json& camera) {
    if (camera.contains("verticalFov")) {
        return fmt::format("perspective, {:.1f} degrees high",
                           camera["verticalFov"].get<double>() * 180.0 / 3.14159265358979);
    }
    return camera.value("kind", "");
}

std::string materialFacts(const Json& material) {
    std::string facts = fmt::format("metallic {:.2g}, roughness {:.2g}",
                                    material.value("metallic", 0.0),
                                    material.value("roughness", 0.0));
    for (const char* feature : {"coat", "sheen", "transmission", "anisotropy", "iridescence",
                                "unlit", "textures"}) {
        if (material.contains(feature)) {
            facts += fmt::format(", {}", feature);
        }
    }
    return facts;
}

std::string textureFacts(const Json& texture) {
    return fmt::format("{}x{} {} {}", texture.value("width", 0), texture.value("height", 0),
                       texture.value("format", ""), texture.value("colorSpace", ""));
}

std::string meshFacts(const Json& mesh) {
    return fmt::format("{} triangles", grouped(mesh.value("triangles", std::uint64_t{0})));
}

// One row an object: its number (as --camera counts), its name, and what `facts` says of it.
template <class Facts>
std::string listText(const Json& description, const char* key, const Facts& facts) {
    if (!description.contains(key) || description[key].empty()) {
        return "";
    }
    const Json& list = description[key];
    std::string text = fmt::format("{}\n", key);
    for (std::size_t i = 0; i < std::min(list.size(), kMaxRows); ++i) {
        text += fmt::format("  {:>3}  {:<28} {}", i, nameOf(list[i]), facts(list[i]));
        text.erase(text.find_last_not_of(' ') + 1);
        text += '\n';
    }
    if (list.size() > kMaxRows) {
        text += fmt::format("       ... and {} more (--json lists all)\n", list.size() - kMaxRows);
    }
    return text;
}

std::string describeText(const Json& d) {
    const auto kind = [](const Json& light) { return light.value("kind", ""); };
    const auto nothing = [](const Json&) { return std::string(); };
    return listText(d, "cameras", cameraFacts) + listText(d, "lights", kind) +
           listText(d, "meshes", meshFacts) + listText(d, "materials", materialFacts) +
           listText(d, "textures", textureFacts) + listText(d, "animations", nothing) +
           listText(d, "warnings", nothing);
}

int runInfo(InfoSettings& settings) {
    // "--json scene.glb": the only word there is must be the scene.
    if (settings.scenePath.empty()) {
        std::swap(settings.scenePath, settings.jsonPath);
    }
    if (settings.scenePath.empty()) {
        throw UsageError("info: SCENE is missing");
    }
    const std::string jsonPath = settings.jsonPath.empty() ? "-" : settings.jsonPath;
    if (settings.json) {
        checkWritable(jsonPath);
    }
    GpDeviceDesc desc{};
    desc.backend = GP_BACKEND_NULL;  // files are read without a renderer
    const Device device = newDevice(desc);
    const Scene scene = newScene(device.get());
    check(device.get(), gpLoadSceneFile(scene.get(), settings.scenePath.c_str(), &settings.load));
    GpSceneInfo info{};
    check(device.get(), gpGetSceneInfo(scene.get(), &info));
    const Json description = describeScene(device.get(), scene.get());
    if (settings.json) {
        writeJson(jsonPath, allJson(settings.scenePath, info, description));
    } else {
        writeText("-", totalsText(settings.scenePath, info) + describeText(description));
    }
    return kExitSuccess;
}

}  // namespace

Command addInfoCommand(CLI::App& tool) {
    CLI::App* app = tool.add_subcommand("info", "Tell what is in a scene file");
    const auto settings = std::make_shared<InfoSettings>();
    app->add_option("SCENE", settings->scenePath, "The scene: a .gltf or .glb file");
    const auto acceptJson = [settings](const std::string& word) {
        settings->json = true;
        settings->jsonPath = word;
    };
    addWord(*app, "--json", "[FILE]", "As JSON, into a file or to stdout", acceptJson)
        ->expected(0, 1);
    addSceneChoice(*app, settings->load);
    app->footer(kNotes);
    return {app, [settings] { return runInfo(*settings); }};
}

}  // namespace gp::tool
