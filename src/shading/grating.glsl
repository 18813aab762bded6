// A grating: parallel grooves of one period, which split light into orders. Grooves run along the
// bitangent; the order m of a wavelength leaves at
//
//   (wo + wi).x = m wavelength / period,   (wo + wi).y = 0,
//
// sin_o + sin_i = m wavelength / period where the plane of incidence lies across the grooves. How
// much light an order gets is scalar theory: the Fourier coefficients of the wave's phase after
// reflection by the profile, whose squares sum up to 1.
#ifndef GP_SHADING_GRATING_GLSL
#define GP_SHADING_GRATING_GLSL
#include "shading/constants.glsl"

#define GRATING_SINUSOIDAL 0u
#define GRATING_BINARY 1u

struct Grating {
    uint profile;     // GRATING_…
    float period_nm;
    float depth_nm;   // from the lowest to the highest
    float duty;       // share of the period that is high, of binary ones
};

// The Bessel function of an integer order n >= 0, x >= 0: from an order where it is practically 0
// downwards, where the recurrence is stable, and normalised by J0 + 2 (J2 + J4 + ...) = 1. Absolute
// error 1e-7 up to x = 40.
// [Abramowitz and Stegun 1964, "Handbook of Mathematical Functions", section 9.12, example 1]
float bessel_j(int n, float x) {
    if (x < 1.0e-4f) {
        return n == 0 ? 1.0f : n == 1 ? 0.5f * x : 0.0f;
    }
    int top = 2 * ((max(n, int(x)) + 8 + int(2.0f * sqrt(x))) / 2 + 4);
    float next = 0.0f;
    float here = 1.0e-20f;
    float sum = 0.0f;
    float result = 0.0f;
    for (int k = top; k > 0; --k) {
        float below = 2.0f * float(k) / x * here - next;
        next = here;
        here = below;
        // here is now the order k - 1, up to a factor.
        if (abs(here) > 1.0e10f) {
            here *= 1.0e-20f;
            next *= 1.0e-20f;
            sum *= 1.0e-20f;
            result *= 1.0e-20f;
        }
        if (k - 1 == n) {
            result = here;
        }
        if ((k - 1) % 2 == 0) {
            sum += k == 1 ? here : 2.0f * here;
        }
    }
    return result / sum;
}

// The share of light that the order m gets if the highest and the lowest part of the profile send
// it back with `phase` between them; over all orders the shares sum up to 1. Binary: [Magnusson and
// Gaylord 1978, JOSA 68(6)]; sinusoidal, J_m^2 of half the phase: [Goodman 2005, "Introduction to
// Fourier Optics", section 4.4.4]
float grating_efficiency(IN(Grating) g, int order, float phase) {
    int m = abs(order);
    if (g.profile == GRATING_SINUSOIDAL) {
        // Beyond its argument J falls faster than exponentially.
        if (float(m) > 0.5f * phase + 14.0f) {
            return 0.0f;
        }
        float j = bessel_j(m, 0.5f * phase);
        return j * j;
    }
    float s = sin(0.5f * phase);
    if (m == 0) {
        return 1.0f - 4.0f * g.duty * (1.0f - g.duty) * s * s;
    }
    float c = 2.0f * sin(PI * float(m) * g.duty) / (PI * float(m));
    return c * c * s * s;
}

// The phase between top and bottom, from both ways.
// [Harvey and Vernold 1998, Applied Optics 37(34)]
float grating_phase(IN(Grating) g, float cos_o, float cos_i, float nm) {
    return TWO_PI * g.depth_nm * (cos_o + cos_i) / nm;
}

// The cosine at which the order leaves; 0 if it does not (an evanescent wave).
float grating_order_cosine(IN(Grating) g, vec3 w, int order, float nm) {
    float x = float(order) * nm / g.period_nm - w.x;
    return sqrt(max(1.0f - x * x - w.y * w.y, 0.0f));
}

// The highest order that leaves on the side of rising x.
int grating_highest_order(IN(Grating) g, vec3 w, float nm) {
    float rim = sqrt(max(1.0f - w.y * w.y, 0.0f));
    return int(floor(max(rim + w.x, 0.0f) * g.period_nm / nm));
}

// The lowest; 0 or negative, as the mirror direction is always there.
int grating_lowest_order(IN(Grating) g, vec3 w, float nm) {
    return -grating_highest_order(g, vec3(-w.x, w.y, w.z), nm);
}

// The efficiency of an order at its own direction.
float grating_order_efficiency(IN(Grating) g, vec3 w, int order, float nm) {
    float cos_m = grating_order_cosine(g, w, order, nm);
    return grating_efficiency(g, order, grating_phase(g, w.z, cos_m, nm));
}

// The efficiencies of all orders that leave, without the mirror image.
float grating_side_total(IN(Grating) g, vec3 w, float nm) {
    float sum = 0.0f;
    int last = grating_highest_order(g, w, nm);
    for (int m = grating_lowest_order(g, w, nm); m <= last; ++m) {
        sum += m == 0 ? 0.0f : grating_order_efficiency(g, w, m, nm);
    }
    return sum;
}

// And with it. Since each order has a phase of its own, this is not exactly 1, and may be above: at
// grazing angles up to 1.8.
float grating_total(IN(Grating) g, vec3 w, float nm) {
    return grating_side_total(g, w, nm) + grating_order_efficiency(g, w, 0, nm);
}

// The efficiency of an order from wo to wi, brought down where all orders of either direction
// together would return more than comes; total_…: grating_total of both. The same for both ways,
// which a division by the total of one direction alone would not be; ours.
float grating_order_share(IN(Grating) g, vec3 wo, vec3 wi, int order, float nm, float total_o,
                          float total_i) {
    float share = grating_efficiency(g, order, grating_phase(g, wo.z, wi.z, nm));
    return share / max(1.0f, max(total_o, total_i));
}

#endif
