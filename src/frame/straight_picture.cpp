#include "frame/straight_picture.h"

#include <algorithm>
#include <cmath>

#include "frame/compose.h"

namespace gp {
namespace {

// Coverage sums up to 1 in steps that are rounded; 8 bits do not show less than this.
constexpr float leastCoverage = 1.0f / 1024;

// Before the tone map, which bends sums of light and nothing. [W3C 2003, PNG, section 6.2]
glm::vec4 straightened(glm::vec4 c) {
    if (!(c.w > leastCoverage)) return glm::vec4(0);
    return {glm::vec3(c) / c.w, std::min(c.w, 1.0f)};
}

// Each byte is rounded; the quotient of two that are too large is white.
uint8_t scaled(uint8_t value, double factor) {
    return uint8_t(std::min(std::lround(value * factor), 255L));
}

// The overlay is blended as if over a black display, so colours are multiplied for that time.
void drawOverlayStraight(Backend& backend, const DrawList& overlay, const Camera& camera,
                         FrameImages& images) {
    for (glm::u8vec4& p : images.display)
        for (int c = 0; c < 3; ++c) p[c] = scaled(p[c], p.w / 255.0);
    drawOverlay(backend, overlay, camera, images);
    for (glm::u8vec4& p : images.display)
        for (int c = 0; c < 3; ++c) p[c] = p.w == 0 ? uint8_t(0) : scaled(p[c], 255.0 / p.w);
}

}  // namespace

std::vector<glm::u8vec4> straightPicture(Backend& backend, std::vector<glm::vec4> color,
                                         uint32_t width, uint32_t height,
                                         const ShownPicture& shown) {
    std::transform(color.begin(), color.end(), color.begin(), straightened);
    FrameImages images;
    images.width = width;
    images.height = height;
    images.drawn = std::move(color);
    images.display.resize(images.pixelCount());
    backend.tonemap(shown.exposureEv, shown.tonemap, images);
    if (shown.overlay && !shown.overlay->empty())
        drawOverlayStraight(backend, *shown.overlay, *shown.camera, images);
    return std::move(images.display);
}

}  // namespace gp
