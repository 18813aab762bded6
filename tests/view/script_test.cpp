// Scripts: what is read, what is refused, and when each command's time has come.
#include <gtest/gtest.h>

#include "tool_error.h"
#include "view/script.h"

namespace gp::test {
namespace {

using tool::view::parseScript;
using tool::view::ScriptCommand;
using tool::view::ScriptPlayer;
using tool::view::ScriptVerb;
using tool::view::ScriptWorld;

std::string errorOf(const std::string& text) {
    try {
        parseScript(text, "s.txt");
    } catch (const tool::RunError& error) {
        return error.what();
    }
    return "";
}

TEST(Script, IsReadLineByLine) {
    const std::vector<ScriptCommand> all = parseScript(
        "# a flight\n\n  press W   # go\nmouse 10 -2.5\r\nset image depth\nsize 64 48\ndown left\n",
        "s.txt");
    ASSERT_EQ(all.size(), 5u);
    EXPECT_EQ(all[0].verb, ScriptVerb::press);
    EXPECT_EQ(all[0].word, "W");
    EXPECT_EQ(all[0].line, 3u);
    EXPECT_EQ(all[1].numbers[0], 10);
    EXPECT_EQ(all[1].numbers[1], -2.5);
    EXPECT_EQ(all[2].word, "image");
    EXPECT_EQ(all[2].value, "depth");
    EXPECT_EQ(all[3].numbers[1], 48);
    EXPECT_EQ(all[4].word, "left");
    EXPECT_TRUE(parseScript("", "s.txt").empty());
}

TEST(Script, WhatIsWrongIsToldWithItsLine) {
    EXPECT_EQ(errorOf("wait 1\nwat 2\n"),
              "s.txt:2: there is no command 'wat'; did you mean wait?");
    EXPECT_EQ(errorOf("wait\n"), "s.txt:1: wait takes 1 word(s), not 0");
    EXPECT_EQ(errorOf("quit now\n"), "s.txt:1: quit takes 0 word(s), not 1");
    EXPECT_NE(errorOf("wait 0").find("0 is not in 1.."), std::string::npos);
    EXPECT_NE(errorOf("wait -1").find("not a whole number"), std::string::npos);
    EXPECT_NE(errorOf("mouse 1 x").find("'x' is not a number"), std::string::npos);
    EXPECT_NE(errorOf("down middle").find("left, right"), std::string::npos);
    EXPECT_NE(errorOf("size 0 10").find("0 is not in 1..16384"), std::string::npos);
}

// The verbs that come out in one step.
std::vector<ScriptVerb> stepVerbs(ScriptPlayer& player, const ScriptWorld& world) {
    std::vector<ScriptVerb> verbs;
    for (const ScriptCommand& command : player.step(world)) {
        verbs.push_back(command.verb);
    }
    return verbs;
}

using Verbs = std::vector<ScriptVerb>;

TEST(Script, HandsDoOneThingAFrame) {
    ScriptPlayer player(parseScript("set fps 10\nmouse 1 2\ndown left\nwait 2\nup left\n", "s"),
                        "s");
    const ScriptWorld world;
    EXPECT_EQ(stepVerbs(player, world), (Verbs{ScriptVerb::set, ScriptVerb::mouse}));
    EXPECT_EQ(stepVerbs(player, world), Verbs{ScriptVerb::down});
    EXPECT_EQ(stepVerbs(player, world), Verbs{});  // the wait begins
    EXPECT_EQ(stepVerbs(player, world), Verbs{});
    EXPECT_EQ(stepVerbs(player, world), Verbs{ScriptVerb::up});
    EXPECT_TRUE(player.isRunning());
    EXPECT_EQ(stepVerbs(player, world), Verbs{ScriptVerb::quit});  // after the last command
    EXPECT_FALSE(player.isRunning());
    EXPECT_EQ(stepVerbs(player, world), Verbs{});
}

TEST(Script, WaitsForSamplesAndLiveFramesAndFiles) {
    ScriptPlayer player(parseScript("settle 8\npicture a.png\nlive 2\nquit\n", "s"), "s");
    ScriptWorld world;
    world.samplesAtRest = 100;  // of the view before: one frame goes by before it counts
    EXPECT_EQ(stepVerbs(player, world), Verbs{});
    world.samplesAtRest = 7;
    EXPECT_EQ(stepVerbs(player, world), Verbs{});
    world.samplesAtRest = 8;
    EXPECT_EQ(stepVerbs(player, world), Verbs{ScriptVerb::picture});
    world.saving = true;
    world.liveFrames = 5;
    EXPECT_EQ(stepVerbs(player, world), Verbs{});
    world.saving = false;
    EXPECT_EQ(stepVerbs(player, world), Verbs{});  // live begins, at 5
    world.liveFrames = 6;
    EXPECT_EQ(stepVerbs(player, world), Verbs{});
    world.liveFrames = 7;
    EXPECT_EQ(stepVerbs(player, world), Verbs{ScriptVerb::quit});
}

TEST(Script, DoesNotWaitForEver) {
    ScriptPlayer player(parseScript("\nsettle 8\n", "s.txt"), "s.txt");
    ScriptWorld world;
    world.seconds = 1000;
    player.step(world);
    world.seconds = 1059;
    EXPECT_NO_THROW(player.step(world));
    world.seconds = 1061;
    try {
        player.step(world);
        FAIL() << "it still waits";
    } catch (const tool::RunError& error) {
        EXPECT_STREQ(error.what(), "s.txt:2: nothing came for 60 seconds");
    }
}

}  // namespace
}  // namespace gp::test
