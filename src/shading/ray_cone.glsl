// Ray cones: the footprint of a pixel carried along its path in two numbers, for the level of
// detail of textures.
// [Akenine-Moller et al. 2021, "Improved Shader and Texture Level of Detail Using Ray Cones",
//  JCGT 10(1)]
#ifndef GP_SHADING_RAY_CONE_GLSL
#define GP_SHADING_RAY_CONE_GLSL
#include "shading/trigonometry.glsl"

struct RayCone {
    float width;   // at the ray's origin, metres; negative after a focus
    float spread;  // full angle, radians, for small angles; negative while the cone narrows
};

// The cone at the hit, which is also the start of the next ray.
RayCone ray_cone_propagate(IN(RayCone) cone, float distance) {
    RayCone next;
    next.width = cone.width + cone.spread * distance;
    next.spread = cone.spread;
    return next;
}

// A bounce off a rough surface widens the cone by the spread of its lobe. Its half vector has
// slopes of standard deviation alpha / sqrt(2) (exactly so for Beckmann; the infinite variance of
// GGX comes from a tail that texture filtering should not follow), a reflection turns by twice
// the angle of the half vector, and a lobe counts from minus to plus one deviation. Variances add
// up.
RayCone ray_cone_bounce(IN(RayCone) cone, float alpha) {
    float lobe = 4.0f * TWO_PI * turns_from_vector(alpha * 0.70710678f, 1.0f);
    RayCone next;
    next.width = cone.width;
    next.spread = sqrt(cone.spread * cone.spread + lobe * lobe);
    // A narrowing cone goes on narrowing unless the lobe is the wider of the two.
    if (cone.spread < 0.0f && lobe < -cone.spread) {
        next.spread = -next.spread;
    }
    return next;
}

// The level of a texture, but for the logarithm of its size (half of that of its texels), where the
// cone meets a triangle under cos_theta; uv_area, world_area: of the triangle, both of them or both
// twice. We depart from the book in one place: it divides the width by the cosine, which gives the
// long axis of the footprint; we take the geometric mean of both axes, as the many samples of a
// pixel average along the long one anyway and a blurred texture cannot be sharpened again.
// [Akenine-Moller et al. 2019, Ray Tracing Gems, chapter 20, equations 3 and 34]
float ray_cone_lod(IN(RayCone) cone, float uv_area, float world_area, float cos_theta) {
    float width = max(abs(cone.width), 1.0e-8f);
    float cosine = max(abs(cos_theta), 1.0e-4f);
    float density = max(uv_area, 1.0e-20f) / max(world_area, 1.0e-20f);
    return 0.5f * log2(max(density * (width * width) / cosine, 1.0e-37f));
}

#endif
