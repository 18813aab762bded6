// ViewModel: the sea, and its time.
#include <algorithm>
#include <cmath>

#include "sea/sea_words.h"
#include "tool_error.h"
#include "view/view_model.h"

namespace gp::tool::view {
namespace {

constexpr double kStepSeconds = 1.0 / 24;
// The library's, some 11 days: there the waves stand.
constexpr double kLastSecond = 1e6;
// Water that leaps by more is not followed from frame to frame: it is another picture.
constexpr double kCutSeconds = 1;
constexpr const char* kNoSea = "there is no sea (--ocean)";

nlohmann::ordered_json jsonOf(const SeaWord& word, const GpOceanDesc& sea) {
    const double value = word.number ? word.number->of(sea) : 0;
    if (word.number && value >= word.number->low) {
        return value;
    }
    return word.get(sea);
}

}  // namespace

void ViewModel::needSea() const {
    if (!m_choices.sea.isThere) {
        throw UsageError(kNoSea);
    }
}

void ViewModel::setSeaThere(bool isThere) {
    m_choices.sea.isThere = isThere;
    m_hovered.reset();
    m_hoveredId = 0;
}

void ViewModel::changeSea(const GpOceanDesc& desc) {
    needSea();
    if (const std::string fault = seaFault(desc, ""); !fault.empty()) {
        throw UsageError(fault);
    }
    m_choices.sea.desc = m_seaDraft = desc;
    const auto isOfSea = [this](const std::optional<PickedThing>& thing) {
        return thing && thing->instance == m_facts.index.instanceCount();
    };
    for (std::optional<PickedThing>* thing : {&m_hovered, &m_pinned}) {
        if (isOfSea(*thing)) {
            *thing = thingAt((*thing)->instance + 1);
        }
    }
}

void ViewModel::finishSeaDraft() {
    try {
        changeSea(m_seaDraft);
    } catch (const UsageError& error) {
        m_seaDraft = m_choices.sea.desc;
        m_message = {true, error.what()};
    }
}

void ViewModel::setSeaTime(double seconds) {
    needSea();
    if (std::abs(seconds - m_choices.sea.seconds) > kCutSeconds) {
        ++m_choices.realtime.cuts;
    }
    m_choices.sea.seconds = std::clamp(seconds, -kLastSecond, kLastSecond);
}

void ViewModel::setSeaSpeed(double speed) {
    needSea();
    m_choices.sea.speed = speed;
}

void ViewModel::pauseSea(bool isPaused) {
    needSea();
    m_choices.sea.isPaused = isPaused;
}

void ViewModel::stepSea() {
    pauseSea(true);
    setSeaTime(m_choices.sea.seconds + kStepSeconds);
}

void ViewModel::pressSea(Key key) {
    if (!m_choices.sea.isThere) {
        accept(ViewNote{false, kNoSea});
    } else if (key == Key::seaPause) {
        pauseSea(!m_choices.sea.isPaused);
    } else {
        stepSea();
    }
}

void ViewModel::advanceSea(double seconds) {
    SeaChoices& sea = m_choices.sea;
    if (seaMoves()) {
        sea.seconds = std::min(sea.seconds + seconds * sea.speed, kLastSecond);
    }
}

// The sea comes after all things of the file.
std::optional<PickedThing> ViewModel::thingAt(std::uint32_t id) const {
    const std::size_t number = m_facts.index.instanceCount();
    if (!m_choices.sea.isThere || id != number + 1) {
        return m_facts.index.thingAt(id);
    }
    PickedThing sea;
    sea.instance = static_cast<std::uint32_t>(number);
    sea.instanceName = sea.meshName = sea.materialName = "sea";
    sea.model = "water";
    for (const SeaWord* word : allSeaWords()) {
        sea.parameters.emplace_back(word->name, word->get(m_choices.sea.desc));
    }
    return sea;
}

nlohmann::ordered_json ViewModel::seaJson() const {
    const SeaChoices& sea = m_choices.sea;
    if (!sea.isThere) {
        return nullptr;
    }
    nlohmann::ordered_json json = {{"seconds", sea.seconds}, {"speed", sea.speed},
                                   {"paused", sea.isPaused}, {"moves", seaMoves()}};
    for (const SeaWord* word : allSeaWords()) {
        json[word->name] = jsonOf(*word, sea.desc);
    }
    return json;
}

}  // namespace gp::tool::view
