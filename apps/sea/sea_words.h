// The settings of a sea by name: what options, the viewer's scripts and its panel have in common.
#pragma once

#include <glitterpath/glitterpath.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gp::tool {

// A number as people write it.
struct SeaNumber {
    float GpOceanDesc::*field = nullptr;
    const char* unit = "";         // "" = a pure number
    double low = 0, high = 0;
    double siPerUnit = 1;          // what the field has of one of these units
    double standard = 0;           // what the library takes for a field that is zero and not given
    std::uint32_t given = 0;       // the bit that says that zero is meant; 0: it needs none

    double of(const GpOceanDesc& sea) const;
    void put(GpOceanDesc& sea, double value) const;
};

// Three of them, for red, green and blue: a coefficient of the water, 1/m.
struct SeaTriple {
    float (GpOceanDesc::*field)[3] = nullptr;
    double high = 0;               // from 0
    std::array<float, 3> standard{};
    std::uint32_t given = 0;

    std::array<float, 3> of(const GpOceanDesc& sea) const;
    void put(GpOceanDesc& sea, const std::array<float, 3>& values) const;
};

struct SeaWord {
    const char* name;              // of the option --NAME, and after `set` in scripts
    const char* type;              // what is written after it, for --help
    const char* help;
    std::optional<SeaNumber> number;  // where it is one
    // `option`: how errors call it. Throws UsageError, and has changed nothing then.
    std::function<void(GpOceanDesc& sea, const std::string& option, const std::string& word)> set;
    std::function<std::string(const GpOceanDesc& sea)> get;  // a word that `set` understands
    std::optional<SeaTriple> triple = std::nullopt;  // where it is one
};

// Waves and water, in the order of --help.
const std::vector<SeaWord>& seaWords();
// What only matters where a scene is around the sea: its height, and whether one sees into it.
const std::vector<SeaWord>& seaInSceneWords();
std::vector<const SeaWord*> allSeaWords();
// Of all; null where there is none.
const SeaWord* seaWordNamed(const std::string& name);

// What no word can know by itself. Empty: there is nothing wrong. `dashes` stands before names.
std::string seaFault(const GpOceanDesc& sea, const std::string& dashes);

// Whether both describe the same sea.
bool sameSea(const GpOceanDesc& a, const GpOceanDesc& b);

inline constexpr double kLongestSeaTime = 1e5;  // seconds, either way, where a person writes it

inline constexpr std::pair<const char*, GpOceanSpectrum> kSpectrumWords[] = {
    {"jonswap", GP_SPECTRUM_JONSWAP},
    {"tma", GP_SPECTRUM_TMA},
    {"phillips", GP_SPECTRUM_PHILLIPS},
    {"pierson-moskowitz", GP_SPECTRUM_PIERSON_MOSKOWITZ}};
inline constexpr std::pair<const char*, GpOceanGlints> kSeaGlintWords[] = {
    {"on", GP_GLINTS_ON}, {"off", GP_GLINTS_OFF}, {"deliot", GP_GLINTS_COUNTING}};
inline constexpr std::pair<const char*, GpOceanMasking> kSeaMaskingWords[] = {
    {"vcavity", GP_MASKING_V_CAVITY}, {"smith", GP_MASKING_SMITH}};

}  // namespace gp::tool
