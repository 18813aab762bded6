// Pictures for the tests of the metrics.
#pragma once

#include <cstdint>
#include <random>

#include "metrics/picture.h"

namespace gp::metrics {

inline Picture uniformPicture(int width, int height, glm::vec3 color) {
    return Picture(width, height, color);
}

// Independent random values in low..high.
inline Picture noisePicture(int width, int height, std::uint32_t seed, float low = 0.0f,
                            float high = 1.0f) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<float> value(low, high);
    Picture picture(width, height);
    for (glm::vec3& pixel : picture.pixels) {
        pixel.x = value(generator);
        pixel.y = value(generator);
        pixel.z = value(generator);
    }
    return picture;
}

inline Picture scaledPicture(Picture picture, float factor) {
    for (glm::vec3& pixel : picture.pixels) {
        pixel *= factor;
    }
    return picture;
}

// Black on the left, white from column `edge` on.
inline Picture stepPicture(int width, int height, int edge) {
    Picture picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = edge; x < width; ++x) {
            picture.at(x, y) = glm::vec3(1.0f);
        }
    }
    return picture;
}

}  // namespace gp::metrics
