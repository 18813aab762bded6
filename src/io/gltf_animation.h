// Animations of a glTF file.
#pragma once

#include "io/gltf_nodes.h"

namespace gp::io {

enum class Interpolation : uint8_t { step, linear, cubicSpline };
enum class Property : uint8_t { translation, rotation, scale, weights };

// The keys of one channel as plain numbers: `width` floats a value.
struct Track {
    std::vector<float> times;
    std::vector<float> values;  // cubic: in-tangent, value, out-tangent for each key
    size_t width = 0;
    Interpolation interpolation = Interpolation::linear;

    size_t perKey() const { return interpolation == Interpolation::cubicSpline ? 3 : 1; }
    // part: 0 in-tangent, 1 value, 2 out-tangent
    const float* at(size_t key, size_t part) const {
        return values.data() + (key * perKey() + (perKey() == 3 ? part : 0)) * width;
    }
};

struct Channel {
    uint32_t node = 0;
    Property property = Property::translation;
    Track track;
};

// One animation, checked, in memory; it needs the file no longer.
struct Animation {
    std::vector<Channel> channels;
    double length = 0;  // seconds: its last key; not negative
};

// The names of all animations; marks the nodes that any of them moves or morphs.
std::vector<std::string> listAnimations(Document& document, std::vector<Node>& nodes);

Animation readAnimation(Document& document, Accessors& accessors, uint32_t index,
                        const std::vector<Node>& nodes);

// Puts the nodes where the animation has them at `time` seconds; before its first and after its
// last key an animation holds still.
void poseNodes(const Animation& animation, double time, std::vector<Node>& nodes);

// Where an animation of this length stands that starts again each time it is over.
double loopedTime(double time, double length);

}  // namespace gp::io
