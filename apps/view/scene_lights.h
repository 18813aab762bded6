// The lights of the scene as a person changes them: those that it was loaded with, and others.
#pragma once

#include <glitterpath/glitterpath.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gp::tool::view {

struct SceneLight {
    GpLightDesc desc{};          // in GP_UNIT_RADIOMETRIC; its pointers are nobody's: see below
    std::string name;
    std::vector<float> corners;  // of a polygon
    bool isOn = true;
    bool isRemoved = false;      // keeps its place, so that the others keep their numbers
    bool isOurs = false;         // added here, not of the file

    // What the library is to be told; its pointers live as long as this does.
    GpLightDesc shown() const;
    // By what a person may change.
    friend bool operator==(const SceneLight& a, const SceneLight& b);
};

// Never changed, only replaced: whoever holds one sees at once whether it is still the same.
using SceneLights = std::shared_ptr<const std::vector<SceneLight>>;

inline constexpr std::pair<const char*, GpLightKind> kLightKindWords[] = {
    {"directional", GP_LIGHT_DIRECTIONAL},
    {"sphere", GP_LIGHT_SPHERE},
    {"spot", GP_LIGHT_SPOT},
    {"rectangle", GP_LIGHT_RECTANGLE},
    {"polygon", GP_LIGHT_POLYGON}};

// The first `count` lights of the scene. Throws RunError.
SceneLights sceneLights(GpDevice device, GpScene scene, std::uint32_t count);

// A light of a kind that can be added by hand: all but polygons; where the camera is, and shining
// where it looks. `reach`: metres to what is seen, which makes its size and strength.
SceneLight newSceneLight(GpLightKind kind, const GpCameraDesc& camera, float reach);

// Of a rectangle's edge, metres; an edge is never of length 0.
float edgeLength(const float* edge);
void scaleEdge(float* edge, float length);

// The unit of a light's intensity, for people.
const char* intensityUnit(GpLightKind kind);

// What a person may set of a light, by name, as scripts write it: "on" (on, off), "color" (R,G,B),
// "intensity", "position" (X,Y,Z), "direction" (X,Y,Z), "radius", "angular-radius" (degrees),
// "cone" (degrees, from the axis), "width", "height" (metres). Throws UsageError, for what this
// kind of light lacks, too.
void setLightField(SceneLight& light, const std::string& field, const std::string& value);

}  // namespace gp::tool::view
