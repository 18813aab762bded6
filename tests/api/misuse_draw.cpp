// Rasterised geometry and immediate mode.
#include <limits>

#include "api/world.h"

namespace gp::test {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

GpDrawDesc triangleDraw() {
    GpDrawDesc desc{};
    desc.positions = trianglePositions;
    desc.vertexCount = 3;
    return desc;
}

Row drawRow(const char* what, GpError expected, const char* message,
            std::function<void(World&, GpDrawDesc&)> change) {
    return {"gpDraw", what, expected, message, [change](World& w) {
                GpDrawDesc desc = triangleDraw();
                change(w, desc);
                return gpDraw(w.frame, &desc);
            }};
}

// A field that a NaN, and a number outside of its range, must not get into.
void addNumberRows(Rows& rows, const std::string& name, const char* shown, float outside,
                   std::function<float&(GpDrawDesc&)> field) {
    for (float value : {nan, inf, outside}) {
        const bool finite = value == outside;
        const std::string what =
            name + (finite ? " out of range" : value > 0 ? " infinite" : " NaN");
        rows.push_back(drawRow(what.c_str(), finite ? GP_ERROR_OUT_OF_RANGE : GP_ERROR_NOT_FINITE,
                               shown, [=](World&, GpDrawDesc& d) { field(d) = value; }));
    }
}

Rows vertexRows() {
    static const float bad[12] = {0, 0, 0, 1, nan, 0, 0, 1, 0, 0, 0, 0};
    static const float negative[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 1};
    static const float alpha[12] = {0, 0, 0, 1, 0, 0, 0, 1.5f, 0, 0, 0, 1};
    static const uint32_t indices[6] = {0, 1, 3, 0, 1, 2};
    return {
        drawRow("no vertices", GP_ERROR_INVALID_ARGUMENT, "vertexCount is 0",
                [](World&, GpDrawDesc& d) { d.vertexCount = 0; }),
        drawRow("too many vertices", GP_ERROR_TOO_LARGE, "more than 2^24",
                [](World&, GpDrawDesc& d) { d.vertexCount = (1u << 24) + 2; }),
        drawRow("no positions", GP_ERROR_INVALID_ARGUMENT, "positions is NULL",
                [](World&, GpDrawDesc& d) { d.positions = nullptr; }),
        drawRow("no whole triangle", GP_ERROR_INVALID_ARGUMENT, "not a multiple of 3",
                [](World&, GpDrawDesc& d) { d.vertexCount = 2; }),
        drawRow("a stride below an element", GP_ERROR_OUT_OF_RANGE, "positionStride is 8",
                [](World&, GpDrawDesc& d) { d.positionStride = 8; }),
        drawRow("two components", GP_ERROR_INVALID_ARGUMENT, "neither 3 nor 4",
                [](World&, GpDrawDesc& d) { d.positionComponents = 2; }),
        drawRow("a position that is NaN", GP_ERROR_NOT_FINITE, "positions[1][1]",
                [](World&, GpDrawDesc& d) { d.positions = bad; }),
        drawRow("a coordinate that is NaN", GP_ERROR_NOT_FINITE, "texCoords[2][0]",
                [](World&, GpDrawDesc& d) { d.texCoords = bad; }),
        drawRow("a colour that is NaN", GP_ERROR_NOT_FINITE, "colors[4]",
                [](World&, GpDrawDesc& d) { d.colors = bad; }),
        drawRow("a colour below 0", GP_ERROR_OUT_OF_RANGE, "colors[9]",
                [](World&, GpDrawDesc& d) { d.colors = negative; }),
        drawRow("an alpha above 1", GP_ERROR_OUT_OF_RANGE, "colors[7] is 1.5, outside of 0..1",
                [](World&, GpDrawDesc& d) { d.colors = alpha; }),
        drawRow("an index past the end", GP_ERROR_OUT_OF_RANGE,
                "indices[2] is 3, but vertexCount is 3",
                [](World&, GpDrawDesc& d) { d.indices = indices, d.indexCount = 3; }),
        drawRow("indices without a count", GP_ERROR_INVALID_ARGUMENT, "indexCount is 0",
                [](World&, GpDrawDesc& d) { d.indices = indices; }),
        drawRow("a count without indices", GP_ERROR_INVALID_ARGUMENT, "indices is NULL",
                [](World&, GpDrawDesc& d) { d.indexCount = 3; }),
        drawRow("too many indices", GP_ERROR_TOO_LARGE, "more than 2^26",
                [](World&, GpDrawDesc& d) {
                    d.indices = indices, d.indexCount = 3u * (1u << 26);
                }),
    };
}

Rows stateRows() {
    Rows rows = {
        drawRow("unknown target", GP_ERROR_INVALID_ARGUMENT, "target is 3",
                [](World&, GpDrawDesc& d) { d.target = anyEnum<GpDrawTarget>(3); }),
        drawRow("unknown bits", GP_ERROR_INVALID_ARGUMENT, "given has unknown bits: 0x2",
                [](World&, GpDrawDesc& d) { d.given = 2; }),
        drawRow("unknown factor", GP_ERROR_INVALID_ARGUMENT, "blendSource is 12",
                [](World&, GpDrawDesc& d) { d.blendSource = anyEnum<GpBlendFactor>(12); }),
        drawRow("saturated destination", GP_ERROR_INVALID_ARGUMENT, "blendDestination",
                [](World&, GpDrawDesc& d) { d.blendDestination = GP_BLEND_SRC_ALPHA_SATURATE; }),
        drawRow("saturated destination alpha", GP_ERROR_INVALID_ARGUMENT, "blendDestinationAlpha",
                [](World&, GpDrawDesc& d) {
                    d.blendDestinationAlpha = GP_BLEND_SRC_ALPHA_SATURATE;
                }),
        drawRow("unknown source alpha", GP_ERROR_INVALID_ARGUMENT, "blendSourceAlpha is 77",
                [](World&, GpDrawDesc& d) { d.blendSourceAlpha = anyEnum<GpBlendFactor>(77); }),
        drawRow("unknown test", GP_ERROR_INVALID_ARGUMENT, "depthTest is 9",
                [](World&, GpDrawDesc& d) { d.depthTest = anyEnum<GpDepthTest>(9); }),
        drawRow("unknown cull", GP_ERROR_INVALID_ARGUMENT, "cull is 3",
                [](World&, GpDrawDesc& d) { d.cull = anyEnum<GpCull>(3); }),
        drawRow("unknown view", GP_ERROR_INVALID_ARGUMENT, "view is 4",
                [](World&, GpDrawDesc& d) { d.view = anyEnum<GpDrawView>(4); }),
        drawRow("a matrix of zeros", GP_ERROR_INVALID_ARGUMENT, "viewProjection is all zeros",
                [](World&, GpDrawDesc& d) { d.view = GP_VIEW_MATRIX; }),
        drawRow("a matrix that does not count", GP_ERROR_INVALID_ARGUMENT,
                "only for GP_VIEW_MATRIX", [](World&, GpDrawDesc& d) { d.viewProjection[0] = 1; }),
        drawRow("a viewport without height", GP_ERROR_OUT_OF_RANGE, "viewport is 4 x 0 pixels",
                [](World&, GpDrawDesc& d) { d.viewport[2] = 4; }),
        drawRow("a texture of another device", GP_ERROR_INVALID_HANDLE,
                "texture belongs to another",
                [](World& w, GpDrawDesc& d) { d.texture = w.foreign.texture; }),
        drawRow("a texture that was released", GP_ERROR_INVALID_HANDLE, "texture was released",
                [](World& w, GpDrawDesc& d) { d.texture = w.released.texture; }),
    };
    addNumberRows(rows, "threshold", "alphaThreshold", 1.5f,
                  [](GpDrawDesc& d) -> float& { return d.alphaThreshold; });
    addNumberRows(rows, "bias", "depthBias", -2,
                  [](GpDrawDesc& d) -> float& { return d.depthBias; });
    addNumberRows(rows, "viewport", "viewport[1]", 4e4f,
                  [](GpDrawDesc& d) -> float& { return d.viewport[1]; });
    addNumberRows(rows, "color", "color[2]", -1,
                  [](GpDrawDesc& d) -> float& { return d.color[2]; });
    rows.push_back(drawRow("transform NaN", GP_ERROR_NOT_FINITE, "worldFromObject[7]",
                           [](World&, GpDrawDesc& d) { d.worldFromObject[7] = nan; }));
    rows.push_back(drawRow("matrix NaN", GP_ERROR_NOT_FINITE, "viewProjection[3]",
                           [](World&, GpDrawDesc& d) {
                               d.view = GP_VIEW_MATRIX, d.viewProjection[3] = nan;
                           }));
    return rows;
}

Row immediateRow(const char* call, const char* what, GpError expected, const char* message,
                 std::function<GpError(World&)> run) {
    return {call, what, expected, message, [run](World& w) { return Outcome(run(w)); }};
}

}  // namespace

Rows drawRows() {
    Rows rows = {
        {"gpDraw", "no descriptor", GP_ERROR_INVALID_ARGUMENT, "desc is NULL",
         [](World& w) { return gpDraw(w.frame, nullptr); }},
        {"gpDraw", "more draws than may wait", GP_ERROR_TOO_LARGE, "65536 draws wait",
         [](World& w) {
             const GpDrawDesc desc = triangleDraw();
             for (int i = 0; i < 65536; ++i)
                 if (gpDraw(w.frame, &desc) != GP_SUCCESS) return GP_ERROR_UNKNOWN;
             return gpDraw(w.frame, &desc);
         }},
        {"gpDraw", "more vertices than may wait", GP_ERROR_TOO_LARGE, "would wait for gpRender",
         [](World& w) {
             std::vector<uint32_t> indices((1u << 25) / 3 * 3 + 3);
             GpDrawDesc desc = triangleDraw();
             desc.indices = indices.data(), desc.indexCount = uint32_t(indices.size());
             if (gpDraw(w.frame, &desc) != GP_SUCCESS) return GP_ERROR_UNKNOWN;
             return gpDraw(w.frame, &desc);
         }},
    };
    for (const Rows& more : {vertexRows(), stateRows()})
        rows.insert(rows.end(), more.begin(), more.end());
    addHandleRows<GpFrame>(rows, "gpDraw", "frame", [](World&, GpFrame f) {
        const GpDrawDesc desc = triangleDraw();
        return gpDraw(f, &desc);
    });
    return rows;
}

Rows immediateHandleRows() {
    Rows rows;
    addHandleRows<GpDevice>(rows, "gpNewImmediate", "device",
                            [](World&, GpDevice d) { return made(gpNewImmediate(d)); });
    const auto add = [&](const char* call, std::function<GpError(GpImmediate)> run) {
        addHandleRows<GpImmediate>(rows, call, "immediate",
                                   [run](World&, GpImmediate i) { return Outcome(run(i)); });
    };
    add("gpReleaseImmediate", gpReleaseImmediate);
    add("gpClearImmediate", gpClearImmediate);
    add("gpColor4f", [](GpImmediate i) { return gpColor4f(i, 1, 1, 1, 1); });
    add("gpNormal3f", [](GpImmediate i) { return gpNormal3f(i, 1, 0, 0); });
    add("gpTexCoord2f", [](GpImmediate i) { return gpTexCoord2f(i, 1, 0); });
    add("gpVertex3f", [](GpImmediate i) { return gpVertex3f(i, 1, 0, 0); });
    add("gpShadeModel", [](GpImmediate i) { return gpShadeModel(i, GP_SHADE_FLAT); });
    add("gpBegin", [](GpImmediate i) { return gpBegin(i, GP_QUADS); });
    add("gpEnd", gpEnd);
    add("gpGetImmediateMesh", [](GpImmediate i) {
        GpMeshDesc desc{};
        return gpGetImmediateMesh(i, &desc);
    });
    add("gpGetImmediateDraw", [](GpImmediate i) {
        GpDrawDesc desc{};
        return gpGetImmediateDraw(i, &desc);
    });
    return rows;
}

Rows immediateRows() {
    const auto inside = [](GpError (*run)(GpImmediate)) {
        return [run](World& w) {
            gpBegin(w.openImmediate, GP_QUADS);  // fails: it is open already
            gpGetError(w.device, nullptr);
            return run(w.openImmediate);
        };
    };
    const char* between = "between gpBegin and gpEnd";
    const GpError wrongNow = GP_ERROR_INVALID_OPERATION, notFinite = GP_ERROR_NOT_FINITE;
    Rows rows = {
        immediateRow("gpBegin", "twice", wrongNow, between,
                     inside([](GpImmediate i) { return gpBegin(i, GP_QUADS); })),
        immediateRow("gpBegin", "unknown primitive", GP_ERROR_INVALID_ARGUMENT, "primitive is 6",
                     [](World& w) { return gpBegin(w.immediate, anyEnum<GpPrimitive>(6)); }),
        immediateRow("gpEnd", "without gpBegin", wrongNow, "without gpBegin",
                     [](World& w) { return gpEnd(w.immediate); }),
        immediateRow("gpVertex3f", "outside", wrongNow, "not between gpBegin and gpEnd",
                     [](World& w) { return gpVertex3f(w.immediate, 0, 0, 0); }),
        immediateRow("gpVertex3f", "NaN", notFinite, "position[2]",
                     [](World& w) { return gpVertex3f(w.openImmediate, 0, 0, nan); }),
        immediateRow("gpColor4f", "NaN", notFinite, "color[3]",
                     [](World& w) { return gpColor4f(w.immediate, 0, 0, 0, nan); }),
        immediateRow("gpNormal3f", "infinite", notFinite, "normal[0]",
                     [](World& w) { return gpNormal3f(w.immediate, inf, 0, 0); }),
        immediateRow("gpTexCoord2f", "NaN", notFinite, "texCoord[1]",
                     [](World& w) { return gpTexCoord2f(w.immediate, 0, nan); }),
        immediateRow("gpShadeModel", "unknown", GP_ERROR_INVALID_ARGUMENT, "model is 2",
                     [](World& w) { return gpShadeModel(w.immediate, anyEnum<GpShadeModel>(2)); }),
        immediateRow("gpShadeModel", "inside", wrongNow, between,
                     inside([](GpImmediate i) { return gpShadeModel(i, GP_SHADE_FLAT); })),
        immediateRow("gpClearImmediate", "inside", wrongNow, between, inside(gpClearImmediate)),
        immediateRow("gpGetImmediateMesh", "inside", wrongNow, between,
                     inside([](GpImmediate i) {
                         GpMeshDesc desc{};
                         return gpGetImmediateMesh(i, &desc);
                     })),
        immediateRow("gpGetImmediateDraw", "nothing there", wrongNow, "no whole triangle",
                     [](World& w) {
                         GpDrawDesc desc{};
                         gpClearImmediate(w.emptyImmediate);
                         return gpGetImmediateDraw(w.emptyImmediate, &desc);
                     }),
        immediateRow("gpGetImmediateMesh", "no place for it", GP_ERROR_INVALID_ARGUMENT,
                     "desc is NULL",
                     [](World& w) { return gpGetImmediateMesh(w.immediate, nullptr); }),
        immediateRow("gpGetImmediateDraw", "no place for it", GP_ERROR_INVALID_ARGUMENT,
                     "desc is NULL",
                     [](World& w) { return gpGetImmediateDraw(w.immediate, nullptr); }),
    };
    const Rows handles = immediateHandleRows();
    rows.insert(rows.end(), handles.begin(), handles.end());
    return rows;
}

}  // namespace gp::test
