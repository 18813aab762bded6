// gpDraw: rasterised geometry, handed over until the next gpRender of its frame.
#include "api/arrays.h"
#include "api/frames.h"
#include "shading/shading.h"

namespace gp::api {

namespace {

constexpr uint32_t vertexExponent = 24, indexExponent = 26;
constexpr size_t mostDraws = 65536;
constexpr uint64_t mostElements = uint64_t(1) << 26;  // of vertices and indices that wait
constexpr double brightest = 1e6;                     // times itself it is still far from infinite
constexpr double viewportLimit = 32768;

static_assert(GP_DRAW_OVERLAY == int(DrawTarget::overlay) && GP_DRAW_SKY == int(DrawTarget::sky));
static_assert(GP_VIEW_CAMERA == int(DrawView::camera) && GP_VIEW_PIXELS == int(DrawView::pixels) &&
              GP_VIEW_MATRIX == int(DrawView::matrix));
static_assert(GP_CULL_BACK == int(Cull::back) && GP_CULL_FRONT == int(Cull::front));
static_assert(GP_BLEND_ZERO == BLEND_ZERO && GP_BLEND_ONE == BLEND_ONE &&
              GP_BLEND_SRC_COLOR == BLEND_SRC_COLOR &&
              GP_BLEND_ONE_MINUS_SRC_COLOR == BLEND_ONE_MINUS_SRC_COLOR &&
              GP_BLEND_SRC_ALPHA == BLEND_SRC_ALPHA &&
              GP_BLEND_ONE_MINUS_SRC_ALPHA == BLEND_ONE_MINUS_SRC_ALPHA &&
              GP_BLEND_DST_ALPHA == BLEND_DST_ALPHA &&
              GP_BLEND_ONE_MINUS_DST_ALPHA == BLEND_ONE_MINUS_DST_ALPHA &&
              GP_BLEND_DST_COLOR == BLEND_DST_COLOR &&
              GP_BLEND_ONE_MINUS_DST_COLOR == BLEND_ONE_MINUS_DST_COLOR &&
              GP_BLEND_SRC_ALPHA_SATURATE == BLEND_SRC_ALPHA_SATURATE);
static_assert(GP_DEPTH_NEVER == DEPTH_NEVER && GP_DEPTH_LESS == DEPTH_LESS &&
              GP_DEPTH_EQUAL == DEPTH_EQUAL && GP_DEPTH_LESS_OR_EQUAL == DEPTH_LESS_OR_EQUAL &&
              GP_DEPTH_GREATER == DEPTH_GREATER && GP_DEPTH_NOT_EQUAL == DEPTH_NOT_EQUAL &&
              GP_DEPTH_GREATER_OR_EQUAL == DEPTH_GREATER_OR_EQUAL &&
              GP_DEPTH_ALWAYS == DEPTH_ALWAYS);

uint32_t factorFrom(const GpBlendFactor& factor, uint32_t fallback, bool source,
                    const char* field) {
    const uint32_t number = checkEnum(factor, 12, field);
    if (number == GP_BLEND_SRC_ALPHA_SATURATE && !source)
        fail(GP_ERROR_INVALID_ARGUMENT, "{} is GP_BLEND_SRC_ALPHA_SATURATE, which only the source "
             "can have", field);
    return number == GP_BLEND_DEFAULT ? fallback : number;
}

DrawState stateFrom(const GpDrawDesc& d, DrawTarget target) {
    DrawState s;
    s.blend = d.blend != 0;
    s.blendSource = factorFrom(d.blendSource, BLEND_SRC_ALPHA, true, "blendSource");
    s.blendDestination =
        factorFrom(d.blendDestination, BLEND_ONE_MINUS_SRC_ALPHA, false, "blendDestination");
    const uint32_t sourceAlpha = s.blendSource == BLEND_SRC_ALPHA ? BLEND_ONE : s.blendSource;
    s.blendSourceAlpha = factorFrom(d.blendSourceAlpha, sourceAlpha, true, "blendSourceAlpha");
    s.blendDestinationAlpha =
        factorFrom(d.blendDestinationAlpha, s.blendDestination, false, "blendDestinationAlpha");
    const uint32_t test = checkEnum(d.depthTest, 9, "depthTest");
    const bool scene = target == DrawTarget::scene;
    s.depthTest = test != GP_DEPTH_DEFAULT ? test : scene ? DEPTH_LESS_OR_EQUAL : DEPTH_ALWAYS;
    s.depthWrite = d.depthWrite != 0;
    checkRange(d.alphaThreshold, 0, 1, "alphaThreshold");
    s.alphaThreshold = d.alphaThreshold;
    return s;
}

void checkColor(const float* rgba, size_t count, const char* field) {
    for (size_t i = 0; i < count; ++i)
        for (size_t c = 0; c < 4; ++c)
            if (const float v = rgba[4 * i + c]; !(v >= 0 && v <= (c == 3 ? 1 : brightest)))
                checkRange(v, 0, c == 3 ? 1 : brightest, fmt::format("{}[{}]", field, 4 * i + c));
}

void readVertices(DrawCommand& draw, const GpDrawDesc& d) {
    checkCounts(d, vertexExponent, indexExponent);
    const uint32_t components = d.positionComponents ? d.positionComponents : 3;
    if (components != 3 && components != 4)
        fail(GP_ERROR_INVALID_ARGUMENT, "positionComponents is {}, neither 3 nor 4", components);
    if (components == 4) {
        draw.positions =
            copyStrided<glm::vec4>(d.positions, d.vertexCount, d.positionStride, "positionStride");
    } else {
        for (const glm::vec3& p : copyStrided<glm::vec3>(d.positions, d.vertexCount,
                                                         d.positionStride, "positionStride"))
            draw.positions.push_back(glm::vec4(p, 1));
    }
    draw.texCoords =
        copyStrided<glm::vec2>(d.texCoords, d.vertexCount, d.texCoordStride, "texCoordStride");
    draw.colors = copyStrided<glm::vec4>(d.colors, d.vertexCount, d.colorStride, "colorStride");
    checkVertices(draw.positions, "positions");
    checkVertices(draw.texCoords, "texCoords");
    if (!draw.colors.empty()) checkColor(&draw.colors[0].x, draw.colors.size(), "colors");
    draw.indices = indicesFrom(d);
}

// Rows of numbers into glm's columns.
glm::mat4 matrixFrom(const float* rows, int count) {
    glm::mat4 m(1);
    for (int row = 0; row < count; ++row)
        for (int column = 0; column < 4; ++column) m[column][row] = rows[4 * row + column];
    return m;
}

void readView(DrawCommand& draw, const GpDrawDesc& d) {
    const uint32_t view = checkEnum(d.view, 4, "view");
    const bool overlay = draw.target == DrawTarget::overlay;
    draw.view = view != GP_VIEW_DEFAULT ? DrawView(view)
                                        : overlay ? DrawView::pixels : DrawView::camera;
    const bool matrix = !allZero(d.viewProjection, 16);
    if (matrix && draw.view != DrawView::matrix)
        fail(GP_ERROR_INVALID_ARGUMENT, "viewProjection is only for GP_VIEW_MATRIX");
    if (!matrix && draw.view == DrawView::matrix)
        fail(GP_ERROR_INVALID_ARGUMENT, "viewProjection is all zeros");
    checkFinite(d.viewProjection, 16, "viewProjection");
    if (matrix) draw.viewProjection = matrixFrom(d.viewProjection, 4);
    checkFinite(d.worldFromObject, 12, "worldFromObject");
    if (!allZero(d.worldFromObject, 12)) draw.worldFromObject = matrixFrom(d.worldFromObject, 3);
    checkRange(d.viewport, 4, -viewportLimit, viewportLimit, "viewport");
    if (allZero(d.viewport, 4)) return;
    if (!(d.viewport[2] > 0 && d.viewport[3] > 0))
        fail(GP_ERROR_OUT_OF_RANGE, "viewport is {:g} x {:g} pixels", d.viewport[2],
             d.viewport[3]);
    draw.viewport = {d.viewport[0], d.viewport[1], d.viewport[2], d.viewport[3]};
}

DrawCommand drawFrom(DeviceObject& device, const GpDrawDesc& d) {
    DrawCommand draw;
    draw.target = DrawTarget(checkEnum(d.target, 3, "target"));
    if (d.given & ~uint32_t(GP_GIVEN_DRAW_COLOR))
        fail(GP_ERROR_INVALID_ARGUMENT, "given has unknown bits: {:#x}", d.given);
    draw.state = stateFrom(d, draw.target);
    draw.cull = Cull(checkEnum(d.cull, 3, "cull"));
    checkRange(d.depthBias, -1, 1, "depthBias");
    draw.depthBias = d.depthBias;
    readView(draw, d);
    checkColor(d.color, 1, "color");
    if (!allZero(d.color, 4) || (d.given & GP_GIVEN_DRAW_COLOR))
        draw.color = {d.color[0], d.color[1], d.color[2], d.color[3]};
    if (d.texture) draw.texture = resolve(device, d.texture, "texture")->texture;
    readVertices(draw, d);
    return draw;
}

void addDraw(FrameObject& frame, const GpDrawDesc& desc) {
    if (frame.draws.size() >= mostDraws)
        fail(GP_ERROR_TOO_LARGE, "{} draws wait for gpRender, which is the most", mostDraws);
    DrawCommand draw = drawFrom(*frame.device, desc);
    const uint64_t elements = frame.drawElements + draw.positions.size() + draw.indices.size();
    if (elements > mostElements)
        fail(GP_ERROR_TOO_LARGE, "{} vertices and indices would wait for gpRender, more than {}",
             elements, mostElements);
    frame.draws.push_back(std::move(draw));
    frame.drawElements = elements;
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" GpError gpDraw(GpFrame frame, const GpDrawDesc* desc) {
    return enter("gpDraw", "frame", frame, [&](FrameObject& f) {
        checkPointer(desc, "desc");
        addDraw(f, *desc);
    });
}
