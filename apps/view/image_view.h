// Frame images as pictures to look at: depth, normals and the like, scaled so that something shows.
#pragma once

#include <glitterpath/glitterpath.h>

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace gp::tool::view {

// How the numbers of an image become brightness.
enum class ImageScale {
    display,    // the frame's own 8-bit picture
    light,      // radiance and reflectance: times 2^exposure, clipped, sRGB-encoded
    deviation,  // variance: its square root, then as light
    data,       // 0..1 as it stands
    direction,  // -1..1 to 0..1; no direction is black
    distance,   // logarithmic, near is bright, nothing is black
    number,     // a colour for each number, 0 is black
    heat,       // what a pixel costs, from black over red to yellow
    range       // whatever else: the largest magnitude is full scale, 0 is middle grey
};

// For images that have no rule of their own the format decides.
ImageScale scaleOf(const GpImageInfo& info);
// A line for people: what is seen, such as "0..1 as it stands".
std::string explanationOf(ImageScale scale);

// Everything that a frame can show: GpFrameImage, then what real-time frames keep beside it
// (gpReadFrameLayer).
struct ImageName {
    GpImageInfo info{};                // its name is static
    std::optional<GpFrameImage> kind;  // nothing: a layer
    const char* meaning = "";          // of layers, as the library tells it
};
const std::vector<ImageName>& allImages();
// Nothing where there is none of this name.
const ImageName* imageNamed(const std::string& name);
std::vector<std::string> imageNames();
// Whether frames have it only where it was asked for (GpRealtimeOptions::heatMaps).
bool needsHeatMaps(const std::string& name);
// Whether frames of this mode have it.
bool hasImage(GpFrameMode mode, const ImageName& image);

// What the brightest colour of ImageScale::heat stands for; black is 0.
struct HeatScale {
    float high = 0;
    std::string unit;  // for people: "rays", ...
};
// `rgba` are the numbers of `count` pixels; one pixel in a hundred may have more than `high`.
HeatScale heatScaleOf(const std::string& name, const float* rgba, std::size_t count);
// The colour of a value that is `t` (0..1) of `high`, sRGB.
glm::vec3 heatColor(float t);

// RGBA8, opaque. `bytes` are those of gpReadFrameImage for `count` pixels. exposureEv counts for
// light and deviation, except for reflectance, which never is brighter than 1.
std::vector<std::uint8_t> visiblePixels(const GpImageInfo& info, const void* bytes,
                                        std::size_t count, float exposureEv);

}  // namespace gp::tool::view
