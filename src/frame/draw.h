// Rasterised geometry: what an application hands over to be drawn into the picture.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "scene/camera.h"
#include "scene/texture.h"

namespace gp {

enum class DrawTarget : uint32_t { scene, overlay, sky };
enum class DrawView : uint32_t { camera = 1, pixels, matrix };
enum class Cull : uint32_t { none, back, front };

// What happens at a pixel. The numbers are those of shading/blending.glsl; no default is left.
struct DrawState {
    uint32_t blendSource = 0, blendDestination = 0;            // BLEND_…, where blend is set
    uint32_t blendSourceAlpha = 0, blendDestinationAlpha = 0;
    uint32_t depthTest = 0;                                    // DEPTH_…
    bool blend = false, depthWrite = false;
    float alphaThreshold = 0;
};

// One list of triangles. Indices are in range, positions finite, sizes within the limits of gpDraw.
struct DrawCommand {
    DrawTarget target = DrawTarget::scene;
    DrawView view = DrawView::camera;
    Cull cull = Cull::none;
    DrawState state;
    float depthBias = 0;
    glm::vec4 color{1};
    glm::mat4 viewProjection{1};    // of DrawView::matrix
    glm::mat4 worldFromObject{1};
    glm::vec4 viewport{0};          // x, y, width, height; zeros: the whole frame
    std::vector<glm::vec4> positions;
    std::vector<glm::vec2> texCoords;  // may be empty
    std::vector<glm::vec4> colors;     // may be empty
    std::vector<uint32_t> indices;     // empty: vertices in order
    std::shared_ptr<const Texture> texture;

    size_t triangleCount() const {
        return (indices.empty() ? positions.size() : indices.size()) / 3;
    }
};
using DrawList = std::vector<DrawCommand>;

// Where the vertices of a draw come to lie. Rows multiply an object's point: x, y and w give the
// pixel (x / w, y / w), from the upper left corner of the frame; `depth` is what depths compare;
// what makes `near` or `far` negative is cut off.
struct DrawPlacement {
    glm::dvec4 x{0}, y{0}, w{0}, depth{0}, near{0}, far{0};
    uint32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // the pixels that may be drawn to: [x0, x1) …
};

// Throws nothing; a viewport beside the frame gives no pixels.
DrawPlacement placeDraw(const DrawCommand& draw, const Camera& camera, uint32_t width,
                        uint32_t height);

// The same where the draw's own viewport does not count.
DrawPlacement placeInWholeFrame(const DrawCommand& draw, const Camera& camera, uint32_t width,
                                uint32_t height);

struct PlacedDraw {
    const DrawCommand* draw = nullptr;
    DrawPlacement placement;
};

// What is drawn into: pointers to width * height pixels, top row first. One of color and display.
struct DrawImages {
    uint32_t width = 0, height = 0;
    glm::vec4* color = nullptr;      // linear radiance and coverage
    glm::u8vec4* display = nullptr;  // sRGB-encoded
    float* depth = nullptr;          // null: every depth test passes, and none is written
};

}  // namespace gp
