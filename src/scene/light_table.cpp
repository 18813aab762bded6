#include "scene/light_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "scene/light_tree.h"
#include "shading/shading.h"

namespace gp {
namespace {

using shared::LightRecord;

constexpr float pi = 3.14159265f;

struct TexelSums {
    const Texture& texture;
    float decode[256];  // of one 8-bit channel

    explicit TexelSums(const Texture& t) : texture(t) {
        for (int i = 0; i < 256; ++i)
            decode[i] = t.colorSpace == ColorSpace::srgb
                ? shading::srgb_decode(glm::vec3(float(i) / 255)).x : float(i) / 255;
    }

    glm::vec3 texel(const MipLevel& level, int x, int y) const {
        const int w = int(level.width), h = int(level.height);
        x = ((x % w) + w) % w, y = ((y % h) + h) % h;  // clamped wraps differ only at the border
        const size_t i = size_t(y) * level.width + size_t(x);
        if (texture.format == PixelFormat::rgba8) {
            const auto* p = reinterpret_cast<const uint8_t*>(&texture.pixels[level.offset]) + 4 * i;
            return {decode[p[0]], decode[p[1]], decode[p[2]]};
        }
        const auto* p = reinterpret_cast<const float*>(&texture.pixels[level.offset]) + 4 * i;
        return {p[0], p[1], p[2]};
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

class TableBuilder {
public:
    explicit TableBuilder(const Scene& scene) : scene_(scene) {}

    LightTable run() {
        for (const auto& light : scene_.lights)
            if (light->kind == LightKind::directional) addDirectional(*light);
        table_.directionalCount = uint32_t(table_.lights.size());
        for (const auto& light : scene_.lights)
            if (light->kind != LightKind::directional) addLocal(*light);
        table_.lightMap.assign(scene_.instances.size(), NO_INDEX);
        for (size_t i = 0; i < scene_.instances.size(); ++i) addTriangles(uint32_t(i));
        table_.tree = makeLightTree(std::move(bounds_), table_.lights);
        return std::move(table_);
    }

private:
    void addDirectional(const Light& light) {
        if (!(shading::luminance(light.emission) > 0)) return;
        LightRecord r{};
        r.kind = LIGHT_DIRECTIONAL, r.direction = glm::normalize(light.direction);
        r.radius = light.angularRadius, r.emission = light.emission;
        table_.lights.push_back(r);
        table_.sources.push_back(&light);
    }

    // Each triangle is a light of its own: the tree knows best which part of a large polygon is
    // near.
    void addPolygon(const Light& light) {
        const std::vector<glm::vec3>& p = light.corners;
        for (size_t i = 1; i + 1 < p.size(); ++i) {
            LightRecord r{};
            r.kind = LIGHT_TRIANGLE, r.two_sided = light.twoSided, r.emission = light.emission;
            r.position = p[0], r.edge_u = p[i] - p[0], r.edge_v = p[i + 1] - p[0];
            r.instance = NO_INDEX, r.primitive = uint32_t(i) - 1;
            const glm::vec3 n = glm::cross(r.edge_u, r.edge_v);
            const float length = glm::length(n);
            r.direction = length > 0 ? n / length : light.direction, r.area = 0.5f * length;
            LightBounds b;
            b.lo = glm::min(p[0], glm::min(p[i], p[i + 1]));
            b.hi = glm::max(p[0], glm::max(p[i], p[i + 1]));
            b.axis = r.direction, b.twoSided = light.twoSided;
            b.phi = power(light.emission, r.area, light.twoSided);
            push(r, b);
            table_.sources.push_back(&light);
        }
    }

    void addLocal(const Light& light) {
        LightRecord r{};
        LightBounds b;
        const float l = shading::luminance(light.emission);
        if (!(l > 0)) return;
        if (light.kind == LightKind::polygon) return addPolygon(light);
        r.position = light.position, r.emission = light.emission, r.radius = light.radius;
        if (light.kind == LightKind::rectangle) {
            const glm::vec3 n = glm::cross(light.edgeU, light.edgeV);
            r.kind = LIGHT_RECTANGLE, r.edge_u = light.edgeU, r.edge_v = light.edgeV;
            r.area = glm::length(n), r.two_sided = light.twoSided;
            r.direction = n / r.area;
            for (int i = 0; i < 4; ++i) {
                const glm::vec3 p = r.position + float(i & 1) * r.edge_u + float(i >> 1) * r.edge_v;
                b.lo = i ? glm::min(b.lo, p) : p, b.hi = i ? glm::max(b.hi, p) : p;
            }
            b.axis = r.direction, b.twoSided = light.twoSided;
            b.phi = power(light.emission, r.area, light.twoSided);
        } else {
            r.kind = light.kind == LightKind::spot ? LIGHT_SPOT : LIGHT_SPHERE;
            // A sphere shines with the radiance that its disk needs for the intensity.
            if (light.radius > 0) r.emission /= pi * light.radius * light.radius;
            r.direction = glm::normalize(light.direction);
            r.cos_inner = light.cosInner, r.cos_outer = light.cosOuter;
            b.lo = r.position - r.radius, b.hi = r.position + r.radius;
            b.phi = 4 * pi * l;
            if (light.kind == LightKind::spot) {
                b.axis = r.direction, b.cosThetaO = 1, b.cosThetaE = light.cosOuter;
            } else {
                b.cosThetaO = -1;
            }
        }
        push(r, b);
        table_.sources.push_back(&light);
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
        LightBounds b;
        b.phi = power(radiance, r.area, twoSided);
        if (!(b.phi > 0) || !std::isfinite(b.phi)) return false;
        r.direction = n / length;
        b.lo = glm::min(p[0], glm::min(p[1], p[2])), b.hi = glm::max(p[0], glm::max(p[1], p[2]));
        b.axis = r.direction, b.twoSided = twoSided;
        push(r, b);
        ++table_.emissiveTriangles;
        return true;
    }

    void push(const LightRecord& record, LightBounds bounds) {
        bounds.light = uint32_t(table_.lights.size());
        bounds_.push_back(bounds);
        table_.lights.push_back(record);
    }

    const Scene& scene_;
    LightTable table_;
    std::vector<LightBounds> bounds_;
};

}  // namespace

LightTable makeLightTable(const Scene& scene) { return TableBuilder(scene).run(); }

}  // namespace gp
