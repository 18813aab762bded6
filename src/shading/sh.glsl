// Spherical harmonics up to l = 1: light around a point in four numbers a channel, enough for the
// light on a diffuse surface of any normal (90 % of its power and more).
// [Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps"]
#ifndef GP_SHADING_SH_GLSL
#define GP_SHADING_SH_GLSL
#include "shading/constants.glsl"
#include "shading/ycocg.glsl"

#define SH_Y0 0.282094791773878143474f  // sqrt(1 / (4 pi))
#define SH_Y1 0.488602511902919921586f  // sqrt(3 / (4 pi))

// The four basis functions; in place of the index m the axis: (1, x, y, z).
vec4 sh_basis(vec3 d) {
    return vec4(SH_Y0, SH_Y1 * d.x, SH_Y1 * d.y, SH_Y1 * d.z);
}

// A function on the sphere at direction d.
float sh_eval(vec4 sh, vec3 d) {
    return dot(sh, sh_basis(d));
}

// Irradiance at normal n from the radiance `sh`: the integral against max(cos, 0), which multiplies
// band 0 by pi and band 1 by 2 pi / 3. It may be negative opposite of a strong light: the exact
// irradiance there is small, and the truncated series rings around it.
float sh_irradiance(vec4 sh, vec3 n) {
    vec4 cosine_lobe = vec4(PI, 2.0f * PI / 3.0f, 2.0f * PI / 3.0f, 2.0f * PI / 3.0f);
    return dot(sh * cosine_lobe, sh_basis(n));
}

// Three channels, each with its directions.
struct ShRgb {
    vec4 r;
    vec4 g;
    vec4 b;
};

ShRgb sh_rgb_zero() {
    ShRgb sh;
    sh.r = vec4(0.0f);
    sh.g = vec4(0.0f);
    sh.b = vec4(0.0f);
    return sh;
}

// Adds light of `power` from direction d: radiance times solid angle (or radiance / pdf, over the
// number of samples).
ShRgb sh_rgb_add(IN(ShRgb) sh, vec3 d, vec3 power) {
    vec4 basis = sh_basis(d);
    ShRgb sum;
    sum.r = sh.r + basis * power.x;
    sum.g = sh.g + basis * power.y;
    sum.b = sh.b + basis * power.z;
    return sum;
}

vec3 sh_rgb_eval(IN(ShRgb) sh, vec3 d) {
    return vec3(sh_eval(sh.r, d), sh_eval(sh.g, d), sh_eval(sh.b, d));
}

vec3 sh_rgb_irradiance(IN(ShRgb) sh, vec3 n) {
    return vec3(sh_irradiance(sh.r, n), sh_irradiance(sh.g, n), sh_irradiance(sh.b, n));
}

// Half of the memory: directions for luma only, and one mean chroma: exact for light of one colour.
struct ShLuma {
    vec4 luma;
    vec2 chroma;  // Co and Cg of band 0
};

ShLuma sh_luma_zero() {
    ShLuma sh;
    sh.luma = vec4(0.0f);
    sh.chroma = vec2(0.0f);
    return sh;
}

ShLuma sh_luma_add(IN(ShLuma) sh, vec3 d, vec3 power) {
    vec3 c = ycocg_from_rgb(power);
    ShLuma sum;
    sum.luma = sh.luma + sh_basis(d) * c.x;
    sum.chroma = sh.chroma + SH_Y0 * vec2(c.y, c.z);
    return sum;
}

// The colour of luma `y`, the chroma in proportion to it; never negative.
vec3 sh_luma_colour(IN(ShLuma) sh, float y) {
    float luma = max(y, 0.0f);
    float share = sh.luma.x > 0.0f ? luma / sh.luma.x : 0.0f;
    return max(rgb_from_ycocg(vec3(luma, sh.chroma * share)), vec3(0.0f));
}

vec3 sh_luma_irradiance(IN(ShLuma) sh, vec3 n) {
    return sh_luma_colour(sh, sh_irradiance(sh.luma, n));
}

#endif
