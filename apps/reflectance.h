// Reflectance models of the library, for the brdf subcommand: from words to values.
#pragma once

#include <glitterpath/glitterpath.h>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "library.h"

namespace gp::tool {

using Bsdf = Owner<GpBsdfImpl, &gpReleaseBsdf>;
using Direction = std::array<double, 3>;
using ParameterWords = std::vector<std::pair<std::string, std::string>>;

// The model that MODEL names with its parameters set. The library resolves the name, in its one
// place for that (scene/bsdf_dialect.h). Throws RunError with the library's line.
Bsdf newBsdf(GpDevice device, const std::string& model, GpBsdfDialect dialect,
             const ParameterWords& parameters);

// A device that renders nothing: models need none.
Device newModelDevice();
nlohmann::ordered_json describeModels(GpDevice device);
// Of a TOML file; path empty: the library's.
nlohmann::ordered_json describePresets(GpDevice device, const std::string& path);
nlohmann::ordered_json describeBsdf(GpDevice device, const Bsdf& bsdf);

// wi to the light, wo to the viewer, of any length but 0. Throws RunError.
GpBsdfValue evaluate(GpDevice device, const Bsdf& bsdf, const Direction& wi, const Direction& wo);

// The same for many; of unit length.
std::vector<GpBsdfValue> evaluate(GpDevice device, const Bsdf& bsdf,
                                  const std::vector<glm::vec3>& wi,
                                  const std::vector<glm::vec3>& wo);
// u: three numbers at least 0 and below 1.
std::vector<GpBsdfSample> sample(GpDevice device, const Bsdf& bsdf,
                                 const std::vector<glm::vec3>& wo,
                                 const std::vector<glm::vec3>& u);

// "own", "wdas" or "bbm". Throws UsageError.
GpBsdfDialect parseDialect(const std::string& word);

}  // namespace gp::tool
