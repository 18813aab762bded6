// Filtered GGX highlights as they are, not as wider GGX. Its tails stay where they are when a pixel
// blurs it; those of a wider GGX are higher everywhere. But GGX is a mixture of Gaussian slopes,
//   1 / (1 + x)^2 = int_0^inf e^-t t e^(-t x) dt,
// of squared widths alpha^2 / t chosen with the density e^-t, and each Gaussian takes the pixel's
// kernel exactly: alpha^2 / t + kernel. The integral is a sum over seven t, even in log t.
// Ours. That GGX is a Student's t-distribution of slopes, which are such mixtures: Ribardiere et
// al. 2017, "STD: Student's t-Distribution of Slopes for Microfacet Based BSDFs".
#ifndef GP_SHADING_SLOPE_NDF_MIXTURE_GLSL
#define GP_SHADING_SLOPE_NDF_MIXTURE_GLSL
#include "shading/slope/ndf_filtering.glsl"

// Half a step below the least t of the sum, and the step of log t.
#define NDF_MIXTURE_LEAST 0.00217463173f
#define NDF_MIXTURE_STEP 1.21887007f

// Of the slope in question: determinant and squared distance of the Gaussian alpha^2 u + kernel,
// u = 1 / t, are (n0 u + n1) u + n2 and (q0 u + q1) over that. All are sums of squares, so that
// kernels along a line, whose own determinant is 0, cost no digits.
struct NdfMixture {
    float n0;
    float n1;
    float n2;
    float q0;
    float q1;
};

NdfMixture ndf_mixture_at(vec2 s, vec2 alpha2, vec2 dh0, vec2 dh1) {
    vec3 unbounded = ndf_kernel(dh0, dh1);
    vec3 kernel = ndf_kernel_bounded(unbounded);
    float share = kernel.x + kernel.y > 0.0f
                      ? (kernel.x + kernel.y) / (unbounded.x + unbounded.y) : 0.0f;
    float scale = 2.0f * NDF_PIXEL_VARIANCE * share;
    float turned = scale * (dh0.x * dh1.y - dh0.y * dh1.x);
    float c0 = s.x * dh0.y - s.y * dh0.x;
    float c1 = s.x * dh1.y - s.y * dh1.x;
    NdfMixture m;
    m.n0 = alpha2.x * alpha2.y;
    m.n1 = alpha2.x * kernel.y + alpha2.y * kernel.x;
    m.n2 = turned * turned;
    m.q0 = s.x * s.x * alpha2.y + s.y * s.y * alpha2.x;
    m.q1 = scale * (c0 * c0 + c1 * c1);
    return m;
}

// One Gaussian; weight: t e^-t.
float ndf_mixture_part(IN(NdfMixture) m, float t, float weight) {
    float u = 1.0f / t;
    float det = (m.n0 * u + m.n1) * u + m.n2;
    return weight * inversesqrt(det) * exp(-(m.q0 * u + m.q1) / det);
}

// What smaller t have, which are the tails: the integral from 0 to the least t of Gaussians as
// wide as that, so that the kernel makes them lower but not wider.
float ndf_mixture_tails(IN(NdfMixture) m) {
    float u = 1.0f / NDF_MIXTURE_LEAST;
    float det = (m.n0 * u + m.n1) * u + m.n2;
    float x = 1.0f + m.q0 / m.n0;
    float y = NDF_MIXTURE_LEAST * x;
    float share = max(1.0f - exp(-y) * (1.0f + y), 0.0f);
    return share * u * inversesqrt(det) / (x * x * NDF_MIXTURE_STEP);
}

// The density of slopes but for a factor.
float ndf_mixture_sum(IN(NdfMixture) m) {
    return ndf_mixture_part(m, 0.004f, 0.00398403196f)
         + ndf_mixture_part(m, 0.0135334504f, 0.0133515299f)
         + ndf_mixture_part(m, 0.0457885697f, 0.0437392523f)
         + ndf_mixture_part(m, 0.154919334f, 0.132685972f)
         + ndf_mixture_part(m, 0.524148279f, 0.310326926f)
         + ndf_mixture_part(m, 1.77338368f, 0.301045376f)
         + ndf_mixture_part(m, 6.0f, 0.0148725131f)
         + ndf_mixture_tails(m);
}

// GGX of squared widths alpha2 (both above 0), blurred by the kernel that ndf_tokuyoshi adds for
// the same changes of the half vector h, over the wider GGX that is: 1 where nothing changes.
float ndf_mixture_shape(vec2 alpha2, vec3 h, vec3 dh0, vec3 dh1) {
    NdfMixture m = ndf_mixture_at(slope_of(h), alpha2, vec2(dh0.x, dh0.y), vec2(dh1.x, dh1.y));
    NdfMixture wide;
    wide.n0 = m.n0 + m.n1 + m.n2;
    wide.n1 = 0.0f;
    wide.n2 = 0.0f;
    wide.q0 = m.q0 + m.q1;
    wide.q1 = 0.0f;
    return ndf_mixture_sum(m) / ndf_mixture_sum(wide);
}

#endif
