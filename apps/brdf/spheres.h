// Lit spheres of reflectance models, path-traced by the library.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "brdf/models.h"
#include "picture_grid.h"

namespace gp::tool {

struct SphereSettings {
    std::string environmentPath;                        // empty: the studio
    std::optional<std::array<float, 2>> light;          // azimuth, elevation in degrees
    std::optional<double> exposureEv;
    unsigned size = 192, samples = 256;
};

// --env, --light, --exposure, --size, --samples.
void addSphereOptions(CLI::App& app, SphereSettings& settings);
extern const char* const kSphereNotes;  // for --help

// The CPU, without which nothing is traced.
Device newSphereDevice();

struct SpherePicture {
    unsigned size = 0;
    std::vector<float> rgba;  // radiance
};

// One picture for each; empty when a signal came before all were there.
std::vector<SpherePicture> renderSpheres(GpDevice device, const std::vector<GpBsdf>& models,
                                         const SphereSettings& settings);

// All with the same exposure: the given one, else 0, or automatic for an environment of unknown
// brightness.
std::vector<GridPicture> displayed(const std::vector<SpherePicture>& spheres,
                                   const SphereSettings& settings);

}  // namespace gp::tool
