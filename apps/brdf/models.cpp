#include "brdf/models.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parse.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;

bool knows(const Json& description, const std::string& name) {
    return description.at("parameters").contains(name);
}

bool sets(const ParameterWords& words, const std::string& name) {
    return std::any_of(words.begin(), words.end(),
                       [&](const auto& word) { return word.first == name; });
}

// Flags tell what a model can do; samples tell what it does.
bool transmits(GpDevice device, const Bsdf& bsdf) {
    std::vector<glm::vec3> wo, u;
    for (int i = 0; i < 512; ++i) {
        const float z = i % 2 == 0 ? 0.9f : 0.4f;
        wo.emplace_back(std::sqrt(1.0f - z * z), 0.0f, z);
        u.emplace_back((static_cast<float>(i) + 0.5f) / 512.0f, static_cast<float>(i % 7) / 7.0f,
                       static_cast<float>(i % 13) / 13.0f);
    }
    const std::vector<GpBsdfSample> samples = sample(device, bsdf, wo, u);
    return std::any_of(samples.begin(), samples.end(), [](const GpBsdfSample& s) {
        return (s.lobe & GP_LOBE_TRANSMISSION) != 0;
    });
}

// Several models take of the common parameters what they know; one takes them all, so that the
// library can say what is wrong with them.
Model make(GpDevice device, const std::string& word, GpBsdfDialect dialect,
           const ParameterWords& common, bool pick) {
    const ModelWord own = parseModelWord(word);
    Model model;
    model.label = word;
    model.made = own;
    try {
        model.bsdf = newBsdf(device, own.name, dialect, own.parameters);
        model.description = describeBsdf(device, model.bsdf);
        ParameterWords all;
        for (const auto& assignment : common) {
            const bool wanted = !pick || knows(model.description, assignment.first);
            if (wanted && !sets(own.parameters, assignment.first)) {
                all.push_back(assignment);
            }
        }
        if (!all.empty()) {
            all.insert(all.end(), own.parameters.begin(), own.parameters.end());
            model.made.parameters = all;
            model.bsdf = newBsdf(device, own.name, dialect, all);
            model.description = describeBsdf(device, model.bsdf);
        }
    } catch (const RunError& error) {
        const std::string line = error.what();
        if (line.starts_with(own.name + ": ") && own.name.ends_with(".binary")) {
            throw;  // a measured file is bad: not the command line's fault
        }
        throw UsageError(line);
    }
    model.transmissive = transmits(device, model.bsdf);
    return model;
}

void printNotices(const Model& model) {
    for (const Json& notice : model.description.at("notices")) {
        fmt::print(stderr, "glitterpath: note: {}\n", notice.get<std::string>());
    }
}

}  // namespace

const char* const kModelSyntax =
    "MODEL is a model (`glitterpath brdf list`), a preset (`glitterpath brdf presets`),\n"
    "FILE.toml#NAME (a preset of a file) or FILE.binary (measured), alone or with parameters:\n"
    "  ward:alpha_x=0.3,alpha_y=0.1,base_color=0.8,0.5,0.3\n"
    "--set is for all models: each takes what it knows and was not given itself.";

ModelWord parseModelWord(const std::string& word) {
    const std::size_t colon = word.find(':');
    ModelWord result;
    result.name = word.substr(0, colon);
    if (result.name.empty()) {
        throw UsageError(fmt::format("MODEL: '{}' has no name before its parameters", word));
    }
    if (colon == std::string::npos) {
        return result;
    }
    for (const std::string& part : splitAtCommas(std::string_view(word).substr(colon + 1))) {
        if (part.find('=') == std::string::npos && !result.parameters.empty()) {
            result.parameters.back().second += "," + part;
        } else {
            result.parameters.push_back(parseAssignment(result.name, part));
        }
    }
    return result;
}

void addModelOptions(CLI::App& app, ModelOptions& options) {
    app.add_option("MODEL", options.words, "Models, presets or measured files: see below");
    app.add_option("--set", options.assignments, "Set parameters; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1, -1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

std::vector<Model> newModels(GpDevice device, const ModelOptions& options) {
    if (options.words.empty()) {
        throw UsageError("which MODEL? (`glitterpath brdf list` and `brdf presets` show them)");
    }
    ParameterWords common;
    for (const std::string& word : options.assignments) {
        common.push_back(parseAssignment("--set", word));
    }
    const bool pick = options.words.size() > 1;
    std::vector<Model> models;
    for (const std::string& word : options.words) {
        models.push_back(make(device, word, options.dialect, common, pick));
        if (!options.quiet) {
            printNotices(models.back());
        }
    }
    for (const auto& [name, value] : common) {
        bool known = !pick;
        for (const Model& model : models) {
            known = known || knows(model.description, name);
        }
        if (!known) {
            throw UsageError(fmt::format("--set: none of the models has a parameter '{}'", name));
        }
    }
    return models;
}

Bsdf variantOf(GpDevice device, const Model& model, const ParameterWords& changes) {
    ParameterWords all = model.made.parameters;
    all.insert(all.end(), changes.begin(), changes.end());  // the last of a name counts
    return newBsdf(device, model.made.name, GP_DIALECT_OWN, all);
}

Model newModel(GpDevice device, const ModelOptions& options) {
    if (options.words.size() > 1) {
        throw UsageError(fmt::format("unexpected argument '{}': one MODEL is wanted",
                                     options.words[1]));
    }
    return std::move(newModels(device, options).front());
}

}  // namespace gp::tool
