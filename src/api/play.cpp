// gpSetSceneTime: files that play on after they have been loaded.

#include "api/check.h"
#include "api/objects.h"
#include "io/gltf_player.h"

namespace gp::api {

namespace {

// What each file plays once the options have had their say.
std::vector<int> animationsFor(const SceneObject& scene, uint32_t chosen) {
    std::vector<int> result;
    bool found = chosen == 0 || chosen == GP_ALL_ANIMATIONS;
    if (!found && chosen > scene.scene.animations.size())
        fail(GP_ERROR_OUT_OF_RANGE, "options.animation is {}, but the scene has {}", chosen,
             scene.scene.animations.size());
    for (const PlayingFile& file : scene.playing) {
        int animation = file.animation;
        if (chosen == GP_ALL_ANIMATIONS) animation = io::allAnimations;
        else if (chosen > file.firstAnimation &&
                 chosen - file.firstAnimation <= file.player->animationCount()) {
            animation = int(chosen - file.firstAnimation) - 1;
            found = true;
        }
        result.push_back(animation);
    }
    if (!found)
        fail(GP_ERROR_INVALID_OPERATION,
             "options.animation is {}, of a file that was not loaded as playable", chosen);
    return result;
}

void setTime(SceneObject& scene, double time, const GpPlayOptions& options) {
    checkFinite(time, "time");
    if (scene.playing.empty())
        fail(GP_ERROR_INVALID_OPERATION,
             "nothing in the scene can play: set `playable` in GpLoadOptions");
    const std::vector<int> animations = animationsFor(scene, options.animation);
    // All files are asked before the first one moves, so that an error leaves everything still.
    for (size_t i = 0; i < animations.size(); ++i)
        scene.playing[i].player->prepare({time, options.loop != 0, animations[i]});
    bool changed = false;
    for (size_t i = 0; i < animations.size(); ++i) {
        changed |= scene.playing[i].player->apply(scene.scene);
        scene.playing[i].animation = animations[i];
    }
    if (changed) ++scene.scene.revision;
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" GpError gpSetSceneTime(GpScene scene, double time, const GpPlayOptions* options) {
    return enter("gpSetSceneTime", "scene", scene, [&](SceneObject& s) {
        setTime(s, time, options ? *options : GpPlayOptions{});
    });
}
