#include "scene/light_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <tbb/parallel_for.h>

#include "scene/light_tree.h"
#include "scene/texel_decoder.h"
#include "shading/shading.h"

namespace gp {
namespace {

using shared::LightRecord;

constexpr float pi = 3.14159265f;

struct TexelSums {
    const Texture& texture;
    TexelDecoder decoder;

    explicit TexelSums(const Texture& t) : texture(t), decoder(t) {}

    glm::vec3 texel(const MipLevel& level, int x, int y) const {
        const int w = int(level.width), h = int(level.height);
        x = ((x % w) + w) % w, y = ((y % h) + h) % h;  // clamped wraps differ only at the border
        return decoder.at(level, size_t(y) * level.width + size_t(x));
    }

    // Mean over the box that holds the triangle, one texel wider, on the level where that box is at
    // most 8 texels wide. Not below what the triangle really has by more than the box is larger.
    glm::vec3 mean(const glm::vec2 uv[3]) const {
        const glm::vec2 lo = glm::min(uv[0], glm::min(uv[1], uv[2]));
        const glm::vec2 hi = glm::max(uv[0], glm::max(uv[1], uv[2]));
        size_t l = 0;
        const auto wide = [&](const MipLevel& m) {
            return std::max((hi.x - lo.x) * float(m.width), (hi.y - lo.y) * float(m.height)) > 8;
        };
        while (l + 1 < texture.levels.size() && wide(texture.levels[l])) ++l;
        const MipLevel& level = texture.levels[l];
        const int x0 = int(std::floor(lo.x * float(level.width))) - 1;
        const int y0 = int(std::floor(lo.y * float(level.height))) - 1;
        const int nx = std::min(int(std::ceil((hi.x - lo.x) * float(level.width))) + 3, 64);
        const int ny = std::min(int(std::ceil((hi.y - lo.y) * float(level.height))) + 3, 64);
        glm::vec3 sum{0};
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) sum += texel(level, x0 + x, y0 + y);
        return sum / float(nx * ny);
    }
};

float power(glm::vec3 radiance, float area, bool twoSided) {
    return shading::luminance(radiance) * pi * area * (twoSided ? 2.0f : 1.0f);
}

// Above this all lights together would be infinite, and their shares no numbers.
constexpr float mostPower = 1e30f;

LightCluster clusterOf(glm::vec3 lo, glm::vec3 hi, const LightCone& normals, float cosThetaE,
                       float phi, bool twoSided) {
    LightCluster c;
    c.lo = lo, c.hi = hi, c.normals = normals, c.cosThetaE = cosThetaE;
    c.thetaE = std::acos(cosThetaE), c.phi = std::min(phi, mostPower);
    c.twoSided = twoSided, c.count = 1;
    return c;
}

LightCluster clusterOfTriangle(const LightRecord& r, float phi) {
    const glm::vec3 a = r.position, b = a + r.edge_u, c = a + r.edge_v;
    return clusterOf(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)),
                     {r.direction, 0, 1}, 0, phi, r.two_sided != 0);
}

class TableBuilder {
public:
    TableBuilder(const Scene& scene, LightTable& table) : scene_(scene), table_(table) {}

    void run() {
        placeLights();
        tbb::parallel_for(size_t(0), scene_.lights.size(), [&](size_t i) { addLight(i); });
        table_.lightMap.assign(scene_.instances.size(), NO_INDEX);
        table_.lightOfTriangle.clear();
        table_.emissiveTriangles = 0;
        for (size_t i = 0; i < scene_.instances.size(); ++i) addTriangles(uint32_t(i));
        makeLightTree(table_.clusters, table_.lights, table_.tree);
    }

private:
    // How many records a light has: a polygon one for each triangle, since the tree knows best
    // which part of a large polygon is near.
    static uint32_t recordsOf(const Light& light) {
        if (!(shading::luminance(light.emission) > 0)) return 0;
        return light.kind == LightKind::polygon ? uint32_t(light.corners.size()) - 2 : 1;
    }

    // Gives each light the place of its first record, directional ones first, so that threads can
    // fill them.
    void placeLights() {
        const auto& lights = scene_.lights;
        places_.resize(lights.size());
        std::vector<uint32_t> counts(lights.size());
        std::vector<char> directional(lights.size());
        tbb::parallel_for(size_t(0), lights.size(), [&](size_t i) {
            counts[i] = recordsOf(*lights[i]);
            directional[i] = lights[i]->kind == LightKind::directional;
        });
        uint32_t next = 0;
        for (const bool wanted : {true, false}) {
            for (size_t i = 0; i < lights.size(); ++i)
                if (bool(directional[i]) == wanted) places_[i] = next, next += counts[i];
            if (wanted) table_.directionalCount = next;
        }
        table_.lights.resize(next), table_.sources.resize(next);
        table_.clusters.resize(next - table_.directionalCount);
    }

    void addLight(size_t index) {
        const Light& light = *scene_.lights[index];
        const uint32_t count = recordsOf(light);
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t place = places_[index] + i;
            LightRecord& r = table_.lights[place];
            r = {};
            r.emission = light.emission, r.two_sided = light.twoSided;
            table_.sources[place] = uint32_t(index);
            if (light.kind == LightKind::directional) {
                r.kind = LIGHT_DIRECTIONAL, r.direction = glm::normalize(light.direction);
                r.radius = light.angularRadius;
                continue;
            }
            LightCluster& c = table_.clusters[place - table_.directionalCount];
            if (light.kind == LightKind::polygon) c = fillPolygon(r, light, i);
            else if (light.kind == LightKind::rectangle) c = fillRectangle(r, light);
            else c = fillSphere(r, light);
            c.child = place | LIGHT_TREE_LEAF;
        }
    }

    static LightCluster fillPolygon(LightRecord& r, const Light& light, uint32_t part) {
        const std::vector<glm::vec3>& p = light.corners;
        r.kind = LIGHT_TRIANGLE, r.instance = NO_INDEX, r.primitive = part;
        r.position = p[0], r.edge_u = p[part + 1] - p[0], r.edge_v = p[part + 2] - p[0];
        const glm::vec3 n = glm::cross(r.edge_u, r.edge_v);
        const float length = glm::length(n);
        r.direction = length > 0 ? n / length : light.direction, r.area = 0.5f * length;
        return clusterOfTriangle(r, power(light.emission, r.area, light.twoSided));
    }

    static LightCluster fillRectangle(LightRecord& r, const Light& light) {
        const glm::vec3 n = glm::cross(light.edgeU, light.edgeV), p = light.position;
        r.kind = LIGHT_RECTANGLE, r.edge_u = light.edgeU, r.edge_v = light.edgeV, r.position = p;
        r.area = glm::length(n), r.direction = n / r.area;
        const glm::vec3 q = p + r.edge_u, s = p + r.edge_v, t = q + r.edge_v;
        return clusterOf(glm::min(glm::min(p, q), glm::min(s, t)),
                         glm::max(glm::max(p, q), glm::max(s, t)), {r.direction, 0, 1}, 0,
                         power(light.emission, r.area, light.twoSided), light.twoSided);
    }

    static LightCluster fillSphere(LightRecord& r, const Light& light) {
        const bool spot = light.kind == LightKind::spot;
        r.kind = spot ? LIGHT_SPOT : LIGHT_SPHERE, r.two_sided = 0;
        r.position = light.position, r.radius = light.radius;
        // A sphere shines with the radiance that its disk needs for the intensity.
        if (light.radius > 0) r.emission /= pi * light.radius * light.radius;
        r.direction = glm::normalize(light.direction);
        r.cos_inner = light.cosInner, r.cos_outer = light.cosOuter;
        return clusterOf(r.position - r.radius, r.position + r.radius,
                         spot ? LightCone{r.direction, 0, 1} : LightCone{r.direction, pi, -1},
                         spot ? light.cosOuter : 0, 4 * pi * shading::luminance(light.emission),
                         false);
    }

    void addTriangles(uint32_t instanceIndex) {
        const Instance& instance = *scene_.instances[instanceIndex];
        const Material& material = instance.surface();
        if (!(shading::luminance(material.emission) > 0) || material.unlit) return;
        // What bounced rays never meet lights nothing: their share of its light would be missing.
        if ((instance.visibility & visibleToBounce) == 0) return;
        const Mesh& mesh = *instance.mesh;
        const TextureUse& use = material.emissionTexture;
        const auto sums = use.texture ? std::make_unique<TexelSums>(*use.texture) : nullptr;
        const uint32_t offset = uint32_t(table_.lightOfTriangle.size());
        table_.lightOfTriangle.resize(offset + mesh.triangles.size(), NO_INDEX);
        bool any = false;
        for (size_t t = 0; t < mesh.triangles.size(); ++t) {
            glm::vec3 radiance = material.emission;
            if (sums) radiance *= sums->mean(uvs(mesh, mesh.triangles[t], use).data());
            const bool added = addTriangle(instance, mesh.triangles[t], radiance,
                                           material.doubleSided, instanceIndex, uint32_t(t));
            if (added) table_.lightOfTriangle[offset + t] = uint32_t(table_.lights.size() - 1);
            any |= added;
        }
        if (any) table_.lightMap[instanceIndex] = offset;
        else table_.lightOfTriangle.resize(offset);
    }

    static std::array<glm::vec2, 3> uvs(const Mesh& mesh, glm::uvec3 t, const TextureUse& use) {
        std::array<glm::vec2, 3> result;
        for (int i = 0; i < 3; ++i) {
            const glm::vec2 uv = use.texCoord == 0 ? mesh.vertices[t[i]].uv
                : mesh.uv1.empty() ? glm::vec2(0) : mesh.uv1[t[i]];
            result[size_t(i)] = use.uvTransform * glm::vec3(uv, 1);
        }
        return result;
    }

    bool addTriangle(const Instance& instance, glm::uvec3 t, glm::vec3 radiance, bool twoSided,
                     uint32_t instanceIndex, uint32_t primitive) {
        glm::vec3 p[3];
        for (int i = 0; i < 3; ++i)
            p[i] = instance.worldFromObject * glm::vec4(instance.mesh->positions[t[i]], 1);
        LightRecord r{};
        r.kind = LIGHT_TRIANGLE, r.two_sided = twoSided;
        // A mirroring transform turns the winding; the front stays the front (glTF 2.0, 3.7.4). The
        // edges change places, so that their cross product points to it; triangle_emission knows.
        if (glm::determinant(glm::mat3(instance.worldFromObject)) < 0) std::swap(p[1], p[2]);
        r.position = p[0], r.edge_u = p[1] - p[0], r.edge_v = p[2] - p[0];
        const glm::vec3 n = glm::cross(r.edge_u, r.edge_v);
        const float length = glm::length(n);
        r.area = 0.5f * length, r.emission = instance.surface().emission;
        r.instance = instanceIndex, r.primitive = primitive;
        const float phi = power(radiance, r.area, twoSided);
        if (!(phi > 0) || !std::isfinite(phi)) return false;
        r.direction = n / length;
        table_.clusters.push_back(clusterOfTriangle(r, phi));
        table_.clusters.back().child = uint32_t(table_.lights.size()) | LIGHT_TREE_LEAF;
        table_.lights.push_back(r);
        ++table_.emissiveTriangles;
        return true;
    }

    const Scene& scene_;
    LightTable& table_;
    std::vector<uint32_t> places_;  // of each light's first record
};

}  // namespace

void fillLightTable(const Scene& scene, LightTable& table) { TableBuilder(scene, table).run(); }

LightTable makeLightTable(const Scene& scene) {
    LightTable table;
    fillLightTable(scene, table);
    return table;
}

}  // namespace gp
