// One film between two media: amplitudes at its faces, and the exact reflectance at one wavelength,
// all the ways back and forth inside of it added with their phases (Airy).
#ifndef GP_SHADING_THIN_FILM_GLSL
#define GP_SHADING_THIN_FILM_GLSL
#include "shading/complex.glsl"
#include "shading/constants.glsl"

// The film and the base may have any index; only the base absorbs. Both polarisations are s: across
// the plane of incidence, p: in it.
struct ThinFilm {
    float outside_ior;
    float film_ior;
    vec2 base_ior;        // n + i k, k as tables of metals print it
    float thickness_nm;
};

struct FilmAmplitude {
    vec2 s;
    vec2 p;
};

struct FilmReflectance {
    float s;
    float p;
};

// n cos(angle) in a medium, from n^2 and the square of n sin(angle), which no refraction changes.
vec2 film_normal_component(vec2 ior, float tangential2) {
    return complex_sqrt(complex_multiply(ior, ior) - vec2(tangential2, 0.0f));
}

// Reflected over incoming field where light goes from medium 1 to medium 2; q: normal components.
// s is (q1 - q2) / (q1 + q2), with q1^2 - q2^2 = n1^2 - n2^2 against cancellation; p follows from
// r_p / r_s = -cos(angle1 + angle2) / cos(angle1 - angle2).
// [Born and Wolf 1999, "Principles of Optics", section 1.5.2, equation 21]
FilmAmplitude film_amplitude(vec2 ior1, vec2 q1, vec2 ior2, vec2 q2, float tangential2) {
    vec2 sum = q1 + q2;
    vec2 difference = complex_multiply(ior1 - ior2, ior1 + ior2);
    vec2 product = complex_multiply(q1, q2);
    vec2 t = vec2(tangential2, 0.0f);
    FilmAmplitude r;
    // Both normal components vanish only where light grazes a boundary between equal media.
    r.s = dot(sum, sum) > 0.0f ? complex_divide(difference, complex_multiply(sum, sum))
                               : vec2(0.0f);
    // |product| reaches 0 for light along the surface, where tangential2 does not.
    r.p = -complex_multiply(r.s, complex_divide(product - t, product + t));
    return r;
}

// The sum of all ways: (r12 + r23 e) / (1 + r12 r23 e) with e the phase of one way there and back.
float airy_power(vec2 r12, vec2 r23, vec2 e) {
    vec2 back = complex_multiply(r23, e);
    vec2 r = complex_divide(r12 + back, vec2(1.0f, 0.0f) + complex_multiply(r12, back));
    return min(dot(r, r), 1.0f);
}

// Exact reflectance; cos_o in (0, 1] outside. Total reflection at the outer face is in it too, with
// the share that tunnels through a film thinner than the wavelength.
// [Born and Wolf 1999, "Principles of Optics", section 1.6.4, equation 58]
FilmReflectance airy_reflectance(IN(ThinFilm) film, float cos_o, float wavelength_nm) {
    float tangential2 = film.outside_ior * film.outside_ior * (1.0f - cos_o * cos_o);
    vec2 outside = vec2(film.outside_ior, 0.0f);
    vec2 inside = vec2(film.film_ior, 0.0f);
    vec2 q1 = vec2(film.outside_ior * cos_o, 0.0f);
    vec2 q2 = film_normal_component(inside, tangential2);
    vec2 q3 = film_normal_component(film.base_ior, tangential2);
    FilmAmplitude r12 = film_amplitude(outside, q1, inside, q2, tangential2);
    FilmAmplitude r23 = film_amplitude(inside, q2, film.base_ior, q3, tangential2);
    vec2 e = complex_exp_i(q2 * (FOUR_PI * film.thickness_nm / wavelength_nm));
    FilmReflectance reflectance;
    reflectance.s = airy_power(r12.s, r23.s, e);
    reflectance.p = airy_power(r12.p, r23.p, e);
    return reflectance;
}

#endif
