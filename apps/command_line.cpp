#include "commands.h"

#include <sstream>
#include <vector>

#include "nearest_word.h"

namespace gp::tool {
namespace {

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

CLI::Option* addWords(CLI::App& app, const std::string& name, const std::string& typeName,
                      const std::string& help, std::vector<std::string>& words) {
    return app.add_option(name, words, wrapped(help))
        ->type_name(typeName)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

std::string nearestOption(const CLI::App& app, const std::string& word) {
    std::vector<std::string> known;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            known.push_back("--" + name);
        }
    }
    return nearestWord(word, known);
}

std::string nearestCommand(const CLI::App& app, const std::string& word) {
    std::vector<std::string> known;
    for (const CLI::App* command : app.get_subcommands({})) {
        known.push_back(command->get_name());
    }
    return nearestWord(word, known);
}

}  // namespace gp::tool
