// One rectangle of pixels: part of the hot code, included inside an unnamed namespace by
// isa/kernels.h.

constexpr uint32_t maxTilePixels = 64;

// Adds one path to its pixel.
inline void addSample(PixelSums& s, const PathState& r) {
    const PathGuides& g = r.guides;
    const vec3 color = r.light.emission + r.light.direct + r.light.indirect;
    // A path whose numbers broke (0 * infinity in a hostile scene) counts as black, not as NaN.
    if (!(color.x + color.y + color.z < std::numeric_limits<float>::max())) {
        ++s.samples;
        return;
    }
    s.color += vec4(color, g.coverage);
    s.colorSquared += color * color;
    if ((s.samples & 1u) != 0) s.oddLuminance += luminance(color);
    s.emission += r.light.emission, s.direct += r.light.direct;
    if (g.instance != 0) {
        s.depth += g.depth, s.hits += 1;
        s.albedo += g.albedo, s.normal += g.normal;
        s.roughness += g.roughness, s.metallic += g.metallic;
    }
    if (s.samples++ == 0) s.instance = g.instance;
}

struct TilePixels {
    Ray rays[maxTilePixels];
    Hit hits[maxTilePixels];
    uint32_t alphaSeeds[maxTilePixels];  // each ray of a path gets one from the one before
    // Pixels, and what this sample has of each: its hash and where it is seen.
    uint32_t x[maxTilePixels], y[maxTilePixels], hashes[maxTilePixels];
    float offsetsX[maxTilePixels], offsetsY[maxTilePixels];
    PathState paths[maxTilePixels];
};

// All paths of the tile go from surface to surface together: while one is shaded, what the others
// will read is on its way to the cache, and the code of shading and of tracing stays there.
inline void tracePaths(Kernels& k, TilePixels& t, uint32_t count) {
    uint32_t active[maxTilePixels];
    for (uint32_t i = 0; i < count; ++i) active[i] = i;
    while (count > 0) {
        for (uint32_t n = 0; n < count; ++n) {
            k.expectTriangle(t.paths[active[n]].hit);
            k.path_expect(t.paths[active[n]]);
        }
        for (uint32_t n = 0; n < count; ++n) k.expectCorners(t.paths[active[n]].hit);
        uint32_t left = 0;
        for (uint32_t n = 0; n < count; ++n) {
            const uint32_t i = active[n];
            k.pathSeed = t.alphaSeeds[i];
            k.path_continue(t.paths[i]);
            t.alphaSeeds[i] = k.pathSeed;
            if (t.paths[i].ended == 0) active[left++] = i;
        }
        count = left;
        for (uint32_t n = 0; n < count; ++n) {
            const uint32_t i = active[n];
            k.pathSeed = t.alphaSeeds[i];
            t.paths[i].hit = k.trace_closest(t.paths[i].ray);
            t.alphaSeeds[i] = k.pathSeed;
        }
    }
}

// Where each pixel is seen. A copy of the loop for each filter, all inlined, so that the compiler
// makes vectors of it.
template <uint32_t pixelFilter>
[[gnu::flatten]] void offsetsBy(Kernels& k, const TileJob& job, TilePixels& t, uint32_t sample) {
    const float radius = job.frame->pixel_filter_radius;
    const uint32_t seed = job.frame->seed;
    for (uint32_t i = 0; i < maxTilePixels; ++i) {
        const Sampler draws = sampler_begin(uvec2(t.x[i], t.y[i]), sample, seed);
        const vec2 offset = k.camera_offset(pixelFilter, radius, draws);
        t.hashes[i] = draws.pixel_hash;
        t.offsetsX[i] = offset.x, t.offsetsY[i] = offset.y;
    }
}

inline void offsets(Kernels& k, const TileJob& job, TilePixels& t, uint32_t sample) {
    switch (job.frame->pixel_filter) {
        case FILTER_BLACKMAN_HARRIS: return offsetsBy<FILTER_BLACKMAN_HARRIS>(k, job, t, sample);
        case FILTER_GAUSSIAN: return offsetsBy<FILTER_GAUSSIAN>(k, job, t, sample);
        case FILTER_TENT: return offsetsBy<FILTER_TENT>(k, job, t, sample);
        default: return offsetsBy<FILTER_BOX>(k, job, t, sample);
    }
}

// A path for each pixel of the tile, with what its camera ray meets.
inline void beginSample(Kernels& k, const TileJob& job, const CameraParams& camera, TilePixels& t,
                        uint32_t count, uint32_t sample) {
    const RayCone cone = camera_ray_cone(camera, float(job.frame->height));
    offsets(k, job, t, sample);
    Sampler draws[maxTilePixels];
    for (uint32_t i = 0; i < count; ++i) {
        draws[i] = Sampler{t.hashes[i], sample, 0};
        t.rays[i] = k.camera_ray_of_pixel(camera, uvec2(t.x[i], t.y[i]),
                                          vec2(t.offsetsX[i], t.offsetsY[i]), draws[i]);
    }
    // A loop of its own, and in their place: copies wait until all parts have been written.
    for (uint32_t i = 0; i < count; ++i) {
        new (&t.paths[i]) PathState(k.path_begin(t.rays[i], cone, draws[i]));
        t.alphaSeeds[i] = hash_u32(draws[i].pixel_hash + sample * 0x9E3779B9u);
    }
    k.trace_camera(t.rays, t.alphaSeeds, t.hits, count);
    for (uint32_t i = 0; i < count; ++i) t.paths[i].hit = t.hits[i];
}

inline PixelSums& sumsOf(const TileJob& job, const TilePixels& t, uint32_t i) {
    return job.sums[size_t(t.y[i]) * job.frame->width + t.x[i]];
}

// What endSample will add to, on its way to the cache while paths are traced.
inline void expectSums(const TileJob& job, const TilePixels& t, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
        const char* bytes = reinterpret_cast<const char*>(&sumsOf(job, t, i));
        __builtin_prefetch(bytes, 1), __builtin_prefetch(bytes + sizeof(PixelSums) - 1, 1);
    }
}

inline void endSample(const TileJob& job, const CameraParams& camera, TilePixels& t,
                      uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
        PathState& path = t.paths[i];
        path.guides.depth *= dot(t.rays[i].direction, camera.forward);
        addSample(sumsOf(job, t, i), path);
    }
}

// All samples of the job; `finish` brings the paths of a sample to their ends.
template <class AnyKernels, class Finish>
TileCounts renderTile(AnyKernels& k, const TileJob& job, const Finish& finish) {
    k.recorder = job.recorder;
    initQuery(k.query, job.scene, nullptr, false);
    const CameraParams camera = cameraParams(*job.camera, job.frame->width, job.frame->height);
    TilePixels t;
    uint32_t count = 0;
    for (uint32_t y = job.y0; y < job.y1; ++y)
        for (uint32_t x = job.x0; x < job.x1; ++x) t.x[count] = x, t.y[count++] = y;
    for (uint32_t i = count; i < maxTilePixels; ++i) t.x[i] = t.y[i] = 0;
    // A render that was cancelled left some tiles further than others.
    const uint32_t held = job.sums[size_t(job.y0) * job.frame->width + job.x0].samples;
    for (uint32_t s = held > job.firstSample ? held - job.firstSample : 0; s < job.sampleCount;
         ++s) {
        beginSample(k, job, camera, t, count, job.firstSample + s);
        expectSums(job, t, count);
        finish(t, count);
        endSample(job, camera, t, count);
    }
    return k.counts;
}

inline TileCounts traceTile(const TileJob& job) {
    Kernels k(*job.scene, *job.frame);
    return renderTile(k, job, [&](TilePixels& t, uint32_t count) { tracePaths(k, t, count); });
}

inline void traceSkyRow(const SkyRowJob& job) {
    Kernels k(*job.scene, *job.frame);
    initQuery(k.query, job.scene, nullptr, false);
    for (uint32_t x = 0; x < job.size; ++x) {
        // The same for the same texel: coverage by chance must not flicker.
        k.pathSeed = hash_u32((job.face * job.size + job.row) * job.size + x);
        job.texels[x] = k.sky_cube_texel(job.face, uvec2(x, job.row), job.size, job.samples);
    }
}

inline void tonemapPixels(const PixelSums* sums, u8vec4* display, size_t count, float exposureEv,
                          uint32_t tonemap) {
    tonemapRow(
        [&](size_t i) {
            return sums[i].color * (sums[i].samples ? 1.0f / float(sums[i].samples) : 0.0f);
        },
        display, count, exposureEv, tonemap);
}
