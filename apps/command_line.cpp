#include "commands.h"

#include <algorithm>
#include <numeric>
#include <sstream>
#include <vector>

namespace gp::tool {
namespace {

// [Levenshtein 1966] Letters to insert, delete or replace on the way from a to b.
std::size_t editDistance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
        }
    }
    return row[b.size()];
}

// At most a third of the letters may be wrong, else the guess would be none.
std::string nearest(const std::string& word, const std::vector<std::string>& known) {
    std::string best;
    std::size_t bestDistance = word.size() / 3 + 1;
    for (const std::string& candidate : known) {
        const std::size_t distance = editDistance(word, candidate);
        if (distance < bestDistance) {
            bestDistance = distance;
            best = candidate;
        }
    }
    return best;
}

// The column of descriptions begins at 30, and people's terminals are 100 wide or so.
constexpr std::size_t kHelpColumns = 68;

// CLI11 indents the lines of a description but does not break them.
std::string wrapped(const std::string& text) {
    std::string result;
    std::size_t column = 0;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const bool fits = column + 1 + word.size() <= kHelpColumns;
        if (column > 0) {
            result += fits ? ' ' : '\n';
        }
        column = (column > 0 && fits ? column + 1 : 0) + word.size();
        result += word;
    }
    return result;
}

}  // namespace

CLI::Option* addWord(CLI::App& app, const std::string& names, const std::string& typeName,
                     const std::string& help, std::function<void(const std::string&)> accept) {
    return app.add_option_function<std::string>(names, accept, wrapped(help))->type_name(typeName);
}

std::string nearestOption(const CLI::App& app, const std::string& word) {
    std::vector<std::string> known;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            known.push_back("--" + name);
        }
    }
    return nearest(word, known);
}

std::string nearestCommand(const CLI::App& app, const std::string& word) {
    std::vector<std::string> known;
    for (const CLI::App* command : app.get_subcommands({})) {
        known.push_back(command->get_name());
    }
    return nearest(word, known);
}

}  // namespace gp::tool
