#include "local_settings.h"

#include <fmt/format.h>

#include <algorithm>

#include "commands.h"
#include "parse.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::pair<const char*, GpShadingFrequency> kFrequencies[] = {
    {"phong", GP_FREQUENCY_PIXEL},
    {"gouraud", GP_FREQUENCY_VERTEX},
    {"flat", GP_FREQUENCY_TRIANGLE}};

// Every opaque model of the library with its defaults, and the microfacets with each distribution.
std::vector<std::string> allModelWords(GpDevice device) {
    std::vector<std::string> words;
    for (const Json& model : describeModels(device)) {
        if (model.at("transmissive").get<bool>() || model.at("fromFile").get<bool>()) {
            continue;
        }
        const std::string name = model.at("name");
        if (name != "microfacet") {
            words.push_back(name);
            continue;
        }
        for (const Json& parameter : model.at("parameters")) {
            if (parameter.at("name") == "distribution") {
                for (const Json& choice : parameter.at("choices")) {
                    words.push_back(
                        fmt::format("{}:distribution={}", name, choice.get<std::string>()));
                }
            }
        }
    }
    return words;
}

std::vector<GpShadingFrequency> frequenciesOf(const LocalSettings& s) {
    if (s.frequencyWords.empty()) {
        return {GP_FREQUENCY_PIXEL};
    }
    std::vector<GpShadingFrequency> frequencies;
    for (const std::string& word : s.frequencyWords) {
        frequencies.push_back(parseChoice("--frequency", word, kFrequencies));
    }
    return frequencies;
}

}  // namespace

void addEnvironmentLight(CLI::App& app, LocalSettings& s, const char* group) {
    addWord(app, "--environment-light", "ambient|9|16|25",
            "Surfaces of slopes (glint, the sea) reflect the surroundings by so many facets, and "
            "all surfaces have their light by direction (default ambient: their mean)",
            [&s](const std::string& word) {
                const std::pair<const char*, std::uint32_t> choices[] = {
                    {"ambient", 0}, {"9", 9}, {"16", 16}, {"25", 25}};
                s.environmentFacets = parseChoice("--environment-light", word, choices);
            })->group(group);
}

void addLocalOptions(CLI::App& app, LocalSettings& s) {
    const std::string group = "Local lighting (--mode local)";
    addWord(app, "--mode", "reference|realtime|local",
            "reference: path tracing; realtime: what an application shows, about one path a pixel "
            "and frame, denoised; local: the picture of a rasteriser, lit by lamps without shadows "
            "and bounces (default reference)",
            [&s](const std::string& word) {
                const std::pair<const char*, GpFrameMode> choices[] = {
                    {"reference", GP_MODE_REFERENCE},
                    {"realtime", GP_MODE_REALTIME},
                    {"local", GP_MODE_LOCAL}};
                s.mode = parseChoice("--mode", word, choices);
            })->group("Mode");
    addWords(app, "--lighting", "MODEL|all",
             "The reflectance of all surfaces, tinted by their base colours (default: their own); "
             "may be repeated, for a sheet of pictures; all: every opaque model",
             s.models.words)->group(group);
    addWords(app, "--set", "KEY=VALUE", "Set a parameter of the lighting models; may be repeated",
             s.models.assignments)->group(group);
    addWords(app, "--frequency", "phong|gouraud|flat",
             "Compute light for every pixel, for the corners of triangles, or once a triangle "
             "(default phong); may be repeated, for a sheet of pictures",
             s.frequencyWords)->group(group);
    addWord(app, "--falloff", "NAME",
            "How the light of lamps falls off with distance: inverse-square, inverse, none "
            "(default the first)",
            [&s](const std::string& word) {
                const std::pair<const char*, GpFalloff> choices[] = {
                    {"inverse-square", GP_FALLOFF_INVERSE_SQUARE},
                    {"inverse", GP_FALLOFF_INVERSE},
                    {"none", GP_FALLOFF_NONE}};
                s.falloff = parseChoice("--falloff", word, choices);
            })->group(group);
    addWord(app, "--ndf-filter", "NAME",
            "Widen highlights by what a pixel sees of a curved surface: none, kaplanyan, "
            "tokuyoshi, deferred (default none)",
            [&s](const std::string& word) {
                const std::pair<const char*, GpNdfFilter> choices[] = {
                    {"none", GP_NDF_FILTER_NONE},
                    {"kaplanyan", GP_NDF_FILTER_KAPLANYAN},
                    {"tokuyoshi", GP_NDF_FILTER_TOKUYOSHI},
                    {"deferred", GP_NDF_FILTER_DEFERRED}};
                s.ndfFilter = parseChoice("--ndf-filter", word, choices);
            })->group(group);
    addWord(app, "--ambient", "R,G,B",
            "Radiance from all sides, W/(m^2 sr), beside the mean of the surroundings (default 0)",
            [&s](const std::string& word) {
                const std::array<float, 3> color = parseTriple("--ambient", word);
                std::copy(color.begin(), color.end(), s.ambient);
                if (*std::min_element(color.begin(), color.end()) < 0) {
                    throw UsageError(fmt::format("--ambient: {} is negative", word));
                }
            })->group(group);
    addEnvironmentLight(app, s, group.c_str());
}

void checkMode(const CLI::App& app, const LocalSettings& s) {
    const bool local = s.mode == GP_MODE_LOCAL;
    for (const GpShadingFrequency frequency : frequenciesOf(s)) {
        if (frequency != GP_FREQUENCY_PIXEL && s.ndfFilter != GP_NDF_FILTER_NONE) {
            throw UsageError("--ndf-filter: only with --frequency phong");
        }
    }
    const auto refuse = [&](const char* option, const char* mode) {
        if (app.count(option) > 0) {
            throw UsageError(fmt::format("{}: only with --mode {}", option, mode));
        }
    };
    if (local) {
        for (const char* option : {"--bounces", "--clamp", "--no-roulette"}) {
            refuse(option, "reference or realtime");
        }
        if (!s.models.assignments.empty() && s.models.words.empty()) {
            throw UsageError("--set: needs --lighting");
        }
        return;
    }
    for (const char* option :
         {"--lighting", "--set", "--frequency", "--falloff", "--ndf-filter", "--ambient",
          "--environment-light"}) {
        refuse(option, "local");
    }
}

std::vector<Model> lightingModels(GpDevice device, const LocalSettings& settings) {
    ModelOptions options = settings.models;
    if (options.words.empty()) {
        return {};
    }
    options.words.clear();
    for (const std::string& word : settings.models.words) {
        if (word == "all") {
            const std::vector<std::string> all = allModelWords(device);
            options.words.insert(options.words.end(), all.begin(), all.end());
        } else {
            options.words.push_back(word);
        }
    }
    return newModels(device, options);
}

std::vector<Lighting> lightingsOf(const LocalSettings& settings,
                                  const std::vector<Model>& models) {
    const std::vector<GpShadingFrequency> frequencies = frequenciesOf(settings);
    std::vector<Lighting> all;
    for (std::size_t i = 0; i < std::max<std::size_t>(models.size(), 1); ++i) {
        for (const GpShadingFrequency frequency : frequencies) {
            Lighting lighting;
            if (!models.empty()) {
                lighting.model = models[i].label;
                lighting.local.model = models[i].bsdf.get();
            }
            for (const auto& [name, value] : kFrequencies) {
                lighting.frequency = value == frequency ? name : lighting.frequency;
            }
            lighting.local.frequency = frequency;
            lighting.local.falloff = settings.falloff;
            lighting.local.ndfFilter = settings.ndfFilter;
            lighting.local.environmentFacets = settings.environmentFacets;
            std::copy_n(settings.ambient, 3, lighting.local.ambient);
            all.push_back(lighting);
        }
    }
    return all;
}

}  // namespace gp::tool
