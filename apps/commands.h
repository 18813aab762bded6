// The subcommands. Each adds its options to the command line and says what to run.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace gp::tool {

struct Command {
    CLI::App* app = nullptr;
    std::function<int()> run;  // returns the exit code; throws UsageError or RunError
};

Command addRenderCommand(CLI::App& tool);
Command addAnimateCommand(CLI::App& tool);
Command addEvaluateCommand(CLI::App& tool);
Command addOceanCommand(CLI::App& tool);
Command addInfoCommand(CLI::App& tool);
Command addViewCommand(CLI::App& tool);
Command addCompareCommand(CLI::App& tool);
Command addMakeSceneCommand(CLI::App& tool);
Command addBrdfCommand(CLI::App& tool);

// An option with one word as its value, given to `accept`.
CLI::Option* addWord(CLI::App& app, const std::string& names, const std::string& typeName,
                     const std::string& help, std::function<void(const std::string&)> accept);
// One that may be repeated: a word each time.
CLI::Option* addWords(CLI::App& app, const std::string& name, const std::string& typeName,
                      const std::string& help, std::vector<std::string>& words);

// The option or subcommand that a mistyped word comes closest to; empty where none is close.
std::string nearestOption(const CLI::App& app, const std::string& word);
std::string nearestCommand(const CLI::App& app, const std::string& word);

}  // namespace gp::tool
