// temporal_filter (kernels/realtime/temporal.glsl) with load_neighbours for runs of pixels at once,
// over which the compiler's vectors run; the rest is the plain kernel, pixel by pixel. Included
// inside struct Kernels.

static constexpr int temporalRun = 128, temporalWidth = temporalRun + 2;

// A run of one row and a pixel on both sides. Where there is no pixel, depth is not a number.
struct TemporalRow {
    alignas(64) float depth[temporalWidth];
    alignas(64) float luma[2][temporalWidth];  // direct, specular
};

struct NeighbourRun {
    alignas(64) float allowance[temporalRun];
    alignas(64) float sum[2][temporalRun], squares[2][temporalRun], brightest[2][temporalRun];
    alignas(64) float count[temporalRun];
};

void unpackTemporalRow(int x0, int y, TemporalRow& row) {
    for (float& depth : row.depth) depth = std::numeric_limits<float>::quiet_NaN();
    if (y < 0 || y >= constants.size.y) return;
    const int begin = std::max(x0 - 1, 0), end = std::min(x0 + temporalRun + 1, constants.size.x);
    const size_t at = size_t(y) * size_t(constants.size.x) + size_t(begin);
    const std::byte* luma =
        images.current[size_t(RealtimeImage::luma)] + at * FormatPOSITIVE3::bytes;
    const std::byte* depth =
        images.current[size_t(RealtimeImage::depth)] + at * FormatFLOAT1::bytes;
    for (int i = 0; i < end - begin; ++i) {
        const int to = i + begin - (x0 - 1);
        const vec4 all = FormatPOSITIVE3::read(luma + size_t(i) * FormatPOSITIVE3::bytes);
        row.luma[0][to] = all.x, row.luma[1][to] = all.z;
        row.depth[to] = FormatFLOAT1::read(depth + size_t(i) * FormatFLOAT1::bytes);
    }
}

// As load_neighbours does for each pixel: what it skips is counted nought times here.
static void addNeighbours(const TemporalRow& row, const TemporalRow& tap, int dx, int count,
                          NeighbourRun& run) {
#if !defined(__clang__)
#pragma GCC ivdep
#endif
    for (int i = 0; i < count; ++i) {
        const int own = i + 1, at = i + 1 + dx;
        const bool like = std::abs(tap.depth[at] - row.depth[own]) <= run.allowance[i];
        const float direct = like ? tap.luma[0][at] : 0.0f;
        const float specular = like ? tap.luma[1][at] : 0.0f;
        run.brightest[0][i] = std::max(run.brightest[0][i], direct);
        run.brightest[1][i] = std::max(run.brightest[1][i], specular);
        run.sum[0][i] += direct, run.sum[1][i] += specular;
        run.squares[0][i] += direct * direct, run.squares[1][i] += specular * specular;
        run.count[i] += like ? 1.0f : 0.0f;
    }
}

void findNeighbours(int x0, int y, int count, const TemporalRow* const rows[3],
                    NeighbourRun& run) {
    const TemporalRow& row = *rows[1];
    for (int i = 0; i < count; ++i) {
        const float slope = finite_or_zero(load_motion(ivec2(x0 + i, y)).w);
        run.allowance[i] = neighbour_allowance(row.depth[i + 1], slope);
        run.count[i] = 0.0f;
        for (int channel = 0; channel < 2; ++channel) {
            const float luma = row.luma[channel][i + 1];
            run.sum[channel][i] = luma, run.squares[channel][i] = luma * luma;
            run.brightest[channel][i] = 0.0f;
        }
    }
    for (int dy = 0; dy < 3; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (dx != 0 || dy != 1) addNeighbours(row, *rows[dy], dx, count, run);
}

Neighbours neighboursOf(const NeighbourRun& run, int i) {
    Neighbours n;
    n.brightest = vec2(run.brightest[0][i], run.brightest[1][i]);
    n.count = int(run.count[i]);
    n.variance = neighbour_variance(vec2(run.sum[0][i], run.sum[1][i]),
                                    vec2(run.squares[0][i], run.squares[1][i]), n.count);
    return n;
}

// Rows [y0, y1).
void temporalRows(int y0, int y1, int mode) {
    TemporalRow rows[3];
    NeighbourRun run;
    for (int x0 = 0; x0 < constants.size.x; x0 += temporalRun) {
        const int count = std::min(temporalRun, constants.size.x - x0);
        for (TemporalRow& row : rows)
            for (auto& luma : row.luma) std::fill(std::begin(luma), std::end(luma), 0.0f);
        unpackTemporalRow(x0, y0 - 1, rows[0]);
        unpackTemporalRow(x0, y0, rows[1]);
        for (int y = y0; y < y1; ++y) {
            const int above = (y - y0) % 3;
            unpackTemporalRow(x0, y + 1, rows[(above + 2) % 3]);
            const TemporalRow* const around[3] = {&rows[above], &rows[(above + 1) % 3],
                                                  &rows[(above + 2) % 3]};
            findNeighbours(x0, y, count, around, run);
            for (int i = 0; i < count; ++i)
                temporal_pixel(ivec2(x0 + i, y), mode, neighboursOf(run, i));
        }
    }
}
