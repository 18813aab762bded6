#include "sea/sea_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <numbers>

#include "parse.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;
constexpr double kMetresPerKilometre = 1000;
constexpr double kStrongestWater = 1000;  // 1/m: ink
constexpr double kHighestSea = 10000;  // metres: where --camera-height still tells waves apart

// Floats that came from radians or metres: the digits that a person wrote.
std::string textOf(double value) {
    return fmt::format("{:.6g}", value);
}

SeaWord numberWord(const char* name, const char* type, const char* help, const SeaNumber& number) {
    return {name, type, help, number,
            [number](GpOceanDesc& sea, const std::string& option, const std::string& word) {
                number.put(sea, parseNumber(option, word, number.low, number.high));
            },
            [number](const GpOceanDesc& sea) { return textOf(number.of(sea)); }};
}

template <class Value, std::size_t count>
SeaWord choiceWord(const char* name, const char* type, const char* help, Value GpOceanDesc::*field,
                   const std::pair<const char*, Value> (&words)[count]) {
    return {name, type, help, std::nullopt,
            [field, &words](GpOceanDesc& sea, const std::string& option, const std::string& word) {
                sea.*field = parseChoice(option, word, words);
            },
            [field, &words](const GpOceanDesc& sea) {
                for (const auto& [word, value] : words) {
                    if (sea.*field == value) {
                        return std::string(word);
                    }
                }
                return std::string();
            }};
}

// `standard`: what the library takes for zero.
SeaWord countWord(const char* name, const char* help, std::uint32_t GpOceanDesc::*field,
                  std::uint64_t low, std::uint64_t high, std::uint32_t standard) {
    return {name, "N", help, std::nullopt,
            [=](GpOceanDesc& sea, const std::string& option, const std::string& word) {
                sea.*field = static_cast<std::uint32_t>(parseInteger(option, word, low, high));
            },
            [=](const GpOceanDesc& sea) {
                return std::to_string(sea.*field == 0 ? standard : sea.*field);
            }};
}

SeaWord tripleWord(const char* name, const char* help, const SeaTriple& triple) {
    return {name, "R,G,B", help, std::nullopt,
            [triple](GpOceanDesc& sea, const std::string& option, const std::string& word) {
                const std::array<float, 3> values = parseTriple(option, word);
                for (const float value : values) {
                    if (!(value >= 0 && static_cast<double>(value) <= triple.high)) {
                        throw UsageError(fmt::format("{}: {:g} is not in 0..{:g}", option, value,
                                                     triple.high));
                    }
                }
                triple.put(sea, values);
            },
            [triple](const GpOceanDesc& sea) {
                const std::array<float, 3> v = triple.of(sea);
                return fmt::format("{:.6g},{:.6g},{:.6g}", v[0], v[1], v[2]);
            },
            triple};
}

// "deep" is what the library writes as zero.
SeaWord depthWord() {
    const SeaNumber number{.field = &GpOceanDesc::depth, .unit = "m", .low = 0.1, .high = 10000};
    return {"depth", "M|deep", "Depth of the water, 0.1..10000 (default deep)", number,
            [number](GpOceanDesc& sea, const std::string& option, const std::string& word) {
                number.put(sea, word == "deep"
                                    ? 0 : parseNumber(option, word, number.low, number.high));
            },
            [](const GpOceanDesc& sea) {
                return sea.depth == 0 ? "deep" : textOf(static_cast<double>(sea.depth));
            }};
}

std::vector<SeaWord> waveWords() {
    return {
        numberWord("wind", "M/S", "Wind at 10 m above the water, 0..100 (default 10)",
                   {&GpOceanDesc::wind, "m/s", 0, 100, 1, 10, GP_GIVEN_WIND}),
        numberWord("wind-direction", "DEG",
                   "Where the wind blows to, from -Z towards +X (default 0: away from the viewer)",
                   {&GpOceanDesc::windDirection, "deg", -360, 360, kRadiansPerDegree}),
        numberWord("fetch", "KM",
                   "Open water that the wind has crossed, 0.1..10000 (default 100)",
                   {&GpOceanDesc::fetch, "km", 0.1, 10000, kMetresPerKilometre, 100}),
        depthWord(),
        choiceWord("spectrum", "NAME",
                   "jonswap, tma (needs --depth), phillips or pierson-moskowitz (default jonswap)",
                   &GpOceanDesc::spectrum, kSpectrumWords),
        numberWord("swell", "0..1", "How much waves run as long parallel crests (default 0)",
                   {&GpOceanDesc::swell, "", 0, 1}),
        numberWord("choppiness", "0..2", "How sharp crests are (default 1)",
                   {&GpOceanDesc::choppiness, "", 0, 2, 1, 1, GP_GIVEN_CHOPPINESS}),
        numberWord("foam", "0..1", "Share of the foam that breaking waves make (default 1)",
                   {&GpOceanDesc::foam, "", 0, 1, 1, 1, GP_GIVEN_FOAM}),
        countWord("sea-seed", "Another number is another sea of the same weather (default 0)",
                  &GpOceanDesc::seed, 0, 0xffffffffu, 0),
        countWord("cascades", "Bands of waves, 1..4 (default 3)", &GpOceanDesc::cascades, 1, 4,
                  3),
        countWord("resolution",
                  "Cells of the waves' shape around the viewer, 16..2048 (default 384; of "
                  "`view` 128)",
                  &GpOceanDesc::resolution, 16, 2048, 384),
        choiceWord("glints", "on|off|deliot",
                   "Facets that can be counted: by a dictionary, or at a fixed cost (default off)",
                   &GpOceanDesc::glints, kSeaGlintWords),
        numberWord("glint-density", "N", "Facets a square metre, 1..1e12 (default 1e6)",
                   {&GpOceanDesc::glintDensity, "", 1, 1e12, 1, 1e6}),
        choiceWord("masking", "vcavity|smith",
                   "How waves below a pixel hide one another (default vcavity)",
                   &GpOceanDesc::masking, kSeaMaskingWords),
        tripleWord("water-absorption",
                   "What the water absorbs, 1/m, 0..1000 (default 0.27,0.065,0.03: clear sea)",
                   {&GpOceanDesc::absorption, kStrongestWater, {0.27f, 0.065f, 0.03f},
                    GP_GIVEN_ABSORPTION}),
        tripleWord("water-scattering",
                   "What it scatters back, 1/m, 0..1000; over what it absorbs this is its colour "
                   "(default 0.0016,0.002,0.003)",
                   {&GpOceanDesc::scattering, kStrongestWater, {0.0016f, 0.002f, 0.003f},
                    GP_GIVEN_SCATTERING}),
        numberWord("water-ior", "N", "Its index of refraction, 1.01..3 (default 1.333)",
                   {&GpOceanDesc::ior, "", 1.01, 3, 1, 1.333})};
}

std::vector<SeaWord> inSceneWords() {
    constexpr static std::pair<const char*, std::int32_t> switchWords[] = {{"on", 1}, {"off", 0}};
    return {numberWord("sea-level", "M", "Height (y) of the water at rest (default 0)",
                       {&GpOceanDesc::level, "m", -kHighestSea, kHighestSea}),
            choiceWord("transparent", "on|off",
                       "Whether one sees what lies in the water, down to where it is black "
                       "(default off)",
                       &GpOceanDesc::transparent, switchWords)};
}

}  // namespace

double SeaNumber::of(const GpOceanDesc& sea) const {
    const double value = static_cast<double>(sea.*field);
    return value == 0 && (sea.given & given) == 0 ? standard : value / siPerUnit;
}

void SeaNumber::put(GpOceanDesc& sea, double value) const {
    sea.*field = static_cast<float>(value * siPerUnit);
    sea.given |= given;
}

std::array<float, 3> SeaTriple::of(const GpOceanDesc& sea) const {
    const float* const v = sea.*field;
    const bool isStandard = (sea.given & given) == 0 && v[0] == 0 && v[1] == 0 && v[2] == 0;
    return isStandard ? standard : std::array<float, 3>{v[0], v[1], v[2]};
}

void SeaTriple::put(GpOceanDesc& sea, const std::array<float, 3>& values) const {
    std::copy(values.begin(), values.end(), sea.*field);
    sea.given |= given;
}

const std::vector<SeaWord>& seaWords() {
    static const std::vector<SeaWord> all = waveWords();
    return all;
}

const std::vector<SeaWord>& seaInSceneWords() {
    static const std::vector<SeaWord> all = inSceneWords();
    return all;
}

std::vector<const SeaWord*> allSeaWords() {
    std::vector<const SeaWord*> all;
    for (const std::vector<SeaWord>* words : {&seaWords(), &seaInSceneWords()}) {
        for (const SeaWord& word : *words) {
            all.push_back(&word);
        }
    }
    return all;
}

const SeaWord* seaWordNamed(const std::string& name) {
    for (const SeaWord* word : allSeaWords()) {
        if (name == word->name) {
            return word;
        }
    }
    return nullptr;
}

std::string seaFault(const GpOceanDesc& sea, const std::string& dashes) {
    if (sea.spectrum == GP_SPECTRUM_TMA && sea.depth == 0) {
        return dashes + "spectrum: tma needs " + dashes + "depth";
    }
    return "";
}

// All fields are four bytes long, so that there is nothing between them.
bool sameSea(const GpOceanDesc& a, const GpOceanDesc& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace gp::tool
