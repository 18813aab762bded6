#include "render/canvas.h"

#include <cstring>
#include <limits>
#include <stdexcept>

namespace gp::test {

std::vector<std::string> instructionSetsHere() {
    std::vector<std::string> found;
    for (const char* name : {"x86-64", "avx2", "avx512"}) {
        try {
            newCpuBackend({1, name});
            found.push_back(name);
        } catch (const std::runtime_error&) {
            // this machine lacks it
        }
    }
    return found;
}

std::string instructionSetName(const ::testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    for (char& c : name) c = c == '-' ? '_' : c;
    return name;
}

Canvas::Canvas(uint32_t w, uint32_t h, const std::string& instructionSet, uint32_t threads)
    : width(w),
      height(h),
      color(size_t(w) * h, glm::vec4(0)),
      display(size_t(w) * h, glm::u8vec4(0)),
      depth(size_t(w) * h, std::numeric_limits<float>::infinity()),
      backend(newCpuBackend({threads, instructionSet})) {}

void Canvas::draw(const std::vector<DrawCommand>& draws, bool intoDisplay) {
    std::vector<PlacedDraw> placed;
    for (const DrawCommand& d : draws)
        placed.push_back({&d, placeDraw(d, camera, width, height)});
    backend->rasterize({width, height, intoDisplay ? nullptr : color.data(),
                        intoDisplay ? display.data() : nullptr, depth.data()},
                       placed);
}

DrawCommand pixelDraw(std::vector<glm::vec2> corners, glm::vec4 color) {
    DrawCommand d;
    d.view = DrawView::pixels;
    d.color = color;
    d.state.depthTest = DEPTH_ALWAYS;
    for (glm::vec2 c : corners) d.positions.push_back({c, 0, 1});
    return d;
}

DrawCommand countingDraw(std::vector<glm::vec2> corners) {
    DrawCommand d = pixelDraw(std::move(corners));
    d.state.blend = true;
    d.state.blendSource = d.state.blendDestination = BLEND_ONE;
    d.state.blendSourceAlpha = d.state.blendDestinationAlpha = BLEND_ONE;
    return d;
}

DrawCommand rectangleDraw(glm::vec2 from, glm::vec2 to, glm::vec4 color) {
    DrawCommand d = pixelDraw({from, {to.x, from.y}, to, {from.x, to.y}}, color);
    d.texCoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    d.indices = {0, 1, 2, 0, 2, 3};
    return d;
}

std::shared_ptr<const Texture> byteTexture(uint32_t width, uint32_t height,
                                           const std::vector<glm::u8vec4>& texels, Filter filter,
                                           ColorSpace space, bool mipmapped, Wrap wrap) {
    TextureDesc desc;
    desc.image.width = width, desc.image.height = height;
    desc.image.pixels.resize(texels.size() * 4);
    std::memcpy(desc.image.pixels.data(), texels.data(), desc.image.pixels.size());
    desc.colorSpace = space;
    desc.magFilter = desc.minFilter = filter;
    desc.mipmapped = mipmapped;
    desc.wrapU = desc.wrapV = wrap;
    return makeTexture(std::move(desc));
}

}  // namespace gp::test
