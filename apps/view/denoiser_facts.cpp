#include "view/denoiser_facts.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "library.h"
#include "parse.h"

namespace gp::tool::view {

const DenoiserNumber* DenoiserFacts::number(const std::string& name) const {
    const auto found = std::find_if(numbers.begin(), numbers.end(),
                                    [&name](const DenoiserNumber& n) { return n.name == name; });
    return found == numbers.end() ? nullptr : &*found;
}

std::vector<std::string> DenoiserFacts::numberNames() const {
    std::vector<std::string> all;
    for (const DenoiserNumber& n : numbers) {
        all.push_back(n.name);
    }
    return all;
}

GpDenoiser DenoiserFacts::denoiser(const std::string& option, const std::string& name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        failChoice(option, name, names);
    }
    return static_cast<GpDenoiser>(found - names.begin());
}

std::string DenoiserFacts::nameOf(GpDenoiser denoiser) const {
    const auto index = static_cast<std::size_t>(denoiser);
    return index < names.size() ? names[index] : "";
}

bool DenoiserFacts::isUsedBy(const DenoiserNumber& number, const std::string& user) const {
    return std::find(number.usedBy.begin(), number.usedBy.end(), user) != number.usedBy.end();
}

DenoiserFacts describeDenoisers(GpDevice device) {
    std::size_t size = 0;
    check(device, gpDescribeDenoisers(device, nullptr, 0, &size));
    std::string text(size, '\0');
    check(device, gpDescribeDenoisers(device, text.data(), size, nullptr));
    text.pop_back();  // its closing zero
    const nlohmann::json json = nlohmann::json::parse(text);
    DenoiserFacts facts;
    facts.names = json.at("denoisers").get<std::vector<std::string>>();
    for (const nlohmann::json& p : json.at("parameters")) {
        facts.numbers.push_back({p.at("name"), p.at("meaning"), p.at("default"), p.at("minimum"),
                                 p.at("maximum"),
                                 p.at("used_by").get<std::vector<std::string>>()});
    }
    return facts;
}

}  // namespace gp::tool::view
