// Reading what surrounds a scene by direction and level of detail: part of the hot code, compiled
// for each instruction set. Included inside an unnamed namespace by isa/local.inc only.

// Bilinear. The border of a face has the texels beyond its edges.
inline vec3 sampleSkyLevel(const SkyLevelView& level, const CubePoint& p) {
    const float n = float(level.size);
    const float x = p.st.x * n + 0.5f, y = p.st.y * n + 0.5f;
    const int ix = std::min(int(x), int(level.size)), iy = std::min(int(y), int(level.size));
    const float ax = x - float(ix), ay = y - float(iy);
    const size_t row = level.size + 2;
    const vec3* t = level.texels + (p.face * row + size_t(iy)) * row + size_t(ix);
    return mix(mix(t[0], t[1], ax), mix(t[row], t[row + 1], ax), ay);
}

// Between two levels.
inline vec3 sampleSkyPyramid(const SkyPyramidView& sky, vec3 direction, float level) {
    const float last = float(sky.levelCount - 1);
    const float within = level > 0.0f ? std::min(level, last) : 0.0f;
    const int fine = int(within);
    const float share = within - float(fine);
    const CubePoint p = cube_point(direction);
    const vec3 found = sampleSkyLevel(sky.levels[fine], p);
    return share > 0.0f ? mix(found, sampleSkyLevel(sky.levels[fine + 1], p), share) : found;
}
