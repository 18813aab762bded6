// The names that other programs give to models and parameters, so that their files can be read and
// their numbers compared with ours.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/bsdf_registry.h"

namespace gp {

// own: the names of our registry. wdas: the .brdf files of Disney's BRDF Explorer. bbm: the BSDF
// benchmark's.
enum class BsdfDialect { own, wdas, bbm };

struct DialectParameter {
    const char* theirs;
    const char* ours;
    // From the text of their value to that of ours; null: the same.
    std::string (*convert)(std::string_view text) = nullptr;
    // Not null: theirs is a boolean, and where it is true, `ours` gets the value of this one.
    const char* equalTo = nullptr;
};

using BsdfWords = std::vector<std::pair<std::string, std::string>>;

struct DialectModel {
    BsdfDialect dialect;
    std::string name;      // theirs
    const char* ours;
    std::string settings;  // of ours, as "a=1 b=2": their form of it, their defaults
    std::vector<DialectParameter> parameters;
    // Not null: all of their words at once, known by name already, become ours. For switches that
    // act on each other; `parameters` then says what each acts on.
    BsdfWords (*rewrite)(const BsdfWords& words) = nullptr;
};

// All of both dialects: a model that another program has is a row here.
const std::vector<DialectModel>& dialectModels();

// The part of them that microfacets and Disney's models have.
std::vector<DialectModel> microfacetDialectModels();

// A model of the registry with parameters by name, in a dialect's words. (io/bsdf_source.h knows
// presets and files as well.) Throws BsdfError.
BsdfSettings bsdfFromWords(BsdfDialect dialect, const std::string& model, const BsdfWords& words);

}  // namespace gp
