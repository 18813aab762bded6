// Keys and mouse: what is held, what was pressed, drags and clicks.
#include <gtest/gtest.h>

#include "view/input_state.h"

namespace gp::test {
namespace {

using tool::view::FrameInput;
using tool::view::InputState;
using tool::view::Key;
using tool::view::MouseButton;

TEST(InputState, KeysThatAreHeldMove) {
    InputState input;
    input.key(Key::forward, true);
    input.key(Key::left, true);
    input.key(Key::fast, true);
    FrameInput frame = input.take();
    EXPECT_EQ(frame.move, glm::vec3(-1, 0, 1));
    EXPECT_TRUE(frame.fast);
    EXPECT_TRUE(frame.isMoving());
    EXPECT_EQ(input.take().move, glm::vec3(-1, 0, 1));  // as long as they are held
    input.key(Key::back, true);  // both: they cancel out
    input.key(Key::left, false);
    EXPECT_EQ(input.take().move, glm::vec3(0, 0, 0));
    EXPECT_FALSE(input.take().isMoving());
}

TEST(InputState, APressIsToldOnce) {
    InputState input;
    input.key(Key::panels, true);
    input.key(Key::panels, true);  // repeats of the keyboard
    EXPECT_EQ(input.take().pressed, std::vector<Key>{Key::panels});
    EXPECT_TRUE(input.take().pressed.empty());
    input.key(Key::panels, false);
    input.key(Key::panels, true);
    EXPECT_EQ(input.take().pressed, std::vector<Key>{Key::panels});
}

TEST(InputState, DragsTurnAndClicksPick) {
    InputState input;
    input.mouse({100, 100});
    input.button(MouseButton::left, true, true);
    input.mouse({102, 101});  // a trembling hand
    EXPECT_EQ(input.take().drag, glm::vec2(0, 0));
    input.button(MouseButton::left, false, true);
    EXPECT_TRUE(input.take().clicked);
    EXPECT_FALSE(input.take().clicked);

    input.button(MouseButton::right, true, true);
    input.mouse({112, 91});
    const FrameInput begun = input.take();
    EXPECT_EQ(begun.drag, glm::vec2(10, -10));
    EXPECT_EQ(begun.dragFrom, glm::vec2(102, 101));
    input.mouse({113, 91});
    input.mouse({114, 91});
    EXPECT_EQ(input.take().drag, glm::vec2(2, 0));
    input.button(MouseButton::right, false, true);
    const FrameInput after = input.take();
    EXPECT_FALSE(after.clicked);
    EXPECT_FALSE(input.take().dragFrom);
    EXPECT_EQ(after.mouse, glm::vec2(114, 91));
    input.mouse({200, 200});
    EXPECT_EQ(input.take().drag, glm::vec2(0, 0));
}

TEST(InputState, WhatBeginsOnAPanelStaysThere) {
    InputState input;
    input.mouse({10, 10});
    input.button(MouseButton::left, true, false);
    input.mouse({500, 300});
    input.button(MouseButton::left, false, true);
    input.wheel(3, false);
    FrameInput frame = input.take();
    EXPECT_EQ(frame.drag, glm::vec2(0, 0));
    EXPECT_FALSE(frame.clicked);
    EXPECT_EQ(frame.wheel, 0);
    input.wheel(1, true);
    input.wheel(1, true);
    EXPECT_EQ(input.take().wheel, 2);
    EXPECT_EQ(input.take().wheel, 0);
}

TEST(InputState, KeysHaveNames) {
    for (const tool::view::KeyInfo& info : tool::view::allKeys()) {
        EXPECT_EQ(tool::view::keyNamed(info.name), info.key) << info.name;
        EXPECT_STRNE(info.meaning, "");
    }
    EXPECT_FALSE(tool::view::keyNamed("F99"));
}

}  // namespace
}  // namespace gp::test
