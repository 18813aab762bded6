// The arrays of one primitive.
#include <algorithm>
#include <cmath>

#include "io/gltf_mesh.h"

namespace gp::io {

namespace {

constexpr uint32_t modeTriangles = 4, modeStrip = 5, modeFan = 6;

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

// Some writers let every primitive point into one array for the whole file.
void dropUnused(MeshData& data) {
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
    compact(data.positions);
    compact(data.normals);
    compact(data.tangents);
    compact(data.uv[0]);
    compact(data.uv[1]);
    compact(data.colors);
}

}  // namespace

std::optional<MeshData> readPrimitive(Document& document, Accessors& accessors,
                                      const Value& primitive, const Deformation& deformation) {
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
    MeshData data;
    readAttributes(document, accessors, attributes, data);
    std::vector<uint32_t> indices;
    readIndices(accessors, primitive, data.positions.size(), indices);
    if (mode == modeTriangles && indices.size() % 3 != 0)
        document.warn(primitive.where() + ": has one or two vertices too many; left out");
    data.indices = trianglesOf(mode, std::move(indices));
    if (data.indices.empty()) {
        document.warn(primitive.where() + ": has no triangles");
        return std::nullopt;
    }
    applyMorph(accessors, primitive, deformation.weights, data);
    if (!deformation.worldFromJointRest.empty())
        applySkin(accessors, primitive, deformation.worldFromJointRest, data);
    dropUnused(data);
    return data;
}

}  // namespace gp::io
