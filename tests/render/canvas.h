// What the tests of rasterised geometry share: images to draw into, by one instruction set.
#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "backend/backend.h"
#include "frame/draw.h"
#include "shading/shading.h"

namespace gp::test {

std::vector<std::string> instructionSetsHere();
std::string instructionSetName(const ::testing::TestParamInfo<std::string>& info);

struct Canvas {
    Canvas(uint32_t width, uint32_t height, const std::string& instructionSet = {},
           uint32_t threads = 1);

    void draw(const std::vector<DrawCommand>& draws, bool intoDisplay = false);
    void draw(const DrawCommand& draw) { this->draw(std::vector<DrawCommand>{draw}); }
    glm::vec4& at(uint32_t x, uint32_t y) { return color[size_t(y) * width + x]; }

    uint32_t width, height;
    Camera camera;
    std::vector<glm::vec4> color;      // zeros at first
    std::vector<glm::u8vec4> display;  // zeros at first
    std::vector<float> depth;          // infinite at first
    std::unique_ptr<Backend> backend;
};

// In pixels of the whole canvas, without tests and blending: what is drawn is what is there.
DrawCommand pixelDraw(std::vector<glm::vec2> corners, glm::vec4 color = glm::vec4(1));
// Adds: how often a pixel was drawn is its colour.
DrawCommand countingDraw(std::vector<glm::vec2> corners);
// Two triangles from corner to corner, texture coordinates from 0 to 1, v downwards.
DrawCommand rectangleDraw(glm::vec2 from, glm::vec2 to, glm::vec4 color = glm::vec4(1));
// 8-bit RGBA; no smaller copies unless `mipmapped`.
std::shared_ptr<const Texture> byteTexture(uint32_t width, uint32_t height,
                                           const std::vector<glm::u8vec4>& texels, Filter filter,
                                           ColorSpace space = ColorSpace::linear,
                                           bool mipmapped = false, Wrap wrap = Wrap::repeat);

}  // namespace gp::test
