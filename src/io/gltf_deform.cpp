// Morph targets and skins: vertices at one moment.
#include <algorithm>
#include <cmath>

#include "io/gltf_mesh.h"

namespace gp::io {

namespace {

void addDeltas(Accessors& accessors, const Value& target, const char* name, float weight,
               size_t count, const auto& add) {
    const auto a = target.index(name, "accessors");
    if (!a) return;
    const std::vector<glm::vec3> deltas = accessors.vec3s(*a);
    if (deltas.size() != count)
        target[name].fail("has " + std::to_string(deltas.size()) + " values for " +
                          std::to_string(count) + " positions");
    if (count > 0) accessors.requireFinite(&deltas[0].x, count, 3, *a, name);
    for (size_t v = 0; v < count; ++v) add(v, deltas[v] * weight);
}

// The joints of one set with their weights, checked against the number of joints.
struct Influences {
    std::vector<glm::u32vec4> joints;
    std::vector<glm::vec4> weights;
};

std::optional<Influences> readInfluences(Accessors& accessors, const Value& attributes, int set,
                                         size_t vertices, size_t joints) {
    const std::string j = "JOINTS_" + std::to_string(set), w = "WEIGHTS_" + std::to_string(set);
    const auto jointAccessor = attributes.index(j.c_str(), "accessors");
    const auto weightAccessor = attributes.index(w.c_str(), "accessors");
    if (!jointAccessor || !weightAccessor) return std::nullopt;
    Influences in{accessors.joints(*jointAccessor),
                  accessors.vec4s(*weightAccessor, Integers::fractions)};
    const auto requireCount = [&](const std::string& name, size_t count) {
        if (count != vertices)
            attributes[name.c_str()].fail("has " + std::to_string(count) + " values for " +
                                          std::to_string(vertices) + " positions");
    };
    requireCount(j, in.joints.size());
    requireCount(w, in.weights.size());
    if (vertices > 0)
        accessors.requireFinite(&in.weights[0].x, vertices, 4, *weightAccessor, "weight");
    for (size_t v = 0; v < vertices; ++v)
        for (int c = 0; c < 4; ++c)
            if (in.weights[v][c] != 0 && in.joints[v][c] >= joints)
                attributes[j.c_str()].fail("vertex " + std::to_string(v) + " follows joint " +
                                           std::to_string(in.joints[v][c]) + ", but the skin has " +
                                           std::to_string(joints));
    return in;
}

// Normals go with the cofactor matrix: the inverse transpose without its division, which also
// keeps the side of mirrored parts.
glm::mat3 cofactors(const glm::mat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

}  // namespace

void applyMorph(Accessors& accessors, const Value& primitive, std::span<const float> weights,
                MeshData& data) {
    const auto targets = primitive.find("targets");
    if (!targets) return;
    const size_t count = data.positions.size();
    for (size_t t = 0; t < std::min(targets->size(), weights.size()); ++t) {
        if (weights[t] == 0) continue;
        const Value target = targets->at(t);
        addDeltas(accessors, target, "POSITION", weights[t], count,
                  [&](size_t v, glm::vec3 d) { data.positions[v] += d; });
        if (!data.normals.empty())
            addDeltas(accessors, target, "NORMAL", weights[t], count,
                      [&](size_t v, glm::vec3 d) { data.normals[v] += d; });
        if (!data.tangents.empty())
            addDeltas(accessors, target, "TANGENT", weights[t], count,
                      [&](size_t v, glm::vec3 d) { data.tangents[v] += glm::vec4(d, 0); });
    }
}

void applySkin(Accessors& accessors, const Value& primitive,
               const std::vector<glm::mat4>& worldFromJointRest, MeshData& data) {
    const Value attributes = primitive["attributes"];
    const size_t count = data.positions.size();
    std::vector<glm::mat4> blended(count, glm::mat4(0));
    std::vector<float> total(count, 0.0f);
    for (int set = 0;; ++set) {
        const auto in = readInfluences(accessors, attributes, set, count,
                                       worldFromJointRest.size());
        if (!in) break;
        for (size_t v = 0; v < count; ++v)
            for (int c = 0; c < 4; ++c) {
                if (in->weights[v][c] == 0) continue;
                blended[v] += worldFromJointRest[in->joints[v][c]] * in->weights[v][c];
                total[v] += in->weights[v][c];
            }
    }
    for (size_t v = 0; v < count; ++v) {
        // Weights must sum to 1; what quantisation left over is divided out. A vertex that
        // follows nothing stays with the first joint.
        const glm::mat4 m = total[v] > 0 ? blended[v] / total[v] : worldFromJointRest[0];
        const glm::mat3 linear(m);
        data.positions[v] = glm::vec3(m * glm::vec4(data.positions[v], 1));
        if (!data.normals.empty()) data.normals[v] = cofactors(linear) * data.normals[v];
        if (!data.tangents.empty())
            data.tangents[v] =
                glm::vec4(linear * glm::vec3(data.tangents[v]), data.tangents[v].w);
    }
}

std::vector<glm::mat4> jointMatrices(Document& document, Accessors& accessors, uint32_t skin,
                                     const std::vector<Node>& nodes) {
    const Value value = document.element("skins", skin), joints = value["joints"];
    if (joints.size() == 0) value.fail("has no joints");
    std::vector<glm::mat4> jointFromMesh(joints.size(), glm::mat4(1));
    if (const auto a = value.index("inverseBindMatrices", "accessors")) {
        std::vector<glm::mat4> read = accessors.mat4s(*a);
        if (read.size() < joints.size())
            value.fail("has " + std::to_string(joints.size()) + " joints, but only " +
                       std::to_string(read.size()) + " inverse bind matrices");
        accessors.requireFinite(&read[0][0][0], read.size(), 16, *a, "matrix");
        jointFromMesh = std::move(read);
    }
    std::vector<glm::mat4> out(joints.size());
    for (size_t i = 0; i < out.size(); ++i)
        out[i] = nodes[joints.at(i).asIndexInto("nodes")].worldFromNode * jointFromMesh[i];
    return out;
}

bool skinMoves(const Document& document, uint32_t skin, const std::vector<Node>& nodes) {
    const Value joints = document.element("skins", skin)["joints"];
    for (size_t i = 0; i < joints.size(); ++i)
        if (nodes[joints.at(i).asIndexInto("nodes")].moves) return true;
    return false;
}

}  // namespace gp::io
