// Luma and two differences of colours: most of what an eye sees is in the first.
// [Malvar and Sullivan 2003, "YCoCg-R: A Color Space with RGB Reversibility and Low Dynamic Range"]
#ifndef GP_SHADING_YCOCG_GLSL
#define GP_SHADING_YCOCG_GLSL
#include "shading/constants.glsl"

// (Y, Co, Cg); Y = (r + 2 g + b) / 4.
vec3 ycocg_from_rgb(vec3 c) {
    float co = c.x - c.z;
    float between = c.z + 0.5f * co;
    float cg = c.y - between;
    return vec3(between + 0.5f * cg, co, cg);
}

vec3 rgb_from_ycocg(vec3 c) {
    float between = c.x - 0.5f * c.z;
    float blue = between - 0.5f * c.y;
    return vec3(blue + c.y, c.z + between, blue);
}

#endif
