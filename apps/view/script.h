// What `view --script FILE` does in the place of a person: one command a line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gp::tool::view {

enum class ScriptVerb {
    wait,     // N: so many frames of the window
    settle,   // N: until the picture at rest, or that beside, has N samples, a minute at most
    live,     // N: until N more live frames have been shown, a minute at most
    press,    // KEY: hold it down
    release,  // KEY
    mouse,    // X Y: pixels from the window's upper left corner
    down,     // left|right
    up,       // left|right
    wheel,    // STEPS
    size,     // W H: of the window, pixels
    iconify,
    restore,
    set,      // NAME VALUE: what a panel sets
    picture,  // FILE: the picture, .png or .exr
    window,   // FILE: the whole window, .png
    state,    // FILE: where things stand, JSON
    quit
};

struct ScriptCommand {
    ScriptVerb verb = ScriptVerb::wait;
    std::string word, value;   // KEY, NAME, FILE; VALUE
    double numbers[2] = {0, 0};
    std::size_t line = 0;      // from 1
};

// Empty lines and what follows a # are skipped. Throws RunError: "FILE:LINE: what is wrong".
std::vector<ScriptCommand> parseScript(const std::string& text, const std::string& file);

// What waiting commands look at.
struct ScriptWorld {
    double seconds = 0;              // any clock
    std::uint64_t liveFrames = 0;    // shown since the start
    std::uint32_t samplesAtRest = 0; // of the picture shown, or beside it; 0: it is none at rest
    bool saving = false;             // a file is being written
};

// Gives out the commands whose time has come, once each window frame.
class ScriptPlayer {
public:
    ScriptPlayer() = default;
    ScriptPlayer(std::vector<ScriptCommand> commands, std::string file);

    // Settings up to the next other command, which takes a frame of its own. After the last one
    // comes a quit. Throws RunError where a wait took longer than a minute.
    std::vector<ScriptCommand> step(const ScriptWorld& world);
    bool isRunning() const { return m_next < m_commands.size(); }

private:
    bool isOver(const ScriptCommand& command, const ScriptWorld& world) const;
    bool waits(const ScriptCommand& command, const ScriptWorld& world);

    std::vector<ScriptCommand> m_commands;
    std::string m_file;
    std::size_t m_next = 0;
    bool m_waiting = false;
    std::uint64_t m_framesWaited = 0, m_liveBefore = 0;
    double m_since = 0;
};

}  // namespace gp::tool::view
