// MODEL on the command line: the one syntax of all brdf subcommands.
//
//   ward                                         a model with its defaults
//   ward:alpha_x=0.3,base_color=0.8,0.5,0.3      and with parameters of its own: a part without a
//                                                "=" belongs to the value before it
//
// --set NAME=VALUE is for all of them: each takes what it knows and was not given itself.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "reflectance.h"

namespace gp::tool {

struct ModelWord {
    std::string name;
    ParameterWords parameters;
};

// Throws UsageError.
ModelWord parseModelWord(const std::string& word);

struct ModelOptions {
    std::vector<std::string> words, assignments;
    GpBsdfDialect dialect = GP_DIALECT_OWN;
    bool quiet = false;  // no notes
};

struct Model {
    std::string label;  // as it was written
    ModelWord made;     // with the common parameters that it took
    Bsdf bsdf;
    nlohmann::ordered_json description;
    bool transmissive = false;  // with these parameters
};

// The same with other values of some parameters. Throws RunError.
Bsdf variantOf(GpDevice device, const Model& model, const ParameterWords& changes);

// Adds MODEL... and --set.
void addModelOptions(CLI::App& app, ModelOptions& options);

// Notes on stderr say what was clamped. Throws UsageError, since all of it stands on
// the command line; RunError where a measured file is bad.
std::vector<Model> newModels(GpDevice device, const ModelOptions& options);
// For commands that take exactly one.
Model newModel(GpDevice device, const ModelOptions& options);

extern const char* const kModelSyntax;  // for --help

}  // namespace gp::tool
