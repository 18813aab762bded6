#include "make_scene.h"

#include "scenes.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace gp::make_scene {
namespace {

std::vector<SceneDefinition> sceneTable()
{
    return {
        {{"still-life", "materials on a garden table: glass, water, glaze, metals, cloth, a bubble",
          "--sun 296,36,0", {}},
         buildStillLife},
        {{"room", "a living room with a window, floor lamp, pendant globes, mirror and shelf",
          "--sun 262,30,0", {}},
         buildRoom},
        {{"corridor", "a vaulted stone corridor with torches, doors, puddles and ivy", "",
          {{"torches", "torches along both walls", 12, 8, 40, true}}},
         buildCorridor},
        {{"furnace", "white spheres over roughness (columns) and metallic (rows); no light", "",
          {{"rows", "spheres up, metallic from 0 to 1", 5, 1, 100, true},
           {"columns", "spheres across, roughness from 0 to 1", 9, 1, 100, true}}},
         buildFurnace},
        {{"cornell", "a diffuse box, 2 x 2 x 2 m, two blocks, one lamp of 0.5 x 0.5 m", "",
          {{"radiance", "radiance of the lamp, W/(m^2 sr)", 15, 0.001, 10000, false}}},
         buildCornell},
        {{"stress", "rocks scattered over a plain with EXT_mesh_gpu_instancing",
          "--sun 240,30,0",
          {{"triangles", "instanced triangles in all", 1e6, 1000, 1e7, true},
           {"instances", "rocks", 1000, 4, 1e6, true}}},
         buildStress},
        {{"closed-sphere",
          "a sphere seen from inside; radiance = emission / (1 - albedo) everywhere", "",
          {{"albedo", "diffuse albedo", 0.5, 0.0, 0.95, false},
           {"emission", "emitted radiance, W/(m^2 sr)", 0.5, 0.001, 10000, false},
           {"subdivisions", "facets along a cube edge (12 n^2 triangles)", 32, 2, 512, true}}},
         buildClosedSphere},
        {{"three-objects",
          "a pleated bulb and two spheres under a violet and a red lamp, for lighting models",
          "--mode local --lighting phong --ambient 0.05,0.05,0.05", {}},
         buildThreeObjects},
        {{"shore",
          "sand, stones and a mooring post for a sea at y = 0: view --ocean --transparent on",
          "--sun 115,46", {}},
         buildShore},
    };
}

[[noreturn]] void fail(const std::string& message) { throw std::runtime_error(message); }

void check(const SceneParameter& parameter, double value)
{
    std::ostringstream message;
    message << "make-scene: parameter '" << parameter.name << "' ";
    if (!(value >= parameter.minimum && value <= parameter.maximum)) {  // also refuses NaN
        message << "must lie in " << parameter.minimum << " to " << parameter.maximum << ", not "
                << value;
        fail(message.str());
    }
    if (parameter.integer && value != std::floor(value)) {
        message << "must be a whole number, not " << value;
        fail(message.str());
    }
}

Parameters resolve(const SceneInfo& info, const std::map<std::string, double>& given)
{
    Parameters result;
    for (const SceneParameter& parameter : info.parameters)
        result[parameter.name] = parameter.defaultValue;
    for (const auto& [name, value] : given)
        if (!result.contains(name))
            fail("make-scene: scene '" + info.name + "' has no parameter '" + name + "'");
    for (const SceneParameter& parameter : info.parameters)
        if (const auto it = given.find(parameter.name); it != given.end()) {
            check(parameter, it->second);
            result[parameter.name] = it->second;
        }
    return result;
}

}  // namespace

std::vector<SceneInfo> listScenes()
{
    std::vector<SceneInfo> list;
    for (const SceneDefinition& definition : sceneTable())
        list.push_back(definition.info);
    return list;
}

void makeScene(const MakeSceneOptions& options)
{
    std::string known;
    for (const SceneDefinition& definition : sceneTable()) {
        if (definition.info.name == options.name) {
            const Parameters parameters = resolve(definition.info, options.parameters);
            GlbBuilder glb(options.name);
            definition.build(glb, parameters);
            glb.write(options.outputPath);
            return;
        }
        known += (known.empty() ? "" : ", ") + definition.info.name;
    }
    fail("make-scene: unknown scene '" + options.name + "' (known: " + known + ")");
}

}  // namespace gp::make_scene
