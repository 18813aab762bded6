#include "brdf/directions.h"

#include <algorithm>
#include <cmath>

namespace gp::tool {

glm::dvec3 spherical(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

std::vector<double> placesBetween(double low, double high, std::size_t count,
                                  const std::vector<double>& centers) {
    std::vector<double> places;
    for (std::size_t i = 0; i < count; ++i) {
        places.push_back(low + (high - low) * static_cast<double>(i) /
                                   static_cast<double>(count - 1));
    }
    for (const double center : centers) {
        for (std::size_t i = 0; i <= count / 2; ++i) {
            const double t = 2.0 * static_cast<double>(i) / static_cast<double>(count);
            const double distance = 0.3 * t * t * t * (high - low);
            places.push_back(center + distance);
            places.push_back(center - distance);
        }
    }
    std::erase_if(places, [&](double at) { return at < low || at > high; });
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

}  // namespace gp::tool
