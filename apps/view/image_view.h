// Frame images as pictures to look at: depth, normals and the like, scaled so that something shows.
#pragma once

#include <glitterpath/glitterpath.h>

#include <cstddef>
#include <cstdint>
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
// Whether frames of this mode have it.
bool hasImage(GpFrameMode mode, const ImageName& image);

// RGBA8, opaque. `bytes` are those of gpReadFrameImage for `count` pixels. exposureEv counts for
// light and deviation, except for reflectance, which never is brighter than 1.
std::vector<std::uint8_t> visiblePixels(const GpImageInfo& info, const void* bytes,
                                        std::size_t count, float exposureEv);

}  // namespace gp::tool::view
