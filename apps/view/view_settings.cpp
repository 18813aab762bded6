// ViewModel::set: what the panels set, by name.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numbers>

#include "parse.h"
#include "sea/sea_words.h"
#include "tool_error.h"
#include "view/image_view.h"
#include "view/view_model.h"
#include "view/view_words.h"

namespace gp::tool::view {
namespace {

using Setter = std::function<void(ViewModel&, const std::string& name, const std::string& word)>;

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

bool parseSwitch(const std::string& name, const std::string& word) {
    const std::pair<const char*, bool> choices[] = {{"on", true}, {"off", false}};
    return parseChoice(name, word, choices);
}

void setExposure(ViewModel& model, const std::string& name, const std::string& word) {
    const bool isAuto = word == "auto";
    const double ev = isAuto ? 0.0 : parseNumber(name, word, -100, 100);
    model.choices().autoExposure = isAuto;
    model.choices().exposureEv = isAuto ? model.choices().exposureEv : static_cast<float>(ev);
}

void setImage(ViewModel& model, const std::string& name, const std::string& word) {
    if (imageNamed(word) == nullptr) {
        failChoice(name, word, imageNames());
    }
    model.choices().image = word;
}

void setSky(ViewModel& model, const std::string& name, const std::string& word) {
    const std::array<float, 3> numbers = parseTriple(name, word);
    if (numbers[1] < 0 || numbers[1] > 90 || numbers[2] < 0) {
        throw UsageError(fmt::format("{}: {} is not AZIMUTH,ELEVATION,LUX with an elevation in "
                                     "0..90 and at least 0 lux", name, word));
    }
    Surroundings& s = model.choices().surroundings;
    s.kind = Surroundings::Kind::sky;
    s.azimuthDeg = numbers[0];
    s.elevationDeg = numbers[1];
    s.lux = numbers[2];
}

void setSurroundings(ViewModel& model, const std::string& name, const std::string& word) {
    Surroundings& s = model.choices().surroundings;
    if (word == "loaded") {
        s.kind = Surroundings::Kind::asLoaded;
        return;
    }
    const std::array<float, 3> color = parseTriple(name, word);
    if (*std::min_element(color.begin(), color.end()) < 0) {
        throw UsageError(fmt::format("{}: {} is negative", name, word));
    }
    s.kind = Surroundings::Kind::color;
    std::copy(color.begin(), color.end(), s.color);
}

void setCamera(ViewModel& model, const std::string& name, const std::string& word) {
    if (word == "all") {
        model.goTo(model.facts().wholeScene);
    } else if (word == "start") {
        model.goTo(model.facts().start);
    } else {
        model.goToCamera(static_cast<std::size_t>(parseInteger(name, word, 0, 1u << 20)));
    }
}

void setPosition(ViewModel& model, const std::string& name, const std::string& word) {
    const std::array<float, 3> p = parseTriple(name, word);
    model.camera().position() = {p[0], p[1], p[2]};
    ++model.choices().realtime.cuts;
}

// "NAME=VALUE", or "default" for all of them.
void setTune(ViewModel& model, const std::string& name, const std::string& word) {
    std::map<std::string, float>& numbers = model.choices().realtime.numbers;
    if (word == "default") {
        numbers.clear();
        return;
    }
    const auto [number, value] = parseAssignment(name, word);
    const DenoiserNumber* known = model.facts().denoisers.number(number);
    if (known == nullptr) {
        failChoice(name, number, model.facts().denoisers.numberNames());
    }
    numbers[number] = static_cast<float>(
        parseNumber(number, value, static_cast<double>(known->low),
                    static_cast<double>(known->high)));
}

// "NUMBER.FIELD=VALUE"
void setLight(ViewModel& model, const std::string& name, const std::string& word) {
    const auto [place, value] = parseAssignment(name, word);
    const std::size_t dot = place.find('.');
    if (dot == std::string::npos) {
        throw UsageError(fmt::format("{}: {} is not NUMBER.FIELD=VALUE", name, word));
    }
    const auto index = parseInteger(name, place.substr(0, dot), 0, 1u << 30);
    const std::string field = place.substr(dot + 1);
    model.changeLight(static_cast<std::size_t>(index),
                      [&field, &word = value](SceneLight& light) {
                          setLightField(light, field, word);
                      });
}

void addLightNamed(ViewModel& model, const std::string& name, const std::string& word) {
    const GpLightKind kind = parseChoice(name, word, kLightKindWords);
    if (kind == GP_LIGHT_POLYGON) {
        throw UsageError(fmt::format("{}: polygons come from files and programs only", name));
    }
    model.addLight(kind);
}

void removeLight(ViewModel& model, const std::string& name, const std::string& word) {
    const auto index = parseInteger(name, word, 0, 1u << 30);
    model.changeLight(static_cast<std::size_t>(index),
                      [](SceneLight& light) { light.isRemoved = true; });
}

using Setters = std::vector<std::pair<std::string, Setter>>;

Setters sceneSetters() {
    return {
        {"camera", setCamera},
        {"position", setPosition},
        {"fov",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.camera().lens().verticalFov =
                 static_cast<float>(parseNumber(name, word, 0.01, 179.0) / kDegreesPerRadian);
         }},
        {"exposure", setExposure},
        {"tonemap",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.choices().tonemap = parseChoice(name, word, kTonemapWords);
         }},
        {"image", setImage},
        {"live",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.setLive(parseChoice(name, word, kLiveWords));
         }},
        {"render-scale",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.choices().realtime.renderScale =
                 static_cast<float>(parseNumber(name, word, 0.5, 1.0));
         }},
        {"anti-aliasing",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.choices().realtime.antiAliasing = parseChoice(name, word, kAntiAliasingWords);
         }},
        {"bounces",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.choices().realtime.bounces =
                 static_cast<std::int32_t>(parseInteger(name, word, 0, kMostBounces));
         }},
        {"mirrors",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.choices().realtime.mirrors =
                 static_cast<std::int32_t>(parseInteger(name, word, 0, kMostBounces));
         }},
        {"denoiser",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.choices().realtime.denoiser = m.facts().denoisers.denoiser(name, word);
         }},
        {"light-reuse",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.choices().realtime.lightReuse = parseChoice(name, word, kLightReuseWords);
         }},
        {"indirect-reuse",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.choices().realtime.indirectReuse = parseChoice(name, word, kLightReuseWords);
         }},
        {"eye-adaptation",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.choices().realtime.eye.seconds =
                 static_cast<float>(parseNumber(name, word, 0, kLongestAdaptation));
         }},
        {"tune", setTune},
        {"light", setLight},
        {"add-light", addLightNamed},
        {"remove-light", removeLight},
        {"beside",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.choices().beside = parseSwitch(name, word);
         }},
        {"divider",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.choices().divider = static_cast<float>(parseNumber(name, word, 0, 1));
         }},
        {"reference",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.choices().reference = parseSwitch(name, word);
         }},
        {"samples",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.choices().mostSamples =
                 static_cast<std::uint32_t>(parseInteger(name, word, 1, kMostSamples));
         }},
        {"fps",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.choices().liveSeconds = 1.0 / parseNumber(name, word, kLowestFps, kHighestFps);
         }},
        {"sky", setSky},
        {"surroundings", setSurroundings},
        {"lamp",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.choices().lamp.isOn = parseSwitch(name, word);
         }},
        {"lamp-intensity",
         [](ViewModel& m, const std::string& name, const std::string& word) {
             m.choices().lamp.intensity = static_cast<float>(parseNumber(name, word, 0, 1e9));
         }}};
}

// Waves and water by the words of --help, and their time.
void addSeaSetters(Setters& all) {
    for (const SeaWord* word : allSeaWords()) {
        all.emplace_back(word->name, [word](ViewModel& m, const std::string& name,
                                            const std::string& value) {
            GpOceanDesc sea = m.choices().sea.desc;
            word->set(sea, name, value);
            m.changeSea(sea);
        });
    }
    all.emplace_back("sea", [](ViewModel& m, const std::string& name, const std::string& word) {
        m.setSeaThere(parseSwitch(name, word));
    });
    all.emplace_back("sea-time", [](ViewModel& m, const std::string& name,
                                    const std::string& word) {
        m.setSeaTime(parseNumber(name, word, -kLongestSeaTime, kLongestSeaTime));
    });
    all.emplace_back("sea-speed", [](ViewModel& m, const std::string& name,
                                     const std::string& word) {
        m.setSeaSpeed(parseNumber(name, word, 0, kFastestSea));
    });
    all.emplace_back("sea-pause", [](ViewModel& m, const std::string& name,
                                     const std::string& word) {
        m.pauseSea(parseSwitch(name, word));
    });
}

const Setters& setters() {
    static const Setters all = [] {
        Setters some = sceneSetters();
        addSeaSetters(some);
        return some;
    }();
    return all;
}

}  // namespace

void ViewModel::set(const std::string& name, const std::string& value) {
    for (const auto& [known, setter] : setters()) {
        if (name == known) {
            setter(*this, name, value);
            return;
        }
    }
    failChoice("set", name, settingNames());
}

std::vector<std::string> ViewModel::settingNames() {
    std::vector<std::string> names;
    for (const auto& [name, setter] : setters()) {
        names.push_back(name);
    }
    return names;
}

}  // namespace gp::tool::view
