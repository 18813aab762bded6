#include "frame/realtime_read.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <immintrin.h>

#include "frame/heat_maps.h"
#include "shading/shading.h"
#include "shared/realtime_structs.h"
#include "shared/scene_structs.h"

namespace gp {
namespace {

using namespace glm;
using namespace gp::shading;
using namespace gp::shared;

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "backend/cpu/isa/image_access.h"

struct Reader : ImageAccess {
    RealtimeConstants constants{};

    explicit Reader(const RealtimeImages& all) : ImageAccess(all.views()) {
        constants.relights = all.filtered;
        constants.suns_apart = all.sunsApart;
    }
    const RealtimeConstants& load_realtime() const { return constants; }
#include "kernels/realtime/composite.glsl"
#include "kernels/realtime/gbuffer.glsl"

    // Numbers that a person can look at.
    vec4 shown(RealtimeImage, float v) { return vec4(v, v, v, 1); }
    vec4 shown(RealtimeImage, vec2 v) { return vec4(v, 0, 1); }
    vec4 shown(RealtimeImage, vec3 v) { return vec4(v, 1); }
    vec4 shown(RealtimeImage, vec4 v) { return v; }
    vec4 shown(RealtimeImage which, uint v) {
        if (which == RealtimeImage::normal || which == RealtimeImage::unmapped_normal ||
            which == RealtimeImage::indirect_from)
            return vec4(octahedral_decode(v), 1);
        if (which == RealtimeImage::barycentrics) {
            const vec2 b = unpack_barycentrics(v);
            return vec4(b, 1.0f - b.x - b.y, 1);
        }
        if (which == RealtimeImage::material) {
            const PixelMaterial m = unpack_material(v);
            return vec4(m.roughness, m.metallic, float(m.flags), float(m.mirrors));
        }
        return vec4(float(v), 0, 0, 1);
    }
    vec4 shown(RealtimeImage which, uvec2 v) {
        if (which == RealtimeImage::indirect_guide)
            return vec4(octahedral_decode(v.y), std::bit_cast<float>(v.x));
        return vec4(float(v.x), float(v.y), 0, 1);
    }

    vec4 layer(RealtimeImage which, ivec2 p) {
        switch (which) {
#define X(name, format, size, copies, memory, meaning) \
            case RealtimeImage::name: return shown(which, load_##name(p));
#include "shared/realtime_images.def"
#undef X
            default: return vec4(0);
        }
    }

    vec4 image(FrameImage which, ivec2 p) {
        const vec4 albedo = load_albedo(p), specular = load_specular_albedo(p);
        switch (which) {
            case FrameImage::albedo: return vec4(vec3(albedo) + vec3(specular), 1);
            case FrameImage::normal:
                return load_hit(p).x == HIT_NOTHING
                           ? vec4(0) : vec4(octahedral_decode(load_normal(p)), 0);
            case FrameImage::emission: return vec4(vec3(load_emission(p)), 1);
            case FrameImage::direct:
                return vec4(vec3(albedo) * vec3(load_direct(p)) +
                                vec3(specular) * vec3(load_specular(p)) +
                                (constants.suns_apart != 0u ? load_sun(p) : vec3(0)), 1);
            case FrameImage::indirect:
                return vec4(vec3(albedo) * composite_indirect(p), 1);
            case FrameImage::roughness: {
                const PixelMaterial m = unpack_material(load_material(p));
                return vec4(m.roughness, m.metallic, 0, 1);
            }
            default: return vec4(0);
        }
    }

    // As denoisers have found it. The channels' rays are independent, nearly.
    vec4 variance(ivec2 p) {
        if ((unpack_material(load_material(p)).flags & (REALTIME_SKY | REALTIME_UNLIT)) != 0u)
            return vec4(0);
        const vec3 of(load_direct_history(p).w, load_indirect_history_chroma(p / 3).w,
                      load_specular_history(p).w);
        const float diffuse = luminance(vec3(load_albedo(p)));
        const float specular = luminance(vec3(load_specular_albedo(p)));
        return vec4(diffuse * diffuse * (of.x + of.y) + specular * specular * of.z, of);
    }
};
#pragma GCC diagnostic pop

// For every pixel of the picture the one of `size` that lies under it.
template <class T, class F>
void eachPixel(const RealtimeImages& images, RealtimeSize which, T* out, const F& f) {
    const ivec2 output = images.views().size[size_t(RealtimeSize::OUTPUT)];
    const ivec2 size = images.views().size[size_t(which)];
    for (int y = 0; y < output.y; ++y)
        for (int x = 0; x < output.x; ++x)
            *out++ = f(nearestPixel(ivec2(x, y), output, size));
}

}  // namespace

void readRealtimeLayer(const RealtimeImages& images, RealtimeImage which, glm::vec4* pixels) {
    Reader reader(images);
    const RealtimeSize size = realtimeImageInfo(which).size;
    if (size == RealtimeSize::THIRD)  // its last blocks reach over the border
        eachPixel(images, RealtimeSize::FULL, pixels,
                  [&](ivec2 p) { return reader.layer(which, p / 3); });
    else
        eachPixel(images, size, pixels, [&](ivec2 p) { return reader.layer(which, p); });
}

void readHeatLayer(const HeatMaps& heat, const RealtimeImages& images, HeatLayer which,
                   glm::vec4* pixels) {
    Reader reader(images);
    const std::vector<float>& map =
        which == HeatLayer::rays ? heat.rays() : heat.microseconds();
    const size_t width = size_t(images.views().size[size_t(RealtimeSize::FULL)].x);
    eachPixel(images, RealtimeSize::FULL, pixels, [&](ivec2 p) {
        return which == HeatLayer::variance
                   ? reader.variance(p)
                   : vec4(vec3(map[size_t(p.y) * width + size_t(p.x)]), 1);
    });
}

void readRealtimeImage(const RealtimeImages& images, FrameImage which, void* pixels) {
    Reader reader(images);
    const RealtimeSize full = RealtimeSize::FULL;
    if (which == FrameImage::color) {
        eachPixel(images, RealtimeSize::OUTPUT, static_cast<vec4*>(pixels),
                  [&](ivec2 p) { return reader.load_output(p); });
    } else if (which == FrameImage::depth) {
        eachPixel(images, full, static_cast<float*>(pixels), [&](ivec2 p) {
            const float depth = reader.load_depth(p);
            return depth < DEPTH_NONE ? depth : std::numeric_limits<float>::infinity();
        });
    } else if (which == FrameImage::instance) {
        eachPixel(images, full, static_cast<uint32_t*>(pixels), [&](ivec2 p) {
            const uint instance = reader.load_hit(p).x;
            return instance < HIT_LIGHT ? instance + 1u : 0u;
        });
    } else {
        eachPixel(images, full, static_cast<vec4*>(pixels),
                  [&](ivec2 p) { return reader.image(which, p); });
    }
}

}  // namespace gp
