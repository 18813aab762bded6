#include "io/toml_depth.h"

namespace gp::io {

namespace {

// Behind the string that begins at `at` (TOML 1.0: basic or literal, of one line or, after three
// quotes, of many); where it does not end, the end of the text.
size_t skipString(std::string_view text, size_t at) {
    const char quote = text[at];
    const bool multiline = text.substr(at, 3) == std::string_view(quote == '"' ? "\"\"\"" : "'''");
    const std::string_view closing = text.substr(at, multiline ? 3 : 1);
    for (size_t i = at + closing.size(); i < text.size(); ++i) {
        if (text[i] == '\\' && quote == '"') ++i;
        else if (text.substr(i, closing.size()) == closing) return i + closing.size();
        else if (text[i] == '\n' && !multiline) return i;
    }
    return text.size();
}

}  // namespace

size_t lineWithLongKey(std::string_view text, size_t limit) {
    size_t line = 1, dots = 0;
    for (size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (c == '"' || c == '\'') {
            const size_t end = skipString(text, i);
            for (; i < end; ++i) line += text[i] == '\n' ? 1 : 0;
            continue;
        }
        if (c == '#') {
            while (i < text.size() && text[i] != '\n') ++i;
            continue;
        }
        if (c == '.' && ++dots >= limit) return line;
        // Where a key ends for certain; between its parts there may be blanks.
        if (c == '\n' || c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}')
            dots = 0;
        line += c == '\n' ? 1 : 0;
        ++i;
    }
    return 0;
}

}  // namespace gp::io
