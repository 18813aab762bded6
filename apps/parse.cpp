#include "parse.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>

#include "tool_error.h"

namespace gp::tool {
namespace {

template <class... Arguments>
[[noreturn]] void fail(std::string_view option, fmt::format_string<Arguments...> format,
                       Arguments&&... arguments) {
    throw UsageError(fmt::format("{}: {}", option,
                                 fmt::format(format, std::forward<Arguments>(arguments)...)));
}

// The whole word must be a number, and a finite one.
template <class Number>
bool readNumber(std::string_view word, Number& number) {
    if (word.starts_with('+')) {
        word.remove_prefix(1);  // from_chars knows no plus sign
    }
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, number);
    return error == std::errc() && stop == end;
}

}  // namespace

double parseNumber(std::string_view option, std::string_view word) {
    double value = 0;
    if (!readNumber(word, value) || !std::isfinite(value)) {
        fail(option, "'{}' is not a number", word);
    }
    return value;
}

double parseNumber(std::string_view option, std::string_view word, double low, double high) {
    const double value = parseNumber(option, word);
    if (value < low || value > high) {
        fail(option, "{} is not in {}..{}", word, low, high);
    }
    return value;
}

double parseNumberFrom(std::string_view option, std::string_view word, double low,
                       bool strictly) {
    const double value = parseNumber(option, word);
    if (value < low || (strictly && value == low)) {
        fail(option, "{} must be {} {}", word, strictly ? "greater than" : "at least", low);
    }
    return value;
}

std::uint64_t parseInteger(std::string_view option, std::string_view word, std::uint64_t low,
                           std::uint64_t high) {
    std::uint64_t value = 0;
    if (!readNumber(word, value)) {
        fail(option, "'{}' is not a whole number in {}..{}", word, low, high);
    }
    if (value < low || value > high) {
        fail(option, "{} is not in {}..{}", word, low, high);
    }
    return value;
}

std::vector<std::string> splitAtCommas(std::string_view word) {
    std::vector<std::string> parts;
    for (;;) {
        const std::size_t comma = word.find(',');
        parts.emplace_back(word.substr(0, comma));
        if (comma == std::string_view::npos) {
            return parts;
        }
        word.remove_prefix(comma + 1);
    }
}

std::array<float, 3> parseTriple(std::string_view option, std::string_view word) {
    const std::vector<std::string> parts = splitAtCommas(word);
    if (parts.size() != 3) {
        fail(option, "'{}' is not three numbers with commas between them", word);
    }
    std::array<float, 3> triple{};
    for (std::size_t i = 0; i < 3; ++i) {
        triple[i] = static_cast<float>(parseNumber(option, parts[i]));
        if (!std::isfinite(triple[i])) {
            fail(option, "{} is too large", parts[i]);
        }
    }
    return triple;
}

Size parseSize(std::string_view option, std::string_view word) {
    const std::size_t x = word.find('x');
    if (x == std::string_view::npos) {
        fail(option, "'{}' is not WIDTHxHEIGHT, such as 1280x720", word);
    }
    Size size;
    size.width = static_cast<std::uint32_t>(parseInteger(option, word.substr(0, x), 1, 16384));
    size.height = static_cast<std::uint32_t>(parseInteger(option, word.substr(x + 1), 1, 16384));
    return size;
}

std::pair<std::string, std::string> parseAssignment(std::string_view option,
                                                    std::string_view word) {
    const std::size_t sign = word.find('=');
    if (sign == std::string_view::npos || sign == 0 || sign + 1 == word.size()) {
        fail(option, "'{}' is not NAME=VALUE", word);
    }
    return {std::string(word.substr(0, sign)), std::string(word.substr(sign + 1))};
}

void failChoice(std::string_view option, std::string_view word,
                const std::vector<std::string>& choices) {
    fail(option, "unknown '{}' (there are: {})", word, fmt::join(choices, ", "));
}

}  // namespace gp::tool
