// Frames: making, reading, saving; image files.
#include <cstdint>
#include <limits>

#include "api/world.h"

namespace gp::test {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Row frameRow(const char* what, GpError expected, const char* message, uint32_t width,
             uint32_t height, GpFrameMode mode = GP_MODE_REFERENCE) {
    return {"gpNewFrame", what, expected, message, [=](World& w) {
                GpFrameDesc desc{};
                desc.width = width;
                desc.height = height;
                desc.mode = mode;
                return made(gpNewFrame(w.device, &desc));
            }};
}

Row saveRow(const char* what, GpError expected, const char* message, const char* name,
            uint32_t layers = 0) {
    return {"gpSaveFrame", what, expected, message, [=](World& w) {
                GpSaveOptions options{};
                options.layers = layers;
                return gpSaveFrame(w.frame, (w.folder + name).c_str(), &options);
            }};
}

Row imageRow(const char* what, GpError expected, const char* message, const char* name,
             uint32_t width, uint32_t height, bool pixels = true) {
    return {"gpSaveImage", what, expected, message, [=](World& w) {
                static float four[4] = {1, 1, 1, 1};
                const GpImage image = {width, height, pixels ? four : nullptr, 0};
                return gpSaveImage(w.device, (w.folder + name).c_str(), &image);
            }};
}

Rows frameHandleRows() {
    Rows rows;
    addHandleRows<GpDevice>(rows, "gpNewFrame", "device", [](World&, GpDevice d) {
        const GpFrameDesc desc = {1, 1, GP_MODE_REFERENCE};
        return made(gpNewFrame(d, &desc));
    });
    addHandleRows<GpFrame>(rows, "gpReleaseFrame", "frame",
                           [](World&, GpFrame f) { return gpReleaseFrame(f); });
    addHandleRows<GpFrame>(rows, "gpTonemapFrame", "frame", [](World&, GpFrame f) {
        return gpTonemapFrame(f, 0, GP_TONEMAP_AGX);
    });
    addHandleRows<GpFrame>(rows, "gpReadFrameImage", "frame", [](World&, GpFrame f) {
        float pixels[48];
        return gpReadFrameImage(f, GP_IMAGE_COLOR, pixels, sizeof pixels);
    });
    addHandleRows<GpFrame>(rows, "gpSaveFrame", "frame", [](World& w, GpFrame f) {
        return gpSaveFrame(f, (w.folder + "gp_misuse.png").c_str(), nullptr);
    });
    addHandleRows<GpFrame>(rows, "gpGetPassTimes", "frame", [](World&, GpFrame f) {
        uint32_t count;
        return gpGetPassTimes(f, nullptr, 0, &count);
    });
    addHandleRows<GpDevice>(rows, "gpDescribeDenoisers", "device", [](World&, GpDevice d) {
        size_t needed;
        return gpDescribeDenoisers(d, nullptr, 0, &needed);
    });
    addHandleRows<GpFrame>(rows, "gpReadFrameLayer", "frame", [](World&, GpFrame f) {
        float pixel[4];
        return gpReadFrameLayer(f, "motion", pixel, sizeof pixel);
    });
    addHandleRows<GpFrame>(rows, "gpGetFrameStatistics", "frame", [](World&, GpFrame f) {
        GpFrameStatistics statistics;
        return gpGetFrameStatistics(f, &statistics);
    });
    return rows;
}

// Something asked of a rendered real-time frame of 2 x 2 pixels.
Row realtimeRow(const char* call, const char* what, GpError expected, const char* message,
                GpError (*ask)(GpFrame)) {
    return {call, what, expected, message, [ask](World& w) {
                GpFrameDesc desc{};
                desc.width = desc.height = 2;
                desc.mode = GP_MODE_REALTIME;
                const GpFrame frame = gpNewFrame(w.device, &desc);
                if (gpRender(frame, w.scene, nullptr, nullptr) != GP_SUCCESS)
                    return GP_SUCCESS;  // not what is asked for here
                return ask(frame);
            }};
}

}  // namespace

Rows frameRows() {
    Rows rows = {
        {"gpNewFrame", "no descriptor", GP_ERROR_INVALID_ARGUMENT, "desc is NULL",
         [](World& w) { return made(gpNewFrame(w.device, nullptr)); }},
        frameRow("a descriptor of zeros", GP_ERROR_INVALID_ARGUMENT, "width is 0", 0, 0),
        frameRow("no height", GP_ERROR_INVALID_ARGUMENT, "height is 0", 1, 0),
        frameRow("too wide", GP_ERROR_TOO_LARGE, "width is 16385", 16385, 1),
        frameRow("too high", GP_ERROR_TOO_LARGE, "height", 1, UINT32_MAX),
        frameRow("unknown mode", GP_ERROR_INVALID_ARGUMENT, "mode", 1, 1, anyEnum<GpFrameMode>(3)),
        {"gpGetPassTimes", "no place for the count", GP_ERROR_INVALID_ARGUMENT, "count is NULL",
         [](World& w) { return gpGetPassTimes(w.frame, nullptr, 0, nullptr); }},
        {"gpGetPassTimes", "no place for the times", GP_ERROR_INVALID_ARGUMENT, "times is NULL",
         [](World& w) {
             uint32_t count;
             return gpGetPassTimes(w.frame, nullptr, 3, &count);
         }},
        {"gpReadFrameLayer", "of the reference", GP_ERROR_INVALID_OPERATION, "GP_MODE_REALTIME",
         [](World& w) {
             float pixel[4];
             return gpReadFrameLayer(w.frame, "motion", pixel, sizeof pixel);
         }},
        {"gpReadFrameLayer", "no name", GP_ERROR_INVALID_ARGUMENT, "name is NULL",
         [](World& w) {
             float pixel[4];
             return gpReadFrameLayer(w.frame, nullptr, pixel, sizeof pixel);
         }},
        {"gpReadFrameLayer", "no place for it", GP_ERROR_INVALID_ARGUMENT, "pixels is NULL",
         [](World& w) { return gpReadFrameLayer(w.frame, "motion", nullptr, 16); }},
        realtimeRow("gpReadFrameLayer", "unknown layer", GP_ERROR_INVALID_ARGUMENT,
                    "did you mean motion?", [](GpFrame f) {
                        float pixels[16];
                        return gpReadFrameLayer(f, "motoin", pixels, sizeof pixels);
                    }),
        realtimeRow("gpReadFrameLayer", "too small a place", GP_ERROR_INVALID_OPERATION,
                    "has 64 bytes", [](GpFrame f) {
                        float pixels[16];
                        return gpReadFrameLayer(f, "motion", pixels, sizeof pixels - 1);
                    }),
        realtimeRow("gpReadFrameLayer", "heat that was not measured", GP_ERROR_INVALID_OPERATION,
                    "heat_rays: it was rendered without options.realtime.heatMaps", [](GpFrame f) {
                        float pixels[16];
                        return gpReadFrameLayer(f, "heat_rays", pixels, sizeof pixels);
                    }),
        realtimeRow("gpReadFrameImage", "variance of real time", GP_ERROR_INVALID_OPERATION,
                    "no variance image", [](GpFrame f) {
                        float pixels[16];
                        return gpReadFrameImage(f, GP_IMAGE_VARIANCE, pixels, sizeof pixels);
                    }),
        {"gpDescribeDenoisers", "a buffer that is too small", GP_ERROR_INVALID_OPERATION,
         "size is 3", [](World& w) {
             char text[3];
             return gpDescribeDenoisers(w.device, text, sizeof text, nullptr);
         }},
        {"gpGetFrameLayerInfo", "behind the last", GP_ERROR_OUT_OF_RANGE, "index is 1000",
         [](World&) {
             const char *name, *meaning;
             return gpGetFrameLayerInfo(1000, &name, &meaning);
         }},
        {"gpGetFrameLayerInfo", "no place for the name", GP_ERROR_INVALID_ARGUMENT, "name is NULL",
         [](World&) {
             const char* meaning;
             return gpGetFrameLayerInfo(0, nullptr, &meaning);
         }},
        {"gpGetImageInfo", "unknown image", GP_ERROR_INVALID_ARGUMENT, "image is 11",
         [](World&) {
             GpImageInfo info;
             return gpGetImageInfo(GP_IMAGE_COUNT, &info);
         }},
        {"gpGetImageInfo", "no place for it", GP_ERROR_INVALID_ARGUMENT, "info is NULL",
         [](World&) { return gpGetImageInfo(GP_IMAGE_COLOR, nullptr); }},
        {"gpTonemapFrame", "before rendering", GP_ERROR_INVALID_OPERATION, "nothing was rendered",
         [](World& w) { return gpTonemapFrame(w.emptyFrame, 0, GP_TONEMAP_AGX); }},
        {"gpTonemapFrame", "exposure is NaN", GP_ERROR_NOT_FINITE, "exposureEv",
         [](World& w) { return gpTonemapFrame(w.frame, nan, GP_TONEMAP_AGX); }},
        {"gpTonemapFrame", "exposure out of range", GP_ERROR_OUT_OF_RANGE, "exposureEv is 101",
         [](World& w) { return gpTonemapFrame(w.frame, 101, GP_TONEMAP_AGX); }},
        {"gpTonemapFrame", "unknown curve", GP_ERROR_INVALID_ARGUMENT, "tonemap",
         [](World& w) { return gpTonemapFrame(w.frame, 0, anyEnum<GpTonemap>(4)); }},
        {"gpReadFrameImage", "before rendering", GP_ERROR_INVALID_OPERATION, "nothing was rendered",
         [](World& w) {
             float pixels[48];
             return gpReadFrameImage(w.emptyFrame, GP_IMAGE_COLOR, pixels, sizeof pixels);
         }},
        {"gpReadFrameImage", "a buffer that is too small", GP_ERROR_INVALID_OPERATION,
         "size is 191, but the image has 192 bytes",
         [](World& w) {
             float pixels[48];
             return gpReadFrameImage(w.frame, GP_IMAGE_COLOR, pixels, sizeof pixels - 1);
         }},
        {"gpReadFrameImage", "no pixels", GP_ERROR_INVALID_ARGUMENT, "pixels is NULL",
         [](World& w) { return gpReadFrameImage(w.frame, GP_IMAGE_COLOR, nullptr, 1000); }},
        {"gpReadFrameImage", "unknown image", GP_ERROR_INVALID_ARGUMENT, "image is 12",
         [](World& w) {
             float pixels[48];
             return gpReadFrameImage(w.frame, anyEnum<GpFrameImage>(12), pixels, sizeof pixels);
         }},
        {"gpSaveFrame", "no path", GP_ERROR_INVALID_ARGUMENT, "path is NULL",
         [](World& w) { return gpSaveFrame(w.frame, nullptr, nullptr); }},
        {"gpSaveFrame", "before rendering", GP_ERROR_INVALID_OPERATION, "nothing was rendered",
         [](World& w) {
             return gpSaveFrame(w.emptyFrame, (w.folder + "gp_misuse.png").c_str(), nullptr);
         }},
        saveRow("an unknown ending", GP_ERROR_INVALID_ARGUMENT, "none of .png, .exr, .hdr",
                "gp_misuse.tiff"),
        saveRow("no ending", GP_ERROR_INVALID_ARGUMENT, "none of .png, .exr, .hdr", "gp_misuse"),
        saveRow("layers in a PNG", GP_ERROR_INVALID_ARGUMENT, "only .exr", "gp_misuse.png",
                1u << GP_IMAGE_ALBEDO),
        saveRow("unknown layers", GP_ERROR_INVALID_ARGUMENT, "options.layers has unknown bits",
                "gp_misuse.exr", 1u << GP_IMAGE_COUNT),
        saveRow("a folder that is not there", GP_ERROR_FILE_WRITE, "gp_misuse.png",
                "gp/no/such/folder/gp_misuse.png"),
        {"gpSaveFrame", "alpha in a .hdr", GP_ERROR_INVALID_ARGUMENT, "options.alpha: .hdr",
         [](World& w) {
             GpSaveOptions options{};
             options.alpha = 1;
             return gpSaveFrame(w.frame, (w.folder + "gp_misuse.hdr").c_str(), &options);
         }},
        {"gpGetFrameStatistics", "no place for them", GP_ERROR_INVALID_ARGUMENT,
         "statistics is NULL", [](World& w) { return gpGetFrameStatistics(w.frame, nullptr); }},
    };
    const Rows more = frameHandleRows();
    rows.insert(rows.end(), more.begin(), more.end());
    return rows;
}

Rows imageRows() {
    Rows rows = {
        {"gpLoadImage", "no path", GP_ERROR_INVALID_ARGUMENT, "path is NULL",
         [](World& w) {
             GpImage image;
             return gpLoadImage(w.device, nullptr, &image);
         }},
        {"gpLoadImage", "no place for it", GP_ERROR_INVALID_ARGUMENT, "image is NULL",
         [](World& w) { return gpLoadImage(w.device, "nowhere.png", nullptr); }},
        {"gpLoadImage", "no such file", GP_ERROR_FILE_NOT_FOUND, "nowhere.png",
         [](World& w) {
             GpImage image = {7, 7, nullptr, 7};
             const GpError error = gpLoadImage(w.device, "nowhere.png", &image);
             return image.width == 7 ? error : GP_ERROR_UNKNOWN;
         }},
        {"gpLoadImage", "a folder", GP_ERROR_FILE_INVALID, "not a regular file",
         [](World& w) {
             GpImage image;
             return gpLoadImage(w.device, w.folder.c_str(), &image);
         }},
        {"gpSaveImage", "no image", GP_ERROR_INVALID_ARGUMENT, "image is NULL",
         [](World& w) { return gpSaveImage(w.device, "gp_misuse.png", nullptr); }},
        imageRow("zeros", GP_ERROR_INVALID_ARGUMENT, "width is 0", "gp_misuse.png", 0, 0, false),
        imageRow("no pixels", GP_ERROR_INVALID_ARGUMENT, "image.pixels is NULL", "gp_misuse.exr", 1,
                 1, false),
        imageRow("too wide", GP_ERROR_TOO_LARGE, "width", "gp_misuse.hdr", 32769, 1),
        imageRow("an unknown ending", GP_ERROR_INVALID_ARGUMENT, "none of", "gp_misuse.bmp", 1, 1),
        imageRow("a folder that is not there", GP_ERROR_FILE_WRITE, "", "gp/no/such/one.exr", 1, 1),
        {"gpFreeImage", "NULL and zeros", GP_SUCCESS, "",
         [](World&) {
             GpImage zeros{};
             gpFreeImage(nullptr);
             gpFreeImage(&zeros);
             gpFreeImage(&zeros);
             return GP_SUCCESS;
         },
         true},
    };
    addHandleRows<GpDevice>(rows, "gpLoadImage", "device", [](World&, GpDevice d) {
        GpImage image;
        return gpLoadImage(d, "nowhere.png", &image);
    });
    addHandleRows<GpDevice>(rows, "gpSaveImage", "device", [](World& w, GpDevice d) {
        float pixel[4] = {1, 1, 1, 1};
        const GpImage image = {1, 1, pixel, 0};
        return gpSaveImage(d, (w.folder + "gp_misuse.png").c_str(), &image);
    });
    return rows;
}

}  // namespace gp::test
