// Wavelengths as colours: for light that goes in another direction for each of them.
#ifndef GP_SHADING_SPECTRUM_GLSL
#define GP_SHADING_SPECTRUM_GLSL
#include "shading/iridescence.glsl"

// What the eye sees, for our purposes; in nanometres.
#define SPECTRUM_FIRST_NM 380.0f
#define SPECTRUM_LAST_NM 720.0f

// A Gaussian with two widths.
float spectrum_lobe(float nm, float mean, float below, float above) {
    float t = (nm - mean) / (nm < mean ? below : above);
    return exp(-0.5f * t * t);
}

// The colour matching functions of CIE 1931, 2 degrees.
// [Wyman, Sloan and Shirley 2013, JCGT 2(2), equation 4]
vec3 cie_xyz_of_wavelength(float nm) {
    return vec3(1.056f * spectrum_lobe(nm, 599.8f, 37.9f, 31.0f)
                    + 0.362f * spectrum_lobe(nm, 442.0f, 16.0f, 26.7f)
                    - 0.065f * spectrum_lobe(nm, 501.1f, 20.4f, 26.2f),
                0.821f * spectrum_lobe(nm, 568.8f, 46.9f, 40.5f)
                    + 0.286f * spectrum_lobe(nm, 530.9f, 16.3f, 31.1f),
                1.217f * spectrum_lobe(nm, 437.0f, 11.8f, 36.0f)
                    + 0.681f * spectrum_lobe(nm, 459.0f, 26.0f, 13.8f));
}

// How much of a spectrum at this wavelength goes into linear Rec. 709, per nanometre: a constant
// spectrum of 1 is (1, 1, 1), as a white surface must stay white under any light's colour. Pure
// spectral colours lie outside of the triangle of the primaries: what would be negative is cut, and
// the rest normalised, so that each channel is a share of the light; ours.
vec3 rgb_of_wavelength(float nm) {
    if (nm < SPECTRUM_FIRST_NM || nm > SPECTRUM_LAST_NM) {
        return vec3(0.0f);
    }
    vec3 rgb = max(rec709_from_xyz_gltf(cie_xyz_of_wavelength(nm)), vec3(0.0f));
    return rgb / vec3(176.17449f, 115.37504f, 109.31865f);
}

#endif
