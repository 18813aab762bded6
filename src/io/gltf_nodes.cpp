#include "io/gltf_nodes.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/type_ptr.hpp>

#include "scene/hash.h"

namespace gp::io {

namespace {

glm::quat unitQuat(glm::vec4 xyzw) {
    const float length = glm::length(xyzw);
    if (!(length > 0) || !std::isfinite(length)) return {1, 0, 0, 0};
    return glm::quat(xyzw.w, xyzw.x, xyzw.y, xyzw.z) / length;
}

Node readNode(const Value& value) {
    Node n;
    n.name = value.text("name", "");
    n.mesh = value.index("mesh", "meshes");
    n.skin = value.index("skin", "skins");
    n.camera = value.index("camera", "cameras");
    n.translation = value.vec<3>("translation", n.translation);
    n.scale = value.vec<3>("scale", n.scale);
    n.rotation = unitQuat(value.vec<4>("rotation", {0, 0, 0, 1}));
    if (const auto m = value.find("matrix")) {
        n.matrix.emplace(1.0f);
        m->reals(glm::value_ptr(*n.matrix), 16);
    }
    if (const auto w = value.find("weights")) {
        n.weights.resize(w->size());
        if (!n.weights.empty()) w->reals(n.weights.data(), n.weights.size());
    }
    if (const auto children = value.find("children"))
        for (size_t i = 0; i < children->size(); ++i)
            n.children.push_back(children->at(i).asIndexInto("nodes"));
    if (const auto light = value.extension("KHR_lights_punctual")) {
        const uint64_t i = (*light)["light"].asCount();
        n.light = static_cast<uint32_t>(std::min<uint64_t>(i, 0xffffffffu));
    }
    return n;
}

std::string nodeText(uint32_t i) { return "nodes[" + std::to_string(i) + "]"; }

void linkParents(const Document& document, std::vector<Node>& nodes) {
    for (uint32_t i = 0; i < nodes.size(); ++i)
        for (const uint32_t child : nodes[i].children) {
            if (nodes[child].parent)
                document.element("nodes", child)
                    .fail("is a child of both " + nodeText(*nodes[child].parent) + " and " +
                          nodeText(i));
            nodes[child].parent = i;
        }
}

// Every node below the given ones, parents first; without recursion, since a file may nest as
// deep as it likes.
std::vector<uint32_t> below(const std::vector<Node>& nodes, std::vector<uint32_t> order) {
    for (size_t i = 0; i < order.size(); ++i) {
        const std::vector<uint32_t>& c = nodes[order[i]].children;
        order.insert(order.end(), c.begin(), c.end());
    }
    return order;
}

std::vector<uint32_t> roots(const std::vector<Node>& nodes) {
    std::vector<uint32_t> out;
    for (uint32_t i = 0; i < nodes.size(); ++i)
        if (!nodes[i].parent) out.push_back(i);
    return out;
}

// Each node has one parent at most: what no root leads to runs in a circle.
void refuseCycles(const Document& document, const std::vector<Node>& nodes) {
    std::vector<bool> reached(nodes.size(), false);
    for (const uint32_t i : below(nodes, roots(nodes))) reached[i] = true;
    for (uint32_t i = 0; i < nodes.size(); ++i)
        if (!reached[i])
            document.element("nodes", i).fail("is its own ancestor or hangs below such a node");
}

glm::mat4 parentFromNode(const Node& n) {
    if (n.matrix) return *n.matrix;
    glm::mat4 m = glm::mat4_cast(n.rotation);
    for (int i = 0; i < 3; ++i) m[i] *= n.scale[i];
    m[3] = glm::vec4(n.translation, 1);
    return m;
}

bool isFinite(const glm::mat4& m) {
    const float* v = glm::value_ptr(m);
    return std::all_of(v, v + 16, [](float x) { return std::isfinite(x); });
}

}  // namespace

std::vector<Node> readNodes(Document& document) {
    std::vector<Node> nodes;
    const uint32_t count = static_cast<uint32_t>(document.size("nodes"));
    for (uint32_t i = 0; i < count; ++i) nodes.push_back(readNode(document.element("nodes", i)));
    linkParents(document, nodes);
    refuseCycles(document, nodes);
    return nodes;
}

std::vector<uint32_t> parentsFirst(const std::vector<Node>& nodes) {
    return below(nodes, roots(nodes));
}

void identifyNodes(std::vector<Node>& nodes, uint64_t seed) {
    for (const uint32_t i : parentsFirst(nodes)) {
        Node& n = nodes[i];
        const Node* parent = n.parent ? &nodes[*n.parent] : nullptr;
        n.moves |= parent && parent->moves;
        const std::string step = n.name + "#" + std::to_string(i);
        n.pathHash = hashBytes(step.data(), step.size(), parent ? parent->pathHash : seed);
    }
}

void placeNodes(const std::string& path, const std::vector<uint32_t>& order,
                std::vector<Node>& nodes) {
    for (const uint32_t i : order) {
        Node& n = nodes[i];
        n.worldFromNode = parentFromNode(n);
        // glTF allows affine transforms only; what a file has in the last row is not meant.
        for (int c = 0; c < 4; ++c) n.worldFromNode[c][3] = c == 3 ? 1.0f : 0.0f;
        if (n.parent) n.worldFromNode = nodes[*n.parent].worldFromNode * n.worldFromNode;
        if (!isFinite(n.worldFromNode))
            throw FileError(FileError::Kind::invalid, path,
                            nodeText(i) + ": its transform is not finite");
    }
}

std::vector<uint32_t> nodesOfScene(const Document& document, const std::vector<Node>& nodes,
                                   int scene) {
    const size_t count = document.size("scenes");
    if (scene >= 0 && size_t(scene) >= count)
        document.root().fail("there is no scene " + std::to_string(scene) + "; the file has " +
                             std::to_string(count));
    if (count == 0) return below(nodes, roots(nodes));
    uint32_t chosen = static_cast<uint32_t>(std::max(scene, 0));
    if (scene < 0) chosen = document.root().index("scene", "scenes").value_or(0);
    const Value value = document.element("scenes", chosen);
    std::vector<uint32_t> order;
    std::vector<bool> listed(nodes.size(), false);
    if (const auto list = value.find("nodes"))
        for (size_t i = 0; i < list->size(); ++i) {
            const uint32_t node = list->at(i).asIndexInto("nodes");
            if (nodes[node].parent) list->at(i).fail(nodeText(node) + " is not a root");
            if (listed[node]) list->at(i).fail(nodeText(node) + " is listed twice");
            listed[node] = true;
            order.push_back(node);
        }
    return below(nodes, std::move(order));
}

}  // namespace gp::io
