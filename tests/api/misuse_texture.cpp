#include <cstdint>
#include <fstream>
#include <limits>

#include "api/world.h"

namespace gp::test {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Row row(const char* what, GpError expected, const char* message, void (*change)(GpTextureDesc&)) {
    return {"gpNewTexture", what, expected, message, [change](World& w) {
                GpTextureDesc desc = textureDesc();
                change(desc);
                return made(gpNewTexture(w.device, &desc));
            }};
}

Row fileRow(const char* what, GpError expected, const char* message, const char* content) {
    return {"gpNewTextureFromFile", what, expected, message, [content](World& w) {
                const std::string path = w.folder + "gp_misuse_texture.png";
                std::ofstream(path) << content;
                return made(gpNewTextureFromFile(w.device, path.c_str(), nullptr));
            }};
}

Row updateRow(const char* what, GpError expected, const char* message,
              void (*change)(GpTextureUpdate&)) {
    return {"gpUpdateTexture", what, expected, message, [change](World& w) {
                GpTextureUpdate update{};
                update.width = update.height = 2;
                update.pixels = textureDesc().pixels;
                change(update);
                return gpUpdateTexture(w.texture, &update);
            }};
}

Rows updateRows() {
    Rows rows = {
        {"gpUpdateTexture", "no descriptor", GP_ERROR_INVALID_ARGUMENT, "update is NULL",
         [](World& w) { return gpUpdateTexture(w.texture, nullptr); }},
        updateRow("no width", GP_ERROR_INVALID_ARGUMENT, "width is 0",
                  [](GpTextureUpdate& u) { u.width = 0; }),
        updateRow("no height", GP_ERROR_INVALID_ARGUMENT, "height is 0",
                  [](GpTextureUpdate& u) { u.height = 0; }),
        updateRow("a larger picture", GP_ERROR_OUT_OF_RANGE, "x 0 and width 3 end past",
                  [](GpTextureUpdate& u) { u.width = 3; }),
        updateRow("beside the picture", GP_ERROR_OUT_OF_RANGE, "y 1 and height 2 end past",
                  [](GpTextureUpdate& u) { u.y = 1; }),
        updateRow("numbers that overflow", GP_ERROR_OUT_OF_RANGE, "x 1 and width 4294967295",
                  [](GpTextureUpdate& u) { u.x = 1, u.width = UINT32_MAX; }),
        updateRow("another format", GP_ERROR_INVALID_ARGUMENT, "GP_FORMAT_RGBA8",
                  [](GpTextureUpdate& u) { u.format = GP_FORMAT_RGBA32F; }),
        updateRow("unknown format", GP_ERROR_INVALID_ARGUMENT, "format is 2",
                  [](GpTextureUpdate& u) { u.format = anyEnum<GpPixelFormat>(2); }),
        updateRow("no pixels", GP_ERROR_INVALID_ARGUMENT, "pixels is NULL",
                  [](GpTextureUpdate& u) { u.pixels = nullptr; }),
        updateRow("rows shorter than the pixels", GP_ERROR_OUT_OF_RANGE, "rowBytes is 7",
                  [](GpTextureUpdate& u) { u.rowBytes = 7; }),
        updateRow("rows that overflow", GP_ERROR_TOO_LARGE, "more than memory",
                  [](GpTextureUpdate& u) { u.rowBytes = SIZE_MAX / 2; }),
        {"gpUpdateTexture", "a pixel that is NaN", GP_ERROR_NOT_FINITE, "row 1 of pixels[2] is nan",
         [](World& w) {
             float pixels[8] = {0, 0, 0, 1, 0, 0, 0, 1};
             GpTextureDesc desc{};
             desc.width = 1, desc.height = 2, desc.format = GP_FORMAT_RGBA32F;
             desc.pixels = pixels;
             const GpTexture texture = gpNewTexture(w.device, &desc);
             pixels[6] = nan;
             GpTextureUpdate update{};
             update.width = 1, update.height = 2, update.format = GP_FORMAT_RGBA32F;
             update.pixels = pixels;
             return gpUpdateTexture(texture, &update);
         }},
    };
    addHandleRows<GpTexture>(rows, "gpUpdateTexture", "texture", [](World&, GpTexture t) {
        GpTextureUpdate update{};
        update.width = update.height = 2;
        update.pixels = textureDesc().pixels;
        return gpUpdateTexture(t, &update);
    });
    return rows;
}

Row overridesRow(const char* what, GpError expected, const char* message,
                 void (*change)(GpTextureOverrides&)) {
    return {"gpSetTextureOverrides", what, expected, message, [change](World& w) {
                GpTextureOverrides overrides{};
                overrides.folder = w.folder.c_str();
                change(overrides);
                return gpSetTextureOverrides(w.device, &overrides);
            }};
}

Rows overridesRows() {
    Rows rows = {
        overridesRow("no folder", GP_ERROR_INVALID_ARGUMENT, "folder is NULL",
                     [](GpTextureOverrides& o) { o.folder = nullptr; }),
        overridesRow("a folder that is not there", GP_ERROR_FILE_NOT_FOUND, "nowhere: there is no",
                     [](GpTextureOverrides& o) { o.folder = "nowhere"; }),
        overridesRow("a postfix twice", GP_ERROR_INVALID_ARGUMENT, "postfixes are the same",
                     [](GpTextureOverrides& o) { o.albedoPostfix = "_n"; }),
        {"gpNewTexture", "a broken file in its place", GP_ERROR_FILE_INVALID,
         "gp_misuse_broken_albedo.png", [](World& w) {
             std::ofstream(w.folder + "gp_misuse_broken_albedo.png") << "\x89PNG\r\n\x1a\n";
             GpTextureOverrides overrides{};
             overrides.folder = w.folder.c_str();
             gpSetTextureOverrides(w.device, &overrides);
             GpTextureDesc desc = textureDesc();
             desc.name = "gp_misuse_broken";
             return made(gpNewTexture(w.device, &desc));
         }},
    };
    addHandleRows<GpDevice>(rows, "gpSetTextureOverrides", "device", [](World&, GpDevice d) {
        return gpSetTextureOverrides(d, nullptr);
    });
    return rows;
}

}  // namespace

Rows textureRows() {
    Rows rows = {
        {"gpNewTexture", "no descriptor", GP_ERROR_INVALID_ARGUMENT, "desc is NULL",
         [](World& w) { return made(gpNewTexture(w.device, nullptr)); }},
        {"gpNewTexture", "a descriptor of zeros", GP_ERROR_INVALID_ARGUMENT, "width is 0",
         [](World& w) {
             const GpTextureDesc zeros{};
             return made(gpNewTexture(w.device, &zeros));
         }},
        row("no height", GP_ERROR_INVALID_ARGUMENT, "height is 0",
            [](GpTextureDesc& d) { d.height = 0; }),
        row("too wide", GP_ERROR_TOO_LARGE, "width is 32769",
            [](GpTextureDesc& d) { d.width = 32769; }),
        row("too high", GP_ERROR_TOO_LARGE, "height is 4294967295",
            [](GpTextureDesc& d) { d.height = UINT32_MAX; }),
        row("too many pixels", GP_ERROR_TOO_LARGE, "268435456 pixels",
            [](GpTextureDesc& d) { d.width = d.height = 32768; }),
        row("no pixels", GP_ERROR_INVALID_ARGUMENT, "pixels is NULL",
            [](GpTextureDesc& d) { d.pixels = nullptr; }),
        row("rows shorter than the pixels", GP_ERROR_OUT_OF_RANGE, "rowBytes is 7",
            [](GpTextureDesc& d) { d.rowBytes = 7; }),
        row("rows that overflow", GP_ERROR_TOO_LARGE, "more than memory",
            [](GpTextureDesc& d) { d.rowBytes = SIZE_MAX / 2; }),
        row("unknown format", GP_ERROR_INVALID_ARGUMENT, "format",
            [](GpTextureDesc& d) { d.format = anyEnum<GpPixelFormat>(2); }),
        row("unknown colour space", GP_ERROR_INVALID_ARGUMENT, "colorSpace",
            [](GpTextureDesc& d) { d.colorSpace = anyEnum<GpColorSpace>(2); }),
        row("unknown wrapU", GP_ERROR_INVALID_ARGUMENT, "wrapU",
            [](GpTextureDesc& d) { d.wrapU = anyEnum<GpWrap>(3); }),
        row("unknown wrapV", GP_ERROR_INVALID_ARGUMENT, "wrapV",
            [](GpTextureDesc& d) { d.wrapV = anyEnum<GpWrap>(77); }),
        row("unknown magFilter", GP_ERROR_INVALID_ARGUMENT, "magFilter",
            [](GpTextureDesc& d) { d.magFilter = anyEnum<GpFilter>(2); }),
        row("unknown minFilter", GP_ERROR_INVALID_ARGUMENT, "minFilter",
            [](GpTextureDesc& d) { d.minFilter = anyEnum<GpFilter>(2); }),
        row("a pixel that is NaN", GP_ERROR_NOT_FINITE, "pixels[6] is nan",
            [](GpTextureDesc& d) {
                static const float pixels[16] = {0, 0, 0, 1, 0, 0, nan, 1};
                d.format = GP_FORMAT_RGBA32F;
                d.pixels = pixels;
            }),
        {"gpNewTextureFromFile", "no path", GP_ERROR_INVALID_ARGUMENT, "path is NULL",
         [](World& w) { return made(gpNewTextureFromFile(w.device, nullptr, nullptr)); }},
        {"gpNewTextureFromFile", "empty path", GP_ERROR_INVALID_ARGUMENT, "path is empty",
         [](World& w) { return made(gpNewTextureFromFile(w.device, "", nullptr)); }},
        {"gpNewTextureFromFile", "no such file", GP_ERROR_FILE_NOT_FOUND, "nowhere.png",
         [](World& w) { return made(gpNewTextureFromFile(w.device, "nowhere.png", nullptr)); }},
        fileRow("not an image", GP_ERROR_UNSUPPORTED, "gp_misuse_texture.png", "hello, world\n"),
        fileRow("an empty file", GP_ERROR_FILE_INVALID, "gp_misuse_texture.png", ""),
        fileRow("a truncated PNG", GP_ERROR_FILE_INVALID, "gp_misuse_texture.png",
                "\x89PNG\r\n\x1a\n"),
        {"gpNewTextureFromFile", "unknown wrap", GP_ERROR_INVALID_ARGUMENT, "wrapU",
         [](World& w) {
             GpTextureDesc desc{};
             desc.wrapU = anyEnum<GpWrap>(9);
             return made(gpNewTextureFromFile(w.device, "nowhere.png", &desc));
         }},
    };
    addHandleRows<GpDevice>(rows, "gpNewTexture", "device", [](World&, GpDevice d) {
        const GpTextureDesc desc = textureDesc();
        return made(gpNewTexture(d, &desc));
    });
    addHandleRows<GpDevice>(rows, "gpNewTextureFromFile", "device", [](World&, GpDevice d) {
        return made(gpNewTextureFromFile(d, "nowhere.png", nullptr));
    });
    addHandleRows<GpTexture>(rows, "gpReleaseTexture", "texture",
                             [](World&, GpTexture t) { return gpReleaseTexture(t); });
    for (const Rows& more : {updateRows(), overridesRows()})
        rows.insert(rows.end(), more.begin(), more.end());
    return rows;
}

}  // namespace gp::test
