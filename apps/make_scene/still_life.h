// The things on the table of the still life; each stands on y = 0 with its middle at x = z = 0.
#pragma once

#include "glb.h"

namespace gp::make_scene {

struct Vessel {
    Mesh glass;  // one closed shell: outside, rim, inside
    Mesh water;  // closed too, a third of a millimetre clear of the glass
};
Vessel carafe();
Mesh bowl();
Image bowlPainting();  // v as lathe() lays it along the profile of bowl()
Mesh goblet();

Mesh apple();
Mesh pear();
Mesh lemon();
Mesh stem(float length, float radius);
Mesh grapes(std::uint32_t seed);
Mesh grapeStalk();

struct ToyCar {
    Mesh paint, glass, chrome, rubber;
};
ToyCar toyCar();

struct Book {
    Mesh cover, pages, bands;
};
Book book();

// Lies on y = 0 and hangs over the edge at z = `edge`.
Mesh cloth(float edge);

}  // namespace gp::make_scene
