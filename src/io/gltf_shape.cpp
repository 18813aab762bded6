// Reading one primitive with its morph targets and its ties to joints.
#include "io/gltf_shape.h"

#include <algorithm>
#include <cmath>

namespace gp::io {

namespace {

constexpr uint32_t modeTriangles = 4, modeStrip = 5, modeFan = 6;

// Every array that says how a vertex is deformed ...
void forEachTie(auto& shape, const auto& visit) {
    for (auto& target : shape.targets) {
        visit(target.positions);
        visit(target.normals);
        visit(target.tangents);
    }
    for (auto& set : shape.influences) {
        visit(set.joints);
        visit(set.weights);
    }
}

// ... and these, and all others that have an element for each vertex.
void forEachArray(auto& shape, const auto& visit) {
    visit(shape.rest.positions);
    visit(shape.rest.normals);
    visit(shape.rest.tangents);
    visit(shape.rest.uv[0]);
    visit(shape.rest.uv[1]);
    visit(shape.rest.colors);
    forEachTie(shape, visit);
}

// NaN and infinity in what is not a position do less harm as zero than as an error.
template <typename V>
void zeroNonFinite(Document& document, const Value& attribute, std::vector<V>& values) {
    bool found = false;
    for (V& v : values)
        for (int c = 0; c < V::length(); ++c)
            if (!std::isfinite(v[c])) {
                v[c] = 0;
                found = true;
            }
    if (found) document.warn(attribute.where() + ": has values that are not finite; taken as zero");
}

template <typename V>
void requireCount(const Value& attribute, const std::vector<V>& values, size_t count) {
    if (values.size() != count)
        attribute.fail("has " + std::to_string(values.size()) + " values for " +
                       std::to_string(count) + " positions");
}

void readAttributes(Document& document, Accessors& accessors, const Value& attributes,
                    MeshData& data) {
    const auto accessor = [&](const char* name) { return attributes.index(name, "accessors"); };
    const auto check = [&](const char* name, auto& values) {
        requireCount(attributes[name], values, data.positions.size());
        zeroNonFinite(document, attributes[name], values);
    };
    const uint32_t position = attributes["POSITION"].asIndexInto("accessors");
    data.positions = accessors.vec3s(position);
    if (!data.positions.empty())
        accessors.requireFinite(&data.positions[0].x, data.positions.size(), 3, position,
                                "POSITION");
    if (const auto a = accessor("NORMAL")) {
        data.normals = accessors.vec3s(*a);
        check("NORMAL", data.normals);
    }
    if (const auto a = accessor("TANGENT")) {
        data.tangents = accessors.vec4s(*a);
        check("TANGENT", data.tangents);
    }
    const char* sets[2] = {"TEXCOORD_0", "TEXCOORD_1"};
    for (int i = 0; i < 2; ++i)
        if (const auto a = accessor(sets[i])) {
            data.uv[i] = accessors.vec2s(*a);
            check(sets[i], data.uv[i]);
        }
    if (const auto a = accessor("COLOR_0")) {
        data.colors = accessors.colors(*a);
        check("COLOR_0", data.colors);
    }
}

void readIndices(Accessors& accessors, const Value& primitive, size_t vertices,
                 std::vector<uint32_t>& indices) {
    const auto a = primitive.index("indices", "accessors");
    if (!a) {
        indices.resize(vertices);
        for (uint32_t i = 0; i < indices.size(); ++i) indices[i] = i;
        return;
    }
    indices = accessors.indices(*a);
    for (size_t i = 0; i < indices.size(); ++i)
        if (indices[i] >= vertices)
            primitive["indices"].fail("index " + std::to_string(i) + " is " +
                                      std::to_string(indices[i]) + ", but there are " +
                                      std::to_string(vertices) + " vertices");
}

// Strips and fans as triangles, counter-clockwise. [glTF 2.0, 3.7.2.1]
std::vector<uint32_t> trianglesOf(uint64_t mode, std::vector<uint32_t>&& v) {
    if (mode == modeTriangles) {
        v.resize(v.size() / 3 * 3);
        return std::move(v);
    }
    std::vector<uint32_t> out;
    for (size_t i = 0; i + 2 < v.size(); ++i) {
        if (mode == modeStrip) out.insert(out.end(), {v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]});
        else out.insert(out.end(), {v[i + 1], v[i + 2], v[0]});
    }
    return out;
}

// One array of a morph target: an offset for each vertex.
std::vector<glm::vec3> readDeltas(Document& document, Accessors& accessors, const Value& target,
                                  const char* name, size_t count) {
    const auto a = target.index(name, "accessors");
    if (!a) return {};
    std::vector<glm::vec3> deltas = accessors.vec3s(*a);
    requireCount(target[name], deltas, count);
    if (count > 0) accessors.requireFinite(&deltas[0].x, count, 3, *a, name);
    document.budget().spend(deltas.size() * sizeof(glm::vec3), target);
    return deltas;
}

void readTargets(Document& document, Accessors& accessors, const Value& primitive,
                 const ShapeRequest& request, Shape& shape) {
    const auto targets = primitive.find("targets");
    if (!targets) return;
    const size_t count = shape.rest.positions.size();
    const size_t needed =
        request.allTargets ? targets->size() : std::min(targets->size(), request.weights.size());
    shape.targets.resize(needed);
    for (size_t t = 0; t < needed; ++t) {
        if (!request.allTargets && request.weights[t] == 0) continue;
        const Value value = targets->at(t);
        const auto deltas = [&](const char* name) {
            return readDeltas(document, accessors, value, name, count);
        };
        shape.targets[t].positions = deltas("POSITION");
        if (!shape.rest.normals.empty()) shape.targets[t].normals = deltas("NORMAL");
        if (!shape.rest.tangents.empty()) shape.targets[t].tangents = deltas("TANGENT");
    }
}

// The joints of one set with their weights, checked against the number of joints.
std::optional<Shape::Influences> readSet(Accessors& accessors, const Value& attributes, int set,
                                         size_t vertices, size_t joints) {
    const std::string j = "JOINTS_" + std::to_string(set), w = "WEIGHTS_" + std::to_string(set);
    const auto jointAccessor = attributes.index(j.c_str(), "accessors");
    const auto weightAccessor = attributes.index(w.c_str(), "accessors");
    if (!jointAccessor || !weightAccessor) return std::nullopt;
    Shape::Influences in{accessors.joints(*jointAccessor),
                         accessors.vec4s(*weightAccessor, Integers::fractions)};
    requireCount(attributes[j.c_str()], in.joints, vertices);
    requireCount(attributes[w.c_str()], in.weights, vertices);
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

// Some writers let every primitive point into one array for the whole file.
void dropUnused(Shape& shape) {
    MeshData& data = shape.rest;
    std::vector<uint32_t> newIndex(data.positions.size(), ~0u);
    uint32_t used = 0;
    for (const uint32_t i : data.indices)
        if (newIndex[i] == ~0u) newIndex[i] = used++;
    if (used == data.positions.size()) return;
    for (uint32_t& i : data.indices) i = newIndex[i];
    const auto compact = [&](auto& values) {
        if (values.empty()) return;
        std::remove_reference_t<decltype(values)> out(used);
        for (size_t i = 0; i < values.size(); ++i)
            if (newIndex[i] != ~0u) out[newIndex[i]] = values[i];
        values = std::move(out);
    };
    forEachArray(shape, compact);
}

}  // namespace

uint64_t Shape::bytes() const {
    uint64_t sum = rest.indices.size() * sizeof(uint32_t);
    forEachArray(*this, [&](const auto& values) { sum += values.size() * sizeof(values[0]); });
    return sum;
}

std::optional<Shape> readShape(Document& document, Accessors& accessors, const Value& primitive,
                               const ShapeRequest& request) {
    const uint64_t mode = primitive.count("mode", modeTriangles);
    if (mode > modeFan) primitive.fail("unknown mode " + std::to_string(mode));
    if (mode < modeTriangles) {
        document.warn(primitive.where() + ": points and lines are not drawn");
        return std::nullopt;
    }
    const Value attributes = primitive["attributes"];
    if (!attributes.has("POSITION")) {
        document.warn(primitive.where() + ": has no POSITION; not drawn");
        return std::nullopt;
    }
    Shape shape;
    readAttributes(document, accessors, attributes, shape.rest);
    const size_t vertices = shape.rest.positions.size();
    std::vector<uint32_t> indices;
    readIndices(accessors, primitive, vertices, indices);
    if (mode == modeTriangles && indices.size() % 3 != 0)
        document.warn(primitive.where() + ": has one or two vertices too many; left out");
    shape.rest.indices = trianglesOf(mode, std::move(indices));
    if (shape.rest.indices.empty()) {
        document.warn(primitive.where() + ": has no triangles");
        return std::nullopt;
    }
    readTargets(document, accessors, primitive, request, shape);
    for (int set = 0; request.joints > 0; ++set) {
        auto in = readSet(accessors, attributes, set, vertices, request.joints);
        if (!in) break;
        document.budget().spend(vertices * sizeof(glm::vec4) * 2, primitive);
        shape.influences.push_back(std::move(*in));
    }
    dropUnused(shape);
    return shape;
}

void completeTangents(Shape& shape, const MeshOptions& options) {
    const std::vector<uint32_t> order = giveTangents(shape.rest, options);
    if (order.empty()) return;
    const auto gather = [&](auto& values) {
        if (values.empty()) return;
        std::remove_reference_t<decltype(values)> out(order.size());
        for (size_t i = 0; i < order.size(); ++i) out[i] = values[order[i]];
        values = std::move(out);
    };
    forEachTie(shape, gather);
}

Skin readSkin(Document& document, Accessors& accessors, uint32_t skin) {
    const Value value = document.element("skins", skin), joints = value["joints"];
    if (joints.size() == 0) value.fail("has no joints");
    Skin out;
    for (size_t i = 0; i < joints.size(); ++i)
        out.joints.push_back(joints.at(i).asIndexInto("nodes"));
    out.jointFromRest.assign(joints.size(), glm::mat4(1));
    const auto a = value.index("inverseBindMatrices", "accessors");
    if (!a) return out;
    std::vector<glm::mat4> read = accessors.mat4s(*a);
    if (read.size() < joints.size())
        value.fail("has " + std::to_string(joints.size()) + " joints, but only " +
                   std::to_string(read.size()) + " inverse bind matrices");
    accessors.requireFinite(&read[0][0][0], read.size(), 16, *a, "matrix");
    read.resize(joints.size());
    out.jointFromRest = std::move(read);
    return out;
}

}  // namespace gp::io
