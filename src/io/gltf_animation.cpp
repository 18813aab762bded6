#include "io/gltf_animation.h"

#include <algorithm>
#include <cmath>

namespace gp::io {

namespace {

// Where `time` falls: after key `k`, at fraction `s` of `duration` seconds to the next one.
struct Moment {
    size_t k = 0;
    float s = 0, duration = 0;
};

Moment momentOf(const std::vector<float>& times, double time) {
    Moment m;
    const auto after = std::upper_bound(times.begin(), times.end(), time,
                                        [](double t, float key) { return t < double(key); });
    if (after == times.begin()) return m;
    m.k = static_cast<size_t>(after - times.begin()) - 1;
    if (after == times.end()) return m;
    m.duration = times[m.k + 1] - times[m.k];
    m.s = static_cast<float>((time - double(times[m.k])) / double(m.duration));
    return m;
}

// Four numbers of a key as a quaternion of unit length (or no rotation).
glm::quat quatAt(const float* v) {
    const glm::quat q(v[3], v[0], v[1], v[2]);
    const float length = glm::length(q);
    return length > 0 && std::isfinite(length) ? q / length : glm::quat(1, 0, 0, 0);
}

// [glTF 2.0, appendix C: interpolation modes]
std::vector<float> sample(const Track& track, double time, bool rotation) {
    const Moment m = momentOf(track.times, time);
    const float* a = track.at(m.k, 1);
    std::vector<float> out(a, a + track.width);
    const bool between = m.duration > 0 && track.interpolation != Interpolation::step;
    if (between && track.interpolation == Interpolation::cubicSpline) {
        const float s = m.s, s2 = s * s, s3 = s2 * s, d = m.duration;
        const float *tangent0 = track.at(m.k, 2), *b = track.at(m.k + 1, 1),
                    *tangent1 = track.at(m.k + 1, 0);
        for (size_t i = 0; i < track.width; ++i)
            out[i] = (2 * s3 - 3 * s2 + 1) * a[i] + d * (s3 - 2 * s2 + s) * tangent0[i] +
                     (3 * s2 - 2 * s3) * b[i] + d * (s3 - s2) * tangent1[i];
    } else if (between && rotation) {
        const glm::quat q = glm::slerp(quatAt(a), quatAt(track.at(m.k + 1, 1)), m.s);
        out = {q.x, q.y, q.z, q.w};
    } else if (between) {
        const float* b = track.at(m.k + 1, 1);
        for (size_t i = 0; i < track.width; ++i) out[i] = a[i] + (b[i] - a[i]) * m.s;
    }
    return out;
}

Interpolation interpolationOf(const Value& sampler) {
    const std::string name = sampler.text("interpolation", "LINEAR");
    if (name == "STEP") return Interpolation::step;
    if (name == "LINEAR") return Interpolation::linear;
    if (name == "CUBICSPLINE") return Interpolation::cubicSpline;
    sampler.fail("unknown interpolation '" + name.substr(0, 20) + "'");
}

// The output of a sampler as floats; `property` says how wide one value is.
std::vector<float> readOutput(Accessors& accessors, uint32_t accessor, Property property) {
    const auto flat = [](const auto& vectors) {
        const float* first = vectors.empty() ? nullptr : &vectors[0][0];
        return std::vector<float>(first, first + vectors.size() * vectors[0].length());
    };
    if (property == Property::weights) return accessors.scalars(accessor, Integers::fractions);
    if (accessors.count(accessor) == 0) return {};
    if (property == Property::rotation)
        return flat(accessors.vec4s(accessor, Integers::fractions));
    return flat(accessors.vec3s(accessor));
}

Track readTrack(Document& document, Accessors& accessors, const Value& sampler, Property property,
                size_t width) {
    Track t;
    t.width = width;
    t.interpolation = interpolationOf(sampler);
    const uint32_t input = sampler["input"].asIndexInto("accessors");
    const uint32_t output = sampler["output"].asIndexInto("accessors");
    t.times = accessors.scalars(input);
    t.values = readOutput(accessors, output, property);
    if (t.times.empty()) sampler.fail("has no keys");
    accessors.requireFinite(t.times.data(), t.times.size(), 1, input, "key time");
    accessors.requireFinite(t.values.data(), t.values.size(), 1, output, "key value");
    if (!std::is_sorted(t.times.begin(), t.times.end()))
        document.element("accessors", input).fail("key times must not decrease");
    if (t.values.size() != t.times.size() * t.perKey() * width)
        sampler.fail("has " + std::to_string(t.times.size()) + " keys, but " +
                     std::to_string(t.values.size()) + " output numbers where " +
                     std::to_string(t.times.size() * t.perKey() * width) + " are needed");
    // Many channels may read the same few keys, and each keeps its own.
    document.budget().spend((t.times.size() + t.values.size()) * sizeof(float), sampler);
    return t;
}

// The number of morph targets of a mesh: that of its first primitive.
size_t targetCount(const Document& document, const Node& node) {
    if (!node.mesh) return 0;
    const Value primitives = document.element("meshes", *node.mesh)["primitives"];
    if (primitives.size() == 0) return 0;
    const auto targets = primitives.at(0).find("targets");
    return targets ? targets->size() : 0;
}

struct Target {
    uint32_t node = 0;
    Property property = Property::translation;
};

// Nothing where the channel moves no node of ours.
std::optional<Target> readTarget(Document& document, const Value& channel) {
    const Value target = channel["target"];
    const auto node = target.index("node", "nodes");
    const std::string path = target["path"].asText();
    constexpr const char* names[] = {"translation", "rotation", "scale", "weights"};
    for (uint8_t i = 0; i < std::size(names); ++i)
        if (path == names[i]) {
            if (!node) return std::nullopt;
            return Target{*node, Property(i)};
        }
    document.warn("animation of '" + path.substr(0, 40) + "' is ignored");
    return std::nullopt;
}

// Numbers of one key.
size_t widthOf(const Document& document, Property property, const Node& node) {
    if (property == Property::weights) return targetCount(document, node);
    return property == Property::rotation ? 4 : 3;
}

void poseNode(const Channel& channel, double time, Node& node) {
    const bool rotation = channel.property == Property::rotation;
    std::vector<float> v = sample(channel.track, time, rotation);
    if (channel.property == Property::weights) {
        node.weights = std::move(v);
        return;
    }
    if (rotation) node.rotation = quatAt(v.data());
    else (channel.property == Property::scale ? node.scale : node.translation) = {v[0], v[1], v[2]};
    node.matrix.reset();  // glTF forbids both; the animation wins
}

}  // namespace

std::vector<std::string> listAnimations(Document& document, std::vector<Node>& nodes) {
    std::vector<std::string> names;
    const uint32_t count = static_cast<uint32_t>(document.size("animations"));
    for (uint32_t i = 0; i < count; ++i) {
        const Value animation = document.element("animations", i);
        names.push_back(animation.text("name", "animation " + std::to_string(i)));
        const Value channels = animation["channels"];
        for (size_t c = 0; c < channels.size(); ++c)
            if (const auto target = readTarget(document, channels.at(c))) {
                Node& node = nodes[target->node];
                (target->property == Property::weights ? node.morphs : node.moves) = true;
            }
    }
    return names;
}

Animation readAnimation(Document& document, Accessors& accessors, uint32_t index,
                        const std::vector<Node>& nodes) {
    const Value animation = document.element("animations", index);
    const Value channels = animation["channels"], samplers = animation["samplers"];
    Animation out;
    for (size_t c = 0; c < channels.size(); ++c) {
        const auto target = readTarget(document, channels.at(c));
        if (!target) continue;
        const uint64_t sampler = channels.at(c)["sampler"].asCount();
        if (sampler >= samplers.size())
            channels.at(c).fail("there is no sampler " + std::to_string(sampler));
        const size_t width = widthOf(document, target->property, nodes[target->node]);
        if (width == 0) continue;  // weights of a mesh that has no targets
        out.channels.push_back({target->node, target->property,
                                readTrack(document, accessors, samplers.at(sampler),
                                          target->property, width)});
        out.length = std::max(out.length, double(out.channels.back().track.times.back()));
    }
    return out;
}

void poseNodes(const Animation& animation, double time, std::vector<Node>& nodes) {
    for (const Channel& channel : animation.channels) poseNode(channel, time, nodes[channel.node]);
}

double loopedTime(double time, double length) {
    if (!(length > 0)) return time;
    const double t = std::fmod(time, length);
    return t < 0 ? t + length : t;
}

}  // namespace gp::io
