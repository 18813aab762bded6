// The origin of a ray that leaves a surface, moved off it so that it does not meet that surface.
#ifndef GP_SHADING_RAY_OFFSET_GLSL
#define GP_SHADING_RAY_OFFSET_GLSL

// One coordinate: by a fixed count of representable numbers, for the error of a hit point grows
// with its coordinates; near zero, where such steps vanish, by a fixed length.
float offset_coordinate(float p, float n) {
    float near_zero = 1.0f / 32.0f;
    float length_step = 1.0f / 65536.0f;
    float ulp_step = 256.0f;
    if (abs(p) < near_zero) {
        return p + length_step * n;
    }
    int steps = int(ulp_step * n);
    return intBitsToFloat(floatBitsToInt(p) + (p < 0.0f ? -steps : steps));
}

// `ng` is the unit geometric normal, on the side on which the ray leaves.
// [Waechter and Binder 2019, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing
//  Gems, chapter 6]
vec3 offset_ray_origin(vec3 p, vec3 ng) {
    return vec3(offset_coordinate(p.x, ng.x), offset_coordinate(p.y, ng.y),
                offset_coordinate(p.z, ng.z));
}

#endif
