// A ball on a floor under a square lamp and a bright sky, traced analytically with one path a
// pixel: what the denoisers get from a renderer, without one. Included after denoise_scene.h.
#pragma once

namespace gp::test {
namespace {

struct AnalyticScene {
    vec3 lampCorner{1.2f, 3.0f, 0.8f};  // 1 m x 1 m, facing down
    float lamp = 25, sky = 0.6f;
    vec3 ballCentre{0, 0.7f, 0};
    float ballRadius = 0.7f;

    struct Point {
        vec3 position, normal;
        bool sky, ball;
    };

    // The distance to the ball, or -1.
    float meetBall(vec3 o, vec3 d) const {
        const vec3 c = o - ballCentre;
        const float b = dot(c, d), q = b * b - dot(c, c) + ballRadius * ballRadius;
        if (q <= 0) return -1;
        const float t = -b - std::sqrt(q);
        return t > 1e-4f ? t : -1;
    }

    Point meet(vec3 o, vec3 d) const {
        const float ball = meetBall(o, d);
        if (ball > 0) {
            const vec3 p = o + d * ball;
            return {p, (p - ballCentre) / ballRadius, false, true};
        }
        const vec3 up(0, 1, 0);
        if (d.y < -1e-4f && -o.y / d.y < 40) return {o - d * (o.y / d.y), up, false, false};
        return {o, up, true, false};
    }

    // Light of the lamp over albedo, by a shadow ray to the point u of it.
    float direct(const Point& p, vec2 u) const {
        const vec3 to = lampCorner + vec3(u.x, 0, u.y) - p.position;
        const float square = dot(to, to);
        const vec3 d = to * inversesqrt(square);
        if (dot(d, p.normal) <= 0 || meetBall(p.position + p.normal * 1e-3f, d) > 0) return 0;
        return lamp * dot(d, p.normal) * std::max(d.y, 0.0f) / (square * PI);
    }

    // Light of the sky, and of the floor and the ball that it and the lamp light.
    float along(vec3 o, vec3 d, vec2 u) const {
        const Point p = meet(o, d);
        if (p.sky) return sky;
        return 0.5f * (direct(p, u) + 0.5f * sky * (1 + p.normal.y));
    }
    vec3 indirectFrom(const Point& p, vec2 u) const {
        return world_from_local(frame_from_normal(p.normal), square_to_cosine_hemisphere(u));
    }
    vec3 indirect(const Point& p, vec3 from, vec2 v) const {
        return vec3(along(p.position + p.normal * 1e-3f, from, v));
    }
};

// The scene seen by a camera that moves, over frames.
struct AnalyticSequence {
    AnalyticScene world;
    DenoiseScene s;
    float speed = 0.02f;  // metres a frame
    std::vector<vec4> was;   // of the last frame: positions
    std::vector<uint> seeds; // of the draws of each pixel

    explicit AnalyticSequence(ivec2 size) : s(size) { s.camera.up = vec3(0, 1, 0); }

    size_t index(ivec2 p) const { return size_t(p.y) * size_t(s.constants.size.x) + size_t(p.x); }

    CameraParams cameraOf(const Camera& c) const {
        return camera_look_at(CAMERA_PERSPECTIVE, c.position, c.target, c.up,
                              std::tan(0.5f * c.verticalFov),
                              float(s.constants.size.x) / float(s.constants.size.y));
    }

    AnalyticScene::Point pointAt(const CameraParams& c, ivec2 p) const {
        const Ray ray =
            camera_ray_through_lens(c, (vec2(p) + 0.5f) / vec2(s.constants.size), vec2(0));
        return world.meet(ray.origin, ray.direction);
    }

    LightPixel lightOf(const AnalyticScene::Point& p, uint seed) const {
        const auto u = [&](uint i) { return noise(ivec2(int(seed), 0), seed, i); };
        LightPixel l;
        if (p.sky) return l;
        l.direct = vec3(world.direct(p, vec2(u(0), u(1))));
        l.indirectFrom = world.indirectFrom(p, vec2(u(2), u(3)));
        l.indirect = world.indirect(p, l.indirectFrom, vec2(u(4), u(5)));
        return l;
    }

    void setPixel(const CameraParams& now, const CameraParams& before, ivec2 p) {
        const AnalyticScene::Point at = pointAt(now, p);
        SurfacePixel surface;
        if (at.sky) {
            surface.depth = DEPTH_NONE, surface.material.flags = REALTIME_SKY;
        } else {
            const vec3 film = camera_film_from_world(now, at.position);
            const vec3 old = camera_film_from_world(before, at.position);
            surface.depth = film.z;
            surface.normal = at.normal;
            surface.motion = vec4((vec2(old) - vec2(film)) * vec2(s.constants.size),
                                  old.z - film.z, 0);
            // Depth on the tangent plane, a pixel away.
            const vec3 view = (at.position - now.position) / film.z;
            const vec3 aside = now.right * (2 * now.half_x / float(s.constants.size.x));
            const vec3 up = now.up * (2 * now.half_y / float(s.constants.size.y));
            const float cosine = std::min(dot(at.normal, view), -0.02f);
            surface.motion.w = film.z * std::max(std::abs(dot(at.normal, aside)),
                                                 std::abs(dot(at.normal, up))) / -cosine;
        }
        s.setSurface(p, surface);
        const uint seed = hash_u32(uint(index(p)) + s.constants.frame_index * 0x9E3779B9u);
        s.setLight(p, lightOf(at, seed));
        was[index(p)] = vec4(at.position, at.sky ? 0.0f : 1.0f), seeds[index(p)] = seed;
    }

    // In each block a pixel that has one in the last frame repeats it.
    void repeatPixels(const std::vector<vec4>& before, const std::vector<uint>& oldSeeds) {
        const ivec2 size = s.constants.size, blocks = (size + 2) / 3;
        for (int y = 0; y < blocks.y; ++y)
            for (int x = 0; x < blocks.x; ++x) {
                const ivec2 p = s.repeatedPixel(ivec2(x, y));
                const vec4 motion = s.images.load_motion(p);
                const ivec2 old(int(std::floor(float(p.x) + 0.5f + motion.x)),
                                int(std::floor(float(p.y) + 0.5f + motion.y)));
                uint code = 0;
                if (s.constants.has_previous && was[index(p)].w > 0 && old.x >= 0 && old.y >= 0 &&
                    old.x < size.x && old.y < size.y && before[index(old)].w > 0 &&
                    distance(vec3(before[index(old)]), vec3(was[index(p)])) < 0.1f) {
                    const vec3 there(before[index(old)]);
                    AnalyticScene::Point at = {there, vec3(0, 1, 0), false, false};
                    if (at.position.y > 1e-3f)
                        at.normal = (at.position - world.ballCentre) / world.ballRadius;
                    s.setLight(p, lightOf(at, oldSeeds[index(old)]));
                    seeds[index(p)] = oldSeeds[index(old)];
                    const ivec2 cell = p - ivec2(3 * x, 3 * y);
                    code = uint(1 + cell.x + 3 * cell.y) | uint(old.x) << 4 | uint(old.y) << 18;
                }
                s.images.store_gradient_sample(ivec2(x, y), code);
            }
    }

    void frame(Denoiser denoiser) {
        const float x = speed * (float(s.constants.frame_index) - 20);
        s.camera.position = vec3(x, 1.5f, 4), s.camera.target = vec3(x, 0.5f, 0);
        if (!s.constants.has_previous) s.previousCamera = s.camera;
        const CameraParams now = cameraOf(s.camera), before = cameraOf(s.previousCamera);
        std::vector<vec4> old(size_t(s.constants.size.x * s.constants.size.y));
        std::vector<uint> oldSeeds(old.size());
        old.swap(was), oldSeeds.swap(seeds);
        old.resize(was.size()), oldSeeds.resize(seeds.size());
        s.forEach([&](ivec2 p) { setPixel(now, before, p); });
        repeatPixels(old, oldSeeds);
        s.denoise(denoiser);
    }

    // Direct plus indirect light over albedo; of `samples` paths, or as it was denoised.
    float reference(ivec2 p, uint samples) const {
        const AnalyticScene::Point at = pointAt(cameraOf(s.camera), p);
        double sum = 0;
        for (uint i = 0; i < samples; ++i) {
            const LightPixel l = lightOf(at, hash_u32(uint(index(p)) * 4099u + i));
            sum += l.direct.x + l.indirect.x;
        }
        return float(sum / samples);
    }
    float shown(ivec2 p) const {
        if (!isSurface(p)) return 0;
        return s.images.load_direct(p).x + s.images.load_indirect(p).x;
    }
    bool isSurface(ivec2 p) const { return s.images.load_depth(p) < DEPTH_NONE; }
};

}  // namespace
}  // namespace gp::test
