// What reflectance models there are and what can be set on them: models.def and parameters.def as
// tables for people's words. bsdf_settings.h makes from settings what the shading functions take.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

namespace gp {

// The word or value that was wrong, in one line.
struct BsdfError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct MeasuredBrdf;  // scene/measured_brdf.h

enum class BsdfParameterType { number, color, boolean, choice };

struct BsdfParameterInfo {
    std::string name;
    BsdfParameterType type = BsdfParameterType::number;
    glm::vec3 initial{0};       // a number in all three; a choice's index
    float minimum = 0, maximum = 0;
    bool mayExceed = false;     // values outside of the range are used, not clamped
    std::string unit;
    std::vector<std::string> choices;
    std::string text;
    uint32_t row = 0;           // of parameters.def
};

struct BsdfModelInfo {
    uint32_t number = 0;
    std::string name;
    bool reciprocal = false, conserving = false, transmissive = false;
    bool fromFile = false;      // a file's path is its name: as such it is black
    std::string reference;      // key in docs/references.md
    std::string text;
    std::vector<BsdfParameterInfo> parameters;

    bool hasBaseColor() const;
};

// In the order of models.def.
const std::vector<BsdfModelInfo>& bsdfModels();
// Throws BsdfError with the nearest name.
const BsdfModelInfo& findBsdfModel(const std::string& name);
const BsdfParameterInfo& findBsdfParameter(const BsdfModelInfo& model, const std::string& name);

// A model with a value for each of its parameters.
struct BsdfSettings {
    const BsdfModelInfo* model = nullptr;
    std::vector<glm::vec3> values;     // beside model->parameters
    std::vector<std::string> notices;  // what was clamped, once for each parameter
    // The table of a model from a file: it lives as long as any settings that hold it.
    std::shared_ptr<const MeasuredBrdf> measured;

    explicit BsdfSettings(const BsdfModelInfo& info);
    // "20", "0.8,0.5,0.3" or one number for a color, "true" or "1", the name of a choice. Throws
    // BsdfError, and has changed nothing then.
    void set(const std::string& name, std::string_view text);
    // Of a parameter by its row in parameters.def; null if the model has not got it.
    const glm::vec3* valueOfRow(uint32_t row) const;
};

// Why one cannot be blended over the other (MaterialLayer), in one line; empty: it can. Numbers and
// colours have something in between; models and choices have not.
std::string whyNotBlended(const BsdfSettings& below, const BsdfSettings& above);
// The parameters in between: share 0 is `below`, 1 is `above`.
BsdfSettings blended(const BsdfSettings& below, const BsdfSettings& above, float share);

// A value as people write it: what `set` understands.
std::string bsdfValueText(const BsdfParameterInfo& parameter, const glm::vec3& value);

}  // namespace gp
