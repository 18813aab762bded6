// MERL's files of measured isotropic materials, as bytes: what the library reads and the command
// writes. int32 x 3 with the numbers of cells, then doubles: a plane of red, of green, of blue.
// [Matusik et al. 2003, "A Data-Driven Reflectance Model"; the layout, the scales of the channels
//  and of the angles are those of the code that is distributed with the data]
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

#include "half_angles.h"

namespace gp::merl {

static_assert(std::endian::native == std::endian::little, "the files are little-endian");

constexpr std::array<int32_t, 3> sizes = {90, 90, 180};  // theta_h, theta_d, phi_d
constexpr size_t cellCount = 90 * 90 * 180;
constexpr size_t headBytes = sizeof(sizes);
constexpr size_t fileBytes = headBytes + 3 * cellCount * sizeof(double);
// f is the file's number times that of the channel.
constexpr std::array<double, 3> scales = {1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};

// The numbers of a cell: theta_h slowest, phi_d fastest.
inline std::array<size_t, 3> placeOf(size_t cell) {
    return {cell / (90 * 180), cell / 180 % 90, cell % 180};
}

// The directions at the centre of a cell, the half vector at the azimuth phiH. One of them may lie
// below the horizon: such cells are -1 in the files.
inline DirectionPair directionsOf(size_t cell, double phiH) {
    const auto [h, d, p] = placeOf(cell);
    const double root = (static_cast<double>(h) + 0.5) / 90.0;  // theta_h goes with its square
    return fromHalfAndDifference(0.5 * M_PI * root * root, phiH,
                                 0.5 * M_PI * (static_cast<double>(d) + 0.5) / 90.0,
                                 M_PI * (static_cast<double>(p) + 0.5) / 180.0);
}

// The whole file. `cells`: red, green and blue of each cell, f in 1/sr; negative: not measured.
inline std::string fileOf(std::span<const float> cells) {
    std::string bytes(fileBytes, '\0');
    std::memcpy(bytes.data(), sizes.data(), headBytes);
    for (size_t channel = 0; channel < 3; ++channel) {
        for (size_t cell = 0; cell < cellCount; ++cell) {
            const double f = static_cast<double>(cells[3 * cell + channel]);
            const double number = f < 0.0 ? -1.0 : f / scales[channel];
            std::memcpy(bytes.data() + headBytes + (channel * cellCount + cell) * sizeof(double),
                        &number, sizeof(double));
        }
    }
    return bytes;
}

}  // namespace gp::merl
