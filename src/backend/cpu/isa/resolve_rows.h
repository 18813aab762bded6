// realtime_resolve (kernels/realtime/resolve.glsl) for runs of pixels of the picture at once:
// samples are encoded once for all the pixels that they lie around, and the compiler's vectors run
// over the pixels. The formulas are the kernel's own functions; tests/realtime holds the results
// together. Included inside struct Kernels.

static constexpr int resolveRun = 128, resolveWidth = resolveRun + 2;

// Samples of one row, encoded; pixels outside of the image are those at its border.
struct ResolveRow {
    alignas(64) float color[4][resolveWidth];
    alignas(64) float depth[resolveWidth];
};

struct ResolveRunState {
    alignas(64) float wx[3][resolveRun];
    alignas(64) int column[resolveRun];  // of the middle sample, in the rows
    alignas(64) float sum[4][resolveRun], squares[4][resolveRun], here[4][resolveRun];
    alignas(64) float nearest[resolveRun];
    alignas(64) int nearestTap[resolveRun];
    alignas(64) float history[4][resolveRun];
    alignas(64) float historyX[4][resolveRun], historyY[4][resolveRun];
    alignas(64) int firstX[resolveRun], firstY[resolveRun];
    bool wasSeen[resolveRun];
};

void encodeRun(float (*c)[resolveWidth], int count) {
#if !defined(__clang__)
#pragma GCC ivdep
#endif
    for (int i = 0; i < count; ++i) {
        const vec4 e = resolve_encoded(vec4(c[0][i], c[1][i], c[2][i], c[3][i]));
        c[0][i] = e.x, c[1][i] = e.y, c[2][i] = e.z, c[3][i] = e.w;
    }
}

// Columns [first, first + count) of row y.
void encodeRow(int first, int count, int y, ResolveRow& row) {
    const int inside = std::clamp(y, 0, constants.size.y - 1);
    for (int i = 0; i < count; ++i) {
        const ivec2 p(std::clamp(first + i, 0, constants.size.x - 1), inside);
        const vec4 c = load_color(p);
        for (int k = 0; k < 4; ++k) row.color[k][i] = c[k];
        row.depth[i] = load_depth(p);
    }
    encodeRun(row.color, count);
}

// `same`: rays and picture are of one size, and columns follow each other.
template <bool same>
static void addSamples(const ResolveRow& row, int dx, float wy, int tap, int count,
                       ResolveRunState& run) {
    const float* wx = run.wx[dx + 1];
#if !defined(__clang__)
#pragma GCC ivdep
#endif
    for (int i = 0; i < count; ++i) {
        const int at = (same ? i + 1 : run.column[i]) + dx;
        const float weight = wx[i] * wy;
        const float r = row.color[0][at], g = row.color[1][at];
        const float b = row.color[2][at], a = row.color[3][at];
        run.sum[0][i] += r, run.sum[1][i] += g, run.sum[2][i] += b, run.sum[3][i] += a;
        run.squares[0][i] += r * r, run.squares[1][i] += g * g;
        run.squares[2][i] += b * b, run.squares[3][i] += a * a;
        run.here[0][i] += r * weight, run.here[1][i] += g * weight;
        run.here[2][i] += b * weight, run.here[3][i] += a * weight;
        const bool nearer = row.depth[at] < run.nearest[i];
        run.nearest[i] = nearer ? row.depth[at] : run.nearest[i];
        run.nearestTap[i] = nearer ? tap : run.nearestTap[i];
    }
}

// Where the pixels were in the last picture, and how its pixels there count.
void findHistory(int x0, int y, int count, vec2 scale, ResolveRunState& run) {
    const ivec2 last = constants.size - 1;
    const vec2 size(constants.output_size);
    for (int i = 0; i < count; ++i) {
        const vec2 point = vec2(float(x0 + i), float(y)) + 0.5f;
        const vec2 at = point / scale;
        const ivec2 centre(int(std::floor(at.x)), int(std::floor(at.y)));
        const int tap = run.nearestTap[i];
        const vec4 motion =
            load_motion(clamp(centre + ivec2(tap % 3 - 1, tap / 3 - 1), ivec2(0), last));
        const vec2 before = point + vec2(motion.x, motion.y) * scale;
        run.wasSeen[i] = constants.has_previous != 0 && resolve_is_inside(before, size) &&
                         resolve_was_open(before / scale, run.nearest[i] + motion.z);
        const vec2 from = run.wasSeen[i] ? before - 0.5f : vec2(0);
        const vec2 corner = floor(from);
        const vec4 wx = catmull_rom_weights(from.x - corner.x);
        const vec4 wy = catmull_rom_weights(from.y - corner.y);
        for (int k = 0; k < 4; ++k) run.historyX[k][i] = wx[k], run.historyY[k][i] = wy[k];
        run.firstX[i] = int(corner.x) - 1, run.firstY[i] = int(corner.y) - 1;
    }
}

static bool countsAnywhere(const float* weights, int count) {
    return std::any_of(weights, weights + count, [](float w) { return w != 0.0f; });
}

// resolve_history of the run: one of the sixteen pixels after the other.
void addHistory(int count, ResolveRunState& run) {
    for (auto& channel : run.history) std::fill(channel, channel + count, 0.0f);
    const ivec2 last = constants.output_size - 1;
    alignas(64) float tap[4][resolveWidth];
    for (int j = 0; j < 4; ++j) {
        if (!countsAnywhere(run.historyY[j], count)) continue;
        for (int k = 0; k < 4; ++k) {
            if (!countsAnywhere(run.historyX[k], count)) continue;
            for (int i = 0; i < count; ++i) {
                const vec4 c = load_previous_output(
                    clamp(ivec2(run.firstX[i] + k, run.firstY[i] + j), ivec2(0), last));
                tap[0][i] = c.x, tap[1][i] = c.y, tap[2][i] = c.z, tap[3][i] = c.w;
            }
            encodeRun(tap, count);
            for (int c = 0; c < 4; ++c)
                for (int i = 0; i < count; ++i)
                    run.history[c][i] +=
                        tap[c][i] * (run.historyX[k][i] * run.historyY[j][i]);
        }
    }
}

static vec4 fourOf(const float (*channels)[resolveRun], int i) {
    return vec4(channels[0][i], channels[1][i], channels[2][i], channels[3][i]);
}

void resolveRunOf(int x0, int y, int count, ResolveRow (&rows)[3], ResolveRunState& run) {
    const vec2 scale = vec2(constants.output_size) / vec2(constants.size);
    const bool same = constants.output_size == constants.size;
    const float atY = (float(y) + 0.5f) / scale.y;
    const int centreY = int(std::floor(atY));
    const int first = int(std::floor((float(x0) + 0.5f) / scale.x)) - 1;
    const int end = int(std::floor((float(x0 + count - 1) + 0.5f) / scale.x)) + 2;
    for (int k = 0; k < 3; ++k) encodeRow(first, end - first, centreY - 1 + k, rows[k]);
    const vec3 wy = resolve_weights(atY, centreY, constants.jitter.y, scale.y, constants.size.y);
    for (int i = 0; i < count; ++i) {
        const float at = (float(x0 + i) + 0.5f) / scale.x;
        const int centre = int(std::floor(at));
        const vec3 wx =
            resolve_weights(at, centre, constants.jitter.x, scale.x, constants.size.x);
        for (int k = 0; k < 3; ++k) run.wx[k][i] = wx[k];
        run.column[i] = centre - first;
        run.nearest[i] = FLOAT_MAX, run.nearestTap[i] = 4;
    }
    for (int c = 0; c < 4; ++c)
        for (int i = 0; i < count; ++i)
            run.sum[c][i] = run.squares[c][i] = run.here[c][i] = 0.0f;
    for (int tap = 0; tap < 9; ++tap)
        (same ? addSamples<true> : addSamples<false>)(rows[tap / 3], tap % 3 - 1, wy[tap / 3],
                                                      tap, count, run);
    findHistory(x0, y, count, scale, run);
    addHistory(count, run);
    for (int i = 0; i < count; ++i) {
        const vec3 wx(run.wx[0][i], run.wx[1][i], run.wx[2][i]);
        const Neighbourhood n = resolve_neighbourhood(fourOf(run.sum, i), fourOf(run.squares, i),
                                                      fourOf(run.here, i), wx, wy);
        store_output(ivec2(x0 + i, y),
                     resolve_mixed(n, fourOf(run.history, i), run.wasSeen[i]));
    }
}

// Rows [y0, y1) of the picture.
void resolveRows(int y0, int y1) {
    ResolveRow rows[3];
    ResolveRunState run;
    for (int y = y0; y < y1; ++y)
        for (int x0 = 0; x0 < constants.output_size.x; x0 += resolveRun) {
            const int count = std::min(resolveRun, constants.output_size.x - x0);
            if (constants.resolves != 0)
                resolveRunOf(x0, y, count, rows, run);
            else
                for (int i = 0; i < count; ++i) realtime_resolve(ivec2(x0 + i, y), 0);
        }
}
