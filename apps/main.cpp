// glitterpath: the command. One file a subcommand; this one reads the command line and turns
// every failure into one line and an exit code.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <new>
#include <string>
#include <vector>

#include "commands.h"
#include "library.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  glitterpath make-scene still-life -o still-life.glb\n"
    "  glitterpath info still-life.glb\n"
    "  glitterpath render still-life.glb -o still-life.png --time-limit 60\n"
    "  glitterpath animate fox.glb --frames 48 --path orbit -o fox.mp4\n"
    "  glitterpath ocean --wind 8 --sun 0,5 -o sea.png\n"
    "  glitterpath compare test.exr reference.exr --heatmap difference.png\n"
    "  glitterpath brdf eval ward --wi 0,0,1 --wo 1,0,1\n\n"
    "`glitterpath SUBCOMMAND --help` tells all of a subcommand; docs/manual.md is the manual.\n"
    "Exit codes: 0 done; 1 failed, or a threshold was passed; 2 command line not understood;\n"
    "130 interrupted.";

// Whatever a library put into its message, people and scripts get one line.
std::string oneLine(std::string text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) {
        text.pop_back();
    }
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 32; }, ' ');
    return text;
}

int fail(int exitCode, const std::string& message) {
    fmt::print(stderr, "glitterpath: error: {}\n", oneLine(message));
    return exitCode;
}

// CLI11 takes "-1,2,3" for a value but "-.5,1,2" for an option: the zero is added.
std::vector<std::string> reversedArguments(int count, char** arguments) {
    std::vector<std::string> words;
    for (int i = count - 1; i > 0; --i) {
        std::string word = arguments[i];
        if (word.size() > 2 && word[0] == '-' && word[1] == '.' &&
            std::isdigit(static_cast<unsigned char>(word[2])) != 0) {
            word.insert(1, "0");
        }
        words.push_back(std::move(word));
    }
    return words;
}

std::string suggestion(const std::string& nearest) {
    return nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest);
}

// The subcommand of a subcommand that was chosen, or itself.
const CLI::App* innermost(const CLI::App* app) {
    while (app != nullptr && !app->get_subcommands().empty()) {
        app = app->get_subcommands().front();
    }
    return app;
}

// The words that no option and no subcommand took.
void refuseExtras(const CLI::App& tool, const CLI::App* chosenCommand) {
    const CLI::App* command = innermost(chosenCommand);
    const std::vector<std::string> rootExtras = tool.remaining();
    const std::vector<std::string> extras = command ? command->remaining() : rootExtras;
    if (extras.empty()) {
        return;
    }
    const std::string& word = extras.front();
    const CLI::App& parent = command ? *command : tool;
    if (word.starts_with('-') && word.size() > 1) {
        throw UsageError(
            fmt::format("unknown option '{}'{}", word, suggestion(nearestOption(parent, word))));
    }
    if (!parent.get_subcommands({}).empty()) {
        throw UsageError(fmt::format("unknown subcommand '{}'{}", word,
                                     suggestion(nearestCommand(parent, word))));
    }
    throw UsageError(fmt::format("unexpected argument '{}'", word));
}

const Command* chosen(const std::vector<Command>& commands) {
    for (const Command& command : commands) {
        if (command.app->parsed()) {
            return &command;
        }
    }
    return nullptr;
}

int run(int argumentCount, char** arguments) {
    CLI::App tool("Glitterpath: a physically based renderer.", "glitterpath");
    tool.set_version_flag("--version",
                          fmt::format("glitterpath {}.{}.{}", GP_VERSION_MAJOR, GP_VERSION_MINOR,
                                      GP_VERSION_PATCH),
                          "Print the version");
    tool.set_help_flag("-h,--help", "Print this help");
    tool.footer(kExamples);
    tool.allow_extras();
    std::vector<Command> commands = {addRenderCommand(tool), addInfoCommand(tool),
                                     addCompareCommand(tool), addMakeSceneCommand(tool),
                                     addBrdfCommand(tool)};
    commands.push_back(addAnimateCommand(tool));
    commands.push_back(addEvaluateCommand(tool));
    commands.push_back(addViewCommand(tool));
    commands.push_back(addOceanCommand(tool));
    for (const Command& command : commands) {
        command.app->allow_extras();
        command.app->fallthrough(false);
        command.app->set_help_flag("-h,--help", "Print this help");
    }
    const Command* command = nullptr;
    try {
        tool.parse(reversedArguments(argumentCount, arguments));
        command = chosen(commands);
        refuseExtras(tool, command ? command->app : nullptr);
        if (command == nullptr) {
            throw UsageError(
                "a subcommand is missing: render, animate, evaluate, view, ocean, info, compare, "
                "make-scene or brdf");
        }
        return command->run();
    } catch (const CLI::Success& help) {
        return tool.exit(help);
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
}

}  // namespace
}  // namespace gp::tool

int main(int argumentCount, char** arguments) {
    using namespace gp::tool;
    try {
        return run(argumentCount, arguments);
    } catch (const UsageError& error) {
        return fail(kExitUsage, fmt::format("{} (see --help)", error.what()));
    } catch (const std::bad_alloc&) {
        return fail(kExitFailure, "out of memory");
    } catch (const std::exception& error) {
        return fail(kExitFailure, error.what());
    }
}
