#include "metrics/compare_pictures.h"

#include <cmath>

#include "metrics/color.h"
#include "metrics/parallel.h"
#include "metrics/pixel_errors.h"
#include "metrics/ssim.h"

namespace gp::metrics {
namespace {

Picture displayed(const Picture& picture, PictureKind kind, double exposure) {
    Picture result(picture.width, picture.height);
    const auto scale = static_cast<float>(std::exp2(exposure));
    forEachRow(picture.height, [&](int y) {
        for (int x = 0; x < picture.width; ++x) {
            glm::vec3 shown = picture.at(x, y);
            if (kind == PictureKind::scene) {
                shown = acesTonemap(shown * scale);
            }
            result.at(x, y) =
                srgbFromLinear(glm::clamp(shown, glm::vec3(0.0f), glm::vec3(1.0f)));
        }
    });
    return result;
}

Plane luma(const Picture& encoded) {
    Plane result(encoded.width, encoded.height);
    forEachRow(encoded.height, [&](int y) {
        for (int x = 0; x < encoded.width; ++x) {
            result.at(x, y) = luminance(encoded.at(x, y));
        }
    });
    return result;
}

}  // namespace

Comparison comparePictures(const Picture& test, const Picture& reference, PictureKind kind) {
    Comparison result;
    result.kind = kind;
    result.identical = test.pixels == reference.pixels;
    result.meanTest = meanColor(test);
    result.meanReference = meanColor(reference);
    result.rmse = std::sqrt(meanSquaredError(test, reference));
    result.relmse = relativeMse(test, reference);
    if (kind == PictureKind::scene) {
        result.exposures = exposureRange(reference);
    }
    const Picture shownTest = displayed(test, kind, result.exposures.middle());
    const Picture shownReference = displayed(reference, kind, result.exposures.middle());
    result.psnr = psnr(meanSquaredError(shownTest, shownReference));
    result.ssim = ssim(luma(shownTest), luma(shownReference));
    FlipResult flip =
        kind == PictureKind::scene ? hdrFlip(test, reference) : ldrFlip(test, reference);
    result.flip = flip.mean;
    result.flipMap = std::move(flip.map);
    return result;
}

}  // namespace gp::metrics
