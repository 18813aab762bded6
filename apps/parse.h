// From words of the command line to values. Each throws UsageError with a line that names the
// option, the word and what was expected.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gp::tool {

double parseNumber(std::string_view option, std::string_view word);
double parseNumber(std::string_view option, std::string_view word, double low, double high);
// At least low; greater than low where `strictly`.
double parseNumberFrom(std::string_view option, std::string_view word, double low, bool strictly);
std::uint64_t parseInteger(std::string_view option, std::string_view word, std::uint64_t low,
                           std::uint64_t high);

std::vector<std::string> splitAtCommas(std::string_view word);
// "1,2.5,-3"
std::array<float, 3> parseTriple(std::string_view option, std::string_view word);

struct Size {
    std::uint32_t width = 0, height = 0;
};
Size parseSize(std::string_view option, std::string_view word);  // "1280x720"

// "key=value"
std::pair<std::string, std::string> parseAssignment(std::string_view option,
                                                    std::string_view word);

[[noreturn]] void failChoice(std::string_view option, std::string_view word,
                             const std::vector<std::string>& choices);

// The value that belongs to a word of a list; the message of the error lists all words.
template <class Value, std::size_t count>
Value parseChoice(std::string_view option, std::string_view word,
                  const std::pair<const char*, Value> (&choices)[count]) {
    std::vector<std::string> names;
    for (const auto& [name, value] : choices) {
        if (word == name) {
            return value;
        }
        names.emplace_back(name);
    }
    failChoice(option, word, names);
}

}  // namespace gp::tool
