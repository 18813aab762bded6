// The numbers behind docs/images/masking.png: for views along the mean slope, what V-cavities leave
// visible and reflect, tilted (earlier work) and sheared (ours). One block a mean slope; columns:
// view in degrees, visible area over A(wo), albedo, of the tilted and then of the sheared form.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>

#include "water/slope_quadrature.h"

GP_SHADING_BEGIN
#include "shading/slope/tilted_cavity.glsl"
GP_SHADING_END

using namespace gp::shading;
using namespace gp::test;

namespace {

struct Numbers {
    double visible;
    double albedo;  // of a white mirror, over A(wo)
};

Numbers numbersOf(const Slopes& d, vec3 wo, bool tilted) {
    const SlopeGrid grid{300, 7.0};
    const double area = double(slope_facing(d.mean, wo));
    const double visible = meanOverSlopes(d, [&](vec2 s) {
        const float facing = std::max(slope_facing(s, wo), 0.0f);
        return facing * (tilted ? tilted_cavity_g1(s, wo) : sheared_cavity_g1(d.mean, s, wo));
    }, grid);
    const double reflected = meanOverSlopes(d, [&](vec2 s) {
        const float facing = std::max(slope_facing(s, wo), 0.0f);
        const vec3 wi = reflect(-wo, facet_of(s));
        return facing * (tilted ? tilted_cavity_g2(d.mean, s, wo, wi)
                                : sheared_cavity_g2(d.mean, s, wo, wi));
    }, grid);
    return {visible / area, reflected / area};
}

}  // namespace

int main() {
    for (const float mean : {0.1f, 0.3f, 0.5f}) {
        std::printf("# mean slope %g, deviation 0.15\n", double(mean));
        const Slopes d = slopesOf(mean, 0.0f, 0.15f, 0.15f, 0.0f);
        for (double view = -88.0; view <= 88.0; view += 1.0) {
            // Negative: the slope is turned to the viewer.
            const vec3 wo = directionAt(view, 0);
            if (slope_facing(d.mean, wo) < 0.02f) continue;
            const Numbers tilted = numbersOf(d, wo, true), sheared = numbersOf(d, wo, false);
            std::printf("%g %.5f %.5f %.5f %.5f\n", view, tilted.visible, tilted.albedo,
                        sheared.visible, sheared.albedo);
        }
        std::printf("\n\n");
    }
}
