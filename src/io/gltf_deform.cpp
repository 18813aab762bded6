// Morph targets and skins: vertices at one moment.
#include <algorithm>

#include "io/gltf_shape.h"

namespace gp::io {

namespace {

// Normals go with the cofactor matrix: the inverse transpose without its division, which also
// keeps the side of mirrored parts.
glm::mat3 cofactors(const glm::mat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

void addDeltas(const std::vector<glm::vec3>& deltas, float weight, auto& values) {
    for (size_t v = 0; v < deltas.size(); ++v)
        for (int c = 0; c < 3; ++c) values[v][c] += deltas[v][c] * weight;
}

// base + sum of weight * target. [glTF 2.0, 3.7.2.2]
void applyTargets(const Shape& shape, std::span<const float> weights, MeshData& data) {
    for (size_t t = 0; t < std::min(shape.targets.size(), weights.size()); ++t) {
        if (weights[t] == 0) continue;
        const Shape::Target& target = shape.targets[t];
        addDeltas(target.positions, weights[t], data.positions);
        addDeltas(target.normals, weights[t], data.normals);
        addDeltas(target.tangents, weights[t], data.tangents);
    }
}

// Weights must sum to 1; what quantisation left over is divided out. A vertex that follows
// nothing stays with the first joint.
glm::mat4 blended(const Shape& shape, const std::vector<glm::mat4>& worldFromJointRest, size_t v) {
    glm::mat4 sum(0);
    float total = 0;
    for (const Shape::Influences& in : shape.influences)
        for (int c = 0; c < 4; ++c) {
            if (in.weights[v][c] == 0) continue;
            sum += worldFromJointRest[in.joints[v][c]] * in.weights[v][c];
            total += in.weights[v][c];
        }
    return total > 0 ? sum / total : worldFromJointRest[0];
}

// Linear blend skinning with every set of joints and weights. [glTF 2.0, 3.7.3.3]
void applySkin(const Shape& shape, const std::vector<glm::mat4>& worldFromJointRest,
               MeshData& data) {
    for (size_t v = 0; v < data.positions.size(); ++v) {
        const glm::mat4 m = blended(shape, worldFromJointRest, v);
        const glm::mat3 linear(m);
        data.positions[v] = glm::vec3(m * glm::vec4(data.positions[v], 1));
        if (!data.normals.empty()) data.normals[v] = cofactors(linear) * data.normals[v];
        if (!data.tangents.empty())
            data.tangents[v] =
                glm::vec4(linear * glm::vec3(data.tangents[v]), data.tangents[v].w);
    }
}

}  // namespace

Deformation deformationOf(const Node& node, std::span<const float> meshWeights, const Skin* skin,
                          const std::vector<Node>& nodes) {
    Deformation d;
    d.weights = node.weights;
    if (d.weights.empty()) d.weights.assign(meshWeights.begin(), meshWeights.end());
    const bool allZero =
        std::all_of(d.weights.begin(), d.weights.end(), [](float w) { return w == 0; });
    if (allZero) d.weights.clear();
    if (!skin) return d;
    d.worldFromJointRest.resize(skin->joints.size());
    for (size_t i = 0; i < skin->joints.size(); ++i)
        d.worldFromJointRest[i] = nodes[skin->joints[i]].worldFromNode * skin->jointFromRest[i];
    return d;
}

void deform(const Shape& shape, const Deformation& deformation, MeshData& data) {
    applyTargets(shape, deformation.weights, data);
    if (!deformation.worldFromJointRest.empty())
        applySkin(shape, deformation.worldFromJointRest, data);
}

}  // namespace gp::io
