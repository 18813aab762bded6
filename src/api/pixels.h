// Image files and encodings, as the border needs them.
#pragma once

#include <string>
#include <vector>

#include "scene/image.h"

namespace gp::api {

struct ImageFile {
    Image image;
    bool displayReferred = false;  // PNG or JPEG: sRGB-encoded
};
ImageFile readImageFile(const std::string& path);  // throws io::FileError

// RGBA floats, decoded from sRGB where the file was display-referred.
std::vector<float> linearPixels(const ImageFile& file);

// To eight bits, with the sRGB encoding on RGB and alpha as it is; clipped to 0..1, NaN is 0.
std::vector<uint8_t> displayPixels(const float* rgba, size_t pixelCount);

}  // namespace gp::api
