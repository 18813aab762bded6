// `glitterpath render --mode local`: the lighting that was asked for.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "brdf/models.h"

namespace gp::tool {

struct LocalSettings {
    GpFrameMode mode = GP_MODE_REFERENCE;
    ModelOptions models;  // none: surfaces have their own reflectance; "all" stands for many
    std::vector<std::string> frequencyWords;  // none: phong
    GpFalloff falloff = GP_FALLOFF_INVERSE_SQUARE;
    GpNdfFilter ndfFilter = GP_NDF_FILTER_NONE;
    float ambient[3] = {0, 0, 0};
    std::uint32_t environmentFacets = 0;  // 0: the surroundings are ambient light
};

// --environment-light alone, for commands that have no more of it.
void addEnvironmentLight(CLI::App& app, LocalSettings& settings, const char* group);

// The settings must outlive the parsing.
void addLocalOptions(CLI::App& app, LocalSettings& settings);

// Whether options of the other mode were given; throws UsageError.
void checkMode(const CLI::App& app, const LocalSettings& settings);

// One picture: a model, or null for the surfaces' own reflectance, and where light is computed.
struct Lighting {
    std::string model, frequency;  // for people
    GpLocalLighting local{};
};

// Every model with every frequency, model after model. The handles are those of `models`.
std::vector<Lighting> lightingsOf(const LocalSettings& settings, const std::vector<Model>& models);

// The models that were asked for. Throws UsageError.
std::vector<Model> lightingModels(GpDevice device, const LocalSettings& settings);

}  // namespace gp::tool
