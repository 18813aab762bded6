// Six square pictures around a point, and the latitude-longitude image that they make: the one form
// in which light is chosen from what surrounds a scene.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scene/texture.h"

namespace gp {

// Faces as shading/light/cube_map.glsl has them.
struct CubeMap {
    uint32_t size = 0;             // of each face, pixels
    std::vector<glm::vec3> texels; // 6 * size * size: faces, rows, pixels
};

// RGB of level 0, decoded. Square textures of one size.
CubeMap cubeMapOf(const std::array<const Texture*, 6>& faces);

// RGBA, top row first, as EnvironmentTable wants it; alpha is 1.
struct LatLongImage {
    uint32_t width = 0, height = 0;
    std::vector<glm::vec4> pixels;
};

// Four times as wide as a face, within these limits: then a pixel on the equator is about as wide
// as one of a face in its middle. Narrower images would round corners off.
constexpr uint32_t leastLatLongWidth = 64, mostLatLongWidth = 8192;

// cubeFromImage: directions of the image into those of the cube, at right angles. Each pixel is the
// mean over its area; faces are read bilinearly, across their edges too.
LatLongImage latLongFromCube(const CubeMap& cube, const glm::mat3& cubeFromImage);

// The same in `image`, whose size and pixels are there, with one look at the cube a pixel: for
// cubes that are made anew each frame. What is a texel or two wide may lose some of its light.
void latLongFromCube(const CubeMap& cube, const glm::mat3& cubeFromImage, LatLongImage& image);

}  // namespace gp
