// Whether a point of the water breaks, as far as the waves of one cascade tell: the chance that the
// Jacobian is below a threshold, the waves of all other cascades being Gaussian.
// Based on: Dupuy and Bruneton 2012, "Real-time Animation and Rendering of Ocean Whitecaps", which
// takes the Jacobian itself as Gaussian. Ours: only the derivatives of the displacement are, and
// the Jacobian, which is skewed, follows from them.
//
// Of the stretch (xx, yy, xy) are u = (xx + yy) / 2, v = (xx - yy) / 2 and c = xy, with which the
// Jacobian is (1 + u)^2 - v^2 - c^2. It is below T where 1 + u < w = sqrt(T + v^2 + c^2). (And
// where 1 + u < -w, where water would be folded twice, which counts as breaking here too.)
#pragma once

namespace gp {

// Of u, v and c, over points and time.
struct StretchCovariance {
    float uu = 0.0f, vv = 0.0f, cc = 0.0f;
    float uv = 0.0f, uc = 0.0f, vc = 0.0f;
};

struct BreakingLaw {
    float threshold = 0.0f;    // T
    StretchCovariance others;  // of all waves that are not known; uu: breakingLeastWidth^2 or more
};

// The least deviation of u that is taken for unknown: without it the foam of a single cascade would
// have stairs for edges. Seas of several cascades have three times as much from 5 m/s on.
constexpr float breakingLeastWidth = 0.02f;

// How many standard deviations of the unknown waves the point is on the side of breaking; the
// chance of breaking is the normal distribution of it. Known: the stretch by the cascade's own
// waves. T is float, or several floats with reciprocalRoot(T).
// w is taken from mean and variance of its square, to second order. With the sea's covariances the
// chance over all points is that of the sea within a tenth.
template <class T>
T breakingMargin(const BreakingLaw& law, T xx, T yy, T xy) {
    const StretchCovariance& o = law.others;
    const T u = T(0.5f) * (xx + yy), v = T(0.5f) * (xx - yy), c = xy;
    const T vv(o.vv), cc(o.cc), vc(o.vc);
    const T mean = T(law.threshold + 1.0e-6f) + v * v + c * c + vv + cc;  // of w^2
    const T variance = T(4.0f) * (v * v * vv + c * c * cc + T(2.0f) * v * c * vc)
                     + T(2.0f) * (vv * vv + cc * cc + T(2.0f) * vc * vc);
    const T r = reciprocalRoot(mean);
    const T w = mean * r - T(0.125f) * variance * r * r * r;
    const T width = T(o.uu) + T(0.25f) * variance * r * r
                  - T(2.0f) * (v * T(o.uv) + c * T(o.uc)) * r;
    return (w - T(1.0f) - u) * reciprocalRoot(width);
}

}  // namespace gp
