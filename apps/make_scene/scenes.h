// Inside the generator: one function a scene, and the table that lists them.
#pragma once

#include "glb.h"
#include "make_scene.h"

#include <map>
#include <string>
#include <vector>

namespace gp::make_scene {

// All of a scene's parameters, defaults filled in, checked.
using Parameters = std::map<std::string, double>;

struct SceneDefinition {
    SceneInfo info;
    void (*build)(GlbBuilder& glb, const Parameters& parameters);
};

void buildStillLife(GlbBuilder& glb, const Parameters& parameters);
void buildRoom(GlbBuilder& glb, const Parameters& parameters);
void buildCorridor(GlbBuilder& glb, const Parameters& parameters);
void buildFurnace(GlbBuilder& glb, const Parameters& parameters);
void buildCornell(GlbBuilder& glb, const Parameters& parameters);
void buildStress(GlbBuilder& glb, const Parameters& parameters);
void buildClosedSphere(GlbBuilder& glb, const Parameters& parameters);
void buildThreeObjects(GlbBuilder& glb, const Parameters& parameters);
void buildShore(GlbBuilder& glb, const Parameters& parameters);

}  // namespace gp::make_scene
