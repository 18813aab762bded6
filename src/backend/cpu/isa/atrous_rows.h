// atrous_filter (kernels/realtime/atrous.glsl) for runs of pixels at once: what each tap needs is
// unpacked once into arrays, over which the compiler's vectors run. The formulas are the kernel's
// own functions; tests/realtime holds the results together. Included inside struct Kernels.

static constexpr int atrousRun = 128, atrousMargin = 1 << (ATROUS_ITERATIONS - 1);
static constexpr int atrousWidth = atrousRun + 2 * atrousMargin;

// A run of one row with what its taps reach on both sides, unpacked.
struct AtrousRow {
    alignas(64) float light[2][4][atrousWidth];  // direct, specular: r, g, b, variance
    alignas(64) float luma[2][atrousWidth];
    alignas(64) float normal[3][atrousWidth];
    alignas(64) float depth[atrousWidth];
    alignas(64) float roughness[atrousWidth];
    alignas(64) uint surface[atrousWidth];  // MATERIAL_SURFACE_BITS; all ones outside of the image
};

// What the pixels of a run allow their neighbours (AtrousStops), and the sums so far.
struct AtrousRunState {
    alignas(64) float depthStops[2][atrousRun];  // straight, diagonal
    alignas(64) float specularNormal[atrousRun];
    alignas(64) float specularShare[atrousRun];
    alignas(64) float lumaStops[2][atrousRun];
    alignas(64) float sums[2][4][atrousRun];
    alignas(64) float weights[2][atrousRun];
};

static void unpackHalves(const std::byte* pixels, int count, float (*out)[atrousWidth], int first,
                         float* luma) {
    alignas(64) float mixed[4 * atrousWidth];
    for (int i = 0; i < count; ++i) {
        const vec4 v = FormatHALF4::read(pixels + size_t(i) * FormatHALF4::bytes);
        for (int c = 0; c < 4; ++c) mixed[4 * i + c] = v[c];
    }
    for (int i = 0; i < count; ++i) {
        for (int c = 0; c < 4; ++c) out[c][first + i] = mixed[4 * i + c];
        luma[first + i] = luminance(vec3(mixed[4 * i], mixed[4 * i + 1], mixed[4 * i + 2]));
    }
}

// The images that an iteration reads: as atrous_direct and atrous_specular choose them.
std::array<RealtimeImage, 2> atrousSources(int iteration) {
    if (iteration == 1) return {RealtimeImage::direct_history, RealtimeImage::specular_history};
    if (iteration == 3) return {RealtimeImage::direct_other, RealtimeImage::specular_other};
    return {RealtimeImage::direct, RealtimeImage::specular};
}

const std::byte* atrousPixel(RealtimeImage image, int bytes, int x, int y) {
    return images.current[size_t(image)] +
           (size_t(y) * size_t(constants.size.x) + size_t(x)) * size_t(bytes);
}

// Pixels [x0 - margin, x0 + run + margin) of row y; false: it is outside of the image.
bool unpackRow(int x0, int y, int iteration, AtrousRow& row) {
    if (y < 0 || y >= constants.size.y) return false;
    const int begin = std::max(x0 - atrousMargin, 0);
    const int end = std::min(x0 + atrousRun + atrousMargin, constants.size.x);
    const int first = begin - (x0 - atrousMargin), count = end - begin;
    const std::array<RealtimeImage, 2> sources = atrousSources(iteration);
    for (int channel = 0; channel < 2; ++channel)
        unpackHalves(atrousPixel(sources[size_t(channel)], 8, begin, y), count,
                     row.light[channel], first, row.luma[channel]);
    const auto* depth =
        reinterpret_cast<const float*>(atrousPixel(RealtimeImage::depth, 4, begin, y));
    const auto* normal =
        reinterpret_cast<const uint*>(atrousPixel(RealtimeImage::normal, 4, begin, y));
    const auto* material =
        reinterpret_cast<const uint*>(atrousPixel(RealtimeImage::material, 4, begin, y));
    for (int i = 0; i < atrousWidth; ++i) row.surface[i] = 0xFFFFFFFFu;
    for (int i = 0; i < count; ++i) {
        const vec3 n = octahedral_decode(normal[i]);
        row.normal[0][first + i] = n.x, row.normal[1][first + i] = n.y;
        row.normal[2][first + i] = n.z;
    }
    for (int i = 0; i < count; ++i) {
        row.depth[first + i] = depth[i];
        row.roughness[first + i] = material_roughness(material[i]);
        row.surface[first + i] = material[i] & MATERIAL_SURFACE_BITS;
    }
    return true;
}

// The stops of `count` pixels, and each pixel's own share in its sum.
void beginRun(int x0, int y, int count, int iteration, const AtrousRow& row,
              AtrousRunState& run) {
    const RealtimeConstants c = constants;
    const float step = float(1 << iteration);
    alignas(64) float slope[atrousRun], frames[2][atrousRun];
    for (int i = 0; i < count; ++i) {
        slope[i] = finite_or_zero(load_motion(ivec2(x0 + i, y)).w);
        const vec2 n = load_history_length(ivec2(x0 + i, y)) * 255.0f;
        frames[0][i] = n.x, frames[1][i] = n.y;
    }
    for (int i = 0; i < count; ++i) {
        const int at = i + atrousMargin;
        const float depth = row.depth[at], roughness = row.roughness[at];
        run.depthStops[0][i] = 1.0f / depth_allowance(depth, slope[i], step, c.filter_depth);
        run.depthStops[1][i] =
            1.0f / depth_allowance(depth, slope[i], 2.0f * step, c.filter_depth);
        run.specularNormal[i] = specular_normal_stop(roughness, c.filter_normal);
        run.specularShare[i] = specular_filter_share(roughness, iteration);
    }
    for (int channel = 0; channel < 2; ++channel) {
        for (int i = 0; i < count; ++i) {
            const int at = i + atrousMargin;
            run.lumaStops[channel][i] =
                luminance_stop(row.luma[channel][at], row.light[channel][3][at],
                               frames[channel][i], iteration, c.filter_luminance);
            run.weights[channel][i] = 1.0f;
        }
        for (int part = 0; part < 4; ++part)
            for (int i = 0; i < count; ++i)
                run.sums[channel][part][i] = row.light[channel][part][i + atrousMargin];
    }
}

// Adds the neighbours in row `tap` at a distance of dx pixels to the sums of row `row`.
void addTap(const AtrousRow& row, const AtrousRow& tap, int dx, bool diagonal, int count,
            AtrousRunState& run) {
    const float normalStop = constants.filter_normal, roughStop = constants.filter_roughness;
    const float kernel = diagonal ? 0.25f : 0.5f;
    const float* depthStops = run.depthStops[diagonal ? 1 : 0];
    const int to = atrousMargin + dx;
#if !defined(__clang__)  // which knows it by other words, and does without
#pragma GCC ivdep
#endif
    for (int i = 0; i < count; ++i) {
        const int own = i + atrousMargin, at = i + to;
        const float bend = 1.0f - (tap.normal[0][at] * row.normal[0][own] +
                                   tap.normal[1][at] * row.normal[1][own] +
                                   tap.normal[2][at] * row.normal[2][own]);
        const float apart = std::abs(tap.depth[at] - row.depth[own]) * depthStops[i];
        const float direct = std::abs(tap.luma[0][at] - row.luma[0][own]);
        const float specular = std::abs(tap.luma[1][at] - row.luma[1][own]);
        const float rough = std::abs(tap.roughness[at] - row.roughness[own]);
        const float same = tap.surface[at] == row.surface[own] ? kernel : 0.0f;
        const float w0 =
            same * edge_weight(apart + bend * normalStop + direct * run.lumaStops[0][i]);
        const float w1 = same * run.specularShare[i] *
                         edge_weight(apart + bend * run.specularNormal[i] + rough * roughStop +
                                     specular * run.lumaStops[1][i]);
        run.weights[0][i] += w0, run.weights[1][i] += w1;
        run.sums[0][0][i] += w0 * tap.light[0][0][at];
        run.sums[0][1][i] += w0 * tap.light[0][1][at];
        run.sums[0][2][i] += w0 * tap.light[0][2][at];
        run.sums[0][3][i] += w0 * tap.light[0][3][at];
        run.sums[1][0][i] += w1 * tap.light[1][0][at];
        run.sums[1][1][i] += w1 * tap.light[1][1][at];
        run.sums[1][2][i] += w1 * tap.light[1][2][at];
        run.sums[1][3][i] += w1 * tap.light[1][3][at];
    }
}

void endRun(int x0, int y, int count, int iteration, const AtrousRow& row,
            const AtrousRunState& run) {
    for (int i = 0; i < count; ++i) {
        const int at = i + atrousMargin;
        const bool lit = pixel_is_lit(row.surface[at], row.depth[at]);
        vec4 results[2];
        for (int channel = 0; channel < 2; ++channel) {
            const float scale = lit ? 1.0f / run.weights[channel][i] : 0.0f;
            for (int part = 0; part < 4; ++part)
                results[channel][part] = lit ? run.sums[channel][part][i] * scale
                                             : row.light[channel][part][at];
        }
        atrous_store(ivec2(x0 + i, y), iteration, results[0], results[1]);
    }
}

// Rows [y0, y1). Rows that are a step apart follow each other, so that each is unpacked about once.
void atrousRows(int y0, int y1, int iteration) {
    AtrousRow rows[3]{};  // numbers everywhere: what lies outside of the image is times zero
    AtrousRunState run;
    const int step = 1 << iteration;
    for (int x0 = 0; x0 < constants.size.x; x0 += atrousRun) {
        const int count = std::min(atrousRun, constants.size.x - x0);
        for (int phase = y0; phase < std::min(y0 + step, y1); ++phase) {
            bool there[3] = {unpackRow(x0, phase - step, iteration, rows[0]),
                             unpackRow(x0, phase, iteration, rows[1]), false};
            int above = 0;  // of the ring
            for (int y = phase; y < y1; y += step) {
                const int middle = (above + 1) % 3, below = (above + 2) % 3;
                there[below] = unpackRow(x0, y + step, iteration, rows[below]);
                const AtrousRow& row = rows[middle];
                beginRun(x0, y, count, iteration, row, run);
                for (int dy = -1; dy <= 1; ++dy) {
                    const int from = (above + dy + 1) % 3;
                    if (!there[from]) continue;
                    for (int dx = -1; dx <= 1; ++dx)
                        if (dx != 0 || dy != 0)
                            addTap(row, rows[from], dx * step, dx != 0 && dy != 0, count, run);
                }
                endRun(x0, y, count, iteration, row, run);
                above = middle;
            }
        }
    }
}
