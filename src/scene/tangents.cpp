// Based on: Mikkelsen 2008, "Simulation of Wrinkled Surfaces Revisited" (the space that baking
// tools and glTF 2.0 mean). Deviations: triangles meet where position, normal, uv and handedness
// are equal, without asking whether they share an edge; handedness is taken against the vertex
// normals, so that a triangle wound the wrong way round still gets the right one.
#include "shading/shading.h"

#include "scene/tangents.h"

#include <cmath>
#include <cstring>

#include "scene/hash.h"

namespace gp {

namespace {

struct Face {
    glm::vec3 tangent{0};  // direction of growing u, any length; zero: uv say nothing
    float sign = 1;
};

// Equal position, normal and uv: equal number. Open addressing over the vertices themselves.
std::vector<uint32_t> weld(const TangentInput& in) {
    struct Key {
        glm::vec3 position, normal;
        glm::vec2 uv;
        bool operator==(const Key& o) const {
            return position == o.position && normal == o.normal && uv == o.uv;
        }
    };
    // Adding zero turns -0 into +0, which must hash alike.
    const auto key = [&](size_t v) {
        return Key{in.positions[v] + 0.0f, in.normals[v] + 0.0f, in.uv[v] + 0.0f};
    };
    const size_t count = in.positions.size();
    size_t slots = 16;
    while (slots < count * 2) slots *= 2;
    constexpr uint32_t none = ~0u;
    std::vector<uint32_t> table(slots, none), welded(count);
    for (size_t v = 0; v < count; ++v) {
        const Key k = key(v);
        size_t slot = hashBytes(&k, sizeof k) & (slots - 1);
        while (table[slot] != none && !(key(table[slot]) == k)) slot = (slot + 1) & (slots - 1);
        if (table[slot] == none) table[slot] = static_cast<uint32_t>(v);
        welded[v] = table[slot];
    }
    return welded;
}

Face faceTangent(const TangentInput& in, glm::uvec3 t) {
    const glm::vec3 e1 = in.positions[t.y] - in.positions[t.x];
    const glm::vec3 e2 = in.positions[t.z] - in.positions[t.x];
    const glm::vec2 d1 = in.uv[t.y] - in.uv[t.x], d2 = in.uv[t.z] - in.uv[t.x];
    const float area = d1.x * d2.y - d1.y * d2.x;
    const glm::vec3 n = in.normals[t.x] + in.normals[t.y] + in.normals[t.z];
    const bool against = glm::dot(glm::cross(e1, e2), n) < 0;
    Face f;
    // [Mikkelsen 2008, eq. 2.22], without the positive factor 1 / |area|
    const glm::vec3 tangent = (e1 * d2.y - e2 * d1.y) * (area < 0 ? -1.0f : 1.0f);
    const float length = glm::length(tangent);
    if (area != 0 && length > 0 && std::isfinite(length)) f.tangent = tangent / length;
    // v grows downwards in glTF's pictures, hence the sign.
    f.sign = (area < 0) != against ? 1.0f : -1.0f;
    return f;
}

glm::vec3 projected(glm::vec3 v, glm::vec3 n) {
    const glm::vec3 p = v - n * glm::dot(n, v);
    const float l = glm::length(p);
    return l > 1e-12f && std::isfinite(l) ? p / l : glm::vec3(0);
}

// The angle at a corner, seen along its normal: the weight of the triangle there.
float cornerAngle(const TangentInput& in, glm::uvec3 t, int corner) {
    const uint32_t a = t[corner], b = t[(corner + 1) % 3], c = t[(corner + 2) % 3];
    const glm::vec3 n = in.normals[a];
    const glm::vec3 u = projected(in.positions[b] - in.positions[a], n);
    const glm::vec3 v = projected(in.positions[c] - in.positions[a], n);
    return std::acos(glm::clamp(glm::dot(u, v), -1.0f, 1.0f));
}

bool isZero(glm::vec3 v) { return v == glm::vec3(0); }

}  // namespace

std::vector<glm::vec4> generateTangents(const TangentInput& in) {
    const std::vector<uint32_t> welded = weld(in);
    std::vector<Face> faces(in.triangles.size());
    std::vector<glm::vec3> sums[2];  // by sign: [positive, negative]
    for (auto& s : sums) s.assign(in.positions.size(), glm::vec3(0));
    for (size_t f = 0; f < faces.size(); ++f) {
        const glm::uvec3 t = in.triangles[f];
        faces[f] = faceTangent(in, t);
        if (isZero(faces[f].tangent)) continue;
        for (int c = 0; c < 3; ++c)
            sums[faces[f].sign < 0][welded[t[c]]] +=
                projected(faces[f].tangent, in.normals[t[c]]) * cornerAngle(in, t, c);
    }
    std::vector<glm::vec4> corners(faces.size() * 3);
    for (size_t f = 0; f < faces.size(); ++f)
        for (int c = 0; c < 3; ++c) {
            const uint32_t v = in.triangles[f][c];
            // A triangle whose uv say nothing follows its neighbours.
            bool negative = faces[f].sign < 0;
            if (isZero(faces[f].tangent)) negative = isZero(sums[0][welded[v]]) &&
                                                     !isZero(sums[1][welded[v]]);
            glm::vec3 t = projected(sums[negative][welded[v]], in.normals[v]);
            if (isZero(t)) t = shading::frame_from_normal(in.normals[v]).t;
            corners[f * 3 + size_t(c)] = glm::vec4(t, negative ? -1.0f : 1.0f);
        }
    return corners;
}

}  // namespace gp
