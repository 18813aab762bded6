#include "view/script.h"

#include <fmt/format.h>

#include <sstream>

#include "nearest_word.h"
#include "parse.h"
#include "tool_error.h"

namespace gp::tool::view {
namespace {

// Longer than any first sample of a scene that a script would look at.
constexpr double kLongestWait = 60.0;

enum class Operands { none, count, word, button, number, point, size, pair };

struct VerbInfo {
    const char* name;
    ScriptVerb verb;
    Operands operands;
};

constexpr VerbInfo kVerbs[] = {
    {"wait", ScriptVerb::wait, Operands::count},
    {"settle", ScriptVerb::settle, Operands::count},
    {"live", ScriptVerb::live, Operands::count},
    {"press", ScriptVerb::press, Operands::word},
    {"release", ScriptVerb::release, Operands::word},
    {"mouse", ScriptVerb::mouse, Operands::point},
    {"down", ScriptVerb::down, Operands::button},
    {"up", ScriptVerb::up, Operands::button},
    {"wheel", ScriptVerb::wheel, Operands::number},
    {"size", ScriptVerb::size, Operands::size},
    {"iconify", ScriptVerb::iconify, Operands::none},
    {"restore", ScriptVerb::restore, Operands::none},
    {"set", ScriptVerb::set, Operands::pair},
    {"picture", ScriptVerb::picture, Operands::word},
    {"window", ScriptVerb::window, Operands::word},
    {"state", ScriptVerb::state, Operands::word},
    {"quit", ScriptVerb::quit, Operands::none}};

const VerbInfo& verbNamed(const std::string& name) {
    std::vector<std::string> names;
    for (const VerbInfo& info : kVerbs) {
        if (name == info.name) {
            return info;
        }
        names.emplace_back(info.name);
    }
    const std::string nearest = nearestWord(name, names);
    throw UsageError(fmt::format("there is no command '{}'{}", name,
                                 nearest.empty() ? "" : "; did you mean " + nearest + "?"));
}

std::size_t wordCount(Operands operands) {
    switch (operands) {
        case Operands::none: return 0;
        case Operands::point:
        case Operands::size:
        case Operands::pair: return 2;
        default: return 1;
    }
}

bool isWait(ScriptVerb verb) {
    return verb == ScriptVerb::wait || verb == ScriptVerb::settle || verb == ScriptVerb::live;
}

// Files show what there was when their command came; hands do one thing at a time, since what
// lies under the mouse is known when a frame has been drawn.
bool endsStep(ScriptVerb verb) {
    return verb != ScriptVerb::set;
}

constexpr std::uint64_t kMostFrames = 1000000;
constexpr std::uint64_t kLargestWindow = 16384;

ScriptCommand commandFrom(const std::vector<std::string>& words) {
    const VerbInfo& info = verbNamed(words[0]);
    if (words.size() - 1 != wordCount(info.operands)) {
        throw UsageError(fmt::format("{} takes {} word(s), not {}", words[0],
                                     wordCount(info.operands), words.size() - 1));
    }
    ScriptCommand command;
    command.verb = info.verb;
    switch (info.operands) {
        case Operands::none: break;
        case Operands::count:
            command.numbers[0] =
                static_cast<double>(parseInteger(words[0], words[1], 1, kMostFrames));
            break;
        case Operands::number: command.numbers[0] = parseNumber(words[0], words[1]); break;
        case Operands::button:
            if (words[1] != "left" && words[1] != "right") {
                failChoice(words[0], words[1], {"left", "right"});
            }
            [[fallthrough]];
        case Operands::word: command.word = words[1]; break;
        case Operands::point:
            command.numbers[0] = parseNumber(words[0], words[1]);
            command.numbers[1] = parseNumber(words[0], words[2]);
            break;
        case Operands::size:
            for (std::size_t i = 0; i < 2; ++i) {
                command.numbers[i] = static_cast<double>(
                    parseInteger(words[0], words[i + 1], 1, kLargestWindow));
            }
            break;
        case Operands::pair:
            command.word = words[1];
            command.value = words[2];
            break;
    }
    return command;
}

}  // namespace

std::vector<ScriptCommand> parseScript(const std::string& text, const std::string& file) {
    std::vector<ScriptCommand> commands;
    std::istringstream lines(text);
    std::size_t number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::istringstream stream(line.substr(0, line.find('#')));
        std::vector<std::string> words;
        for (std::string word; stream >> word;) {
            words.push_back(word);
        }
        if (words.empty()) {
            continue;
        }
        try {
            commands.push_back(commandFrom(words));
        } catch (const UsageError& error) {
            throw RunError(fmt::format("{}:{}: {}", file, number, error.what()));
        }
        commands.back().line = number;
    }
    return commands;
}

ScriptPlayer::ScriptPlayer(std::vector<ScriptCommand> commands, std::string file)
    : m_commands(std::move(commands)), m_file(std::move(file)) {
    ScriptCommand end;
    end.verb = ScriptVerb::quit;
    m_commands.push_back(end);
}

bool ScriptPlayer::isOver(const ScriptCommand& command, const ScriptWorld& world) const {
    const auto count = static_cast<std::uint64_t>(command.numbers[0]);
    switch (command.verb) {
        case ScriptVerb::wait: return m_framesWaited >= count;
        case ScriptVerb::settle: return world.samplesAtRest >= count;
        default: return world.liveFrames >= m_liveBefore + count;
    }
}

// Returns whether the command still holds up those behind it.
bool ScriptPlayer::waits(const ScriptCommand& command, const ScriptWorld& world) {
    if (!m_waiting) {
        // One frame at least: what the commands before it changed is not in `world` yet.
        m_waiting = true;
        m_framesWaited = 0;
        m_liveBefore = world.liveFrames;
        m_since = world.seconds;
        return true;
    }
    ++m_framesWaited;
    if (isOver(command, world)) {
        m_waiting = false;
        return false;
    }
    if (command.verb != ScriptVerb::wait && world.seconds - m_since > kLongestWait) {
        throw RunError(fmt::format("{}:{}: nothing came for {} seconds", m_file, command.line,
                                   kLongestWait));
    }
    return true;
}

std::vector<ScriptCommand> ScriptPlayer::step(const ScriptWorld& world) {
    std::vector<ScriptCommand> due;
    while (isRunning() && !world.saving) {
        const ScriptCommand& command = m_commands[m_next];
        if (isWait(command.verb)) {
            if (waits(command, world)) {
                break;
            }
            ++m_next;
            continue;
        }
        ++m_next;
        due.push_back(command);
        if (endsStep(command.verb)) {
            break;
        }
    }
    return due;
}

}  // namespace gp::tool::view
