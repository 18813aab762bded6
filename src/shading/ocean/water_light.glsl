// What clear water sends along a ray in it, in closed form: light from above is scattered on its
// way and fades with depth. Of infinitely deep water an equal radiance comes up in all directions,
// as the deep sea has it: so things fade to the colour of the deep.
#ifndef GP_SHADING_OCEAN_WATER_LIGHT_GLSL
#define GP_SHADING_OCEAN_WATER_LIGHT_GLSL

// (1 - e^-x) / x. Below the threshold the difference has lost digits, and three terms are exact.
float decay_mean(float x) {
    if (abs(x) < 0.02f) { return 1.0f - x * (0.5f - x * (1.0f / 6.0f)); }
    return (1.0f - exp(-x)) / x;
}

// From the depth z the radiance B(z) = B e^(-k z) comes up, k = stretch * loss, where the water is
// deep; a ray that goes down by the cosine `down` and ends after s metres brings what is missing of
// that below its end, B(z) - B(z + down s) e^(-loss s). It is the water column over a floor of
// Lee, Carder, Mobley, Steward and Patch 1998, "Hyperspectral remote sensing for shallow waters I",
// Applied Optics 37(27), with the attenuation of irradiance of Gordon 1989, "Can the Lambert-Beer
// law be applied to the diffuse attenuation coefficient of ocean water?", Limnology and
// Oceanography 34(8): k = loss / cosine of the light.
// The source behind it is q = loss (1 + stretch down) B(z), in dL = (loss L - q) ds. Upwards, where
// that would be negative, q = loss B(z), which is what a level ray meets: a closed form of ours.
// A ray upwards ends at the surface at the latest. `radiance` is B, of one channel.
float water_light(float radiance, float loss, float stretch, float depth, float down,
                  float distance) {
    const float furthest = 80.0f;  // e^-80 is nothing
    float k = stretch * loss;
    float here = radiance * exp(-k * depth);
    if (down >= 0.0f) {
        float x = min((loss + k * down) * distance, furthest);
        return here * x * decay_mean(x);
    }
    float s = min(distance, depth / -down);
    float rate = loss + k * down;  // how L q^-1 changes; k may be the larger of the two
    float x = rate * s;
    if (abs(x) < 0.02f) { return here * loss * s * decay_mean(x); }
    float there = radiance * exp(-k * max(depth + down * s, 0.0f) - loss * s);
    return loss * (here - there) / rate;
}

#endif
