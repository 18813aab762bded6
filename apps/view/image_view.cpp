#include "view/image_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <string_view>

#include "metrics/color.h"
#include "metrics/magma.h"
#include "picture_grid.h"

namespace gp::tool::view {
namespace {

struct NamedScale {
    std::string_view name;
    ImageScale scale;
};

constexpr NamedScale kScales[] = {
    {"color", ImageScale::light},       {"display", ImageScale::display},
    {"albedo", ImageScale::light},      {"normal", ImageScale::direction},
    {"depth", ImageScale::distance},    {"emission", ImageScale::light},
    {"direct", ImageScale::light},      {"indirect", ImageScale::light},
    {"roughness", ImageScale::data},    {"variance", ImageScale::deviation},
    {"instance", ImageScale::number},   {"view", ImageScale::direction},
    {"material", ImageScale::data},     {"throughput", ImageScale::data},
    {"gradient", ImageScale::data},     {"gradient_other", ImageScale::data},
    {"history_length", ImageScale::data},
    {"specular_albedo", ImageScale::light},  {"specular", ImageScale::light},
    {"direct_history", ImageScale::light},   {"specular_history", ImageScale::light},
    {"direct_other", ImageScale::light},     {"specular_other", ImageScale::light},
    {"output", ImageScale::light},           {"heat_rays", ImageScale::heat},
    {"heat_time", ImageScale::heat},         {"heat_variance", ImageScale::heat}};

// Depth is shown between these, so that one far pixel does not make all others white.
constexpr double kNearQuantile = 0.01;
constexpr double kFarQuantile = 0.99;
// The same for heat: what was interrupted, or is lit by chance, would make all else black.
constexpr double kHeatQuantile = 0.99;
// The farthest surface is a dark grey: black means that nothing is there.
constexpr float kFarGrey = 0.08f;

using Pixels = std::vector<std::uint8_t>;

void put(Pixels& out, const glm::vec3& srgb) {
    const Rgb8 rgb = rgb8FromSrgb(srgb);
    out.insert(out.end(), {rgb[0], rgb[1], rgb[2], 255});
}

glm::vec3 encoded(const glm::vec3& light) {
    glm::vec3 clipped{};
    for (int c = 0; c < 3; ++c) {
        clipped[c] = std::isfinite(light[c]) ? std::clamp(light[c], 0.0f, 1.0f) : 1.0f;
    }
    return metrics::srgbFromLinear(clipped);
}

glm::vec3 finite(const glm::vec3& v) {
    glm::vec3 result{};
    for (int c = 0; c < 3; ++c) {
        result[c] = std::isfinite(v[c]) ? v[c] : 0.0f;
    }
    return result;
}

// Neighbouring numbers get colours far apart: the golden ratio never comes round.
glm::vec3 colorOfNumber(std::uint32_t number) {
    if (number == 0) {
        return glm::vec3(0.0f);
    }
    const double turns = std::fmod(0.618033988749895 * number, 1.0);
    const auto wave = [turns](double offset) {
        return static_cast<float>(0.55 + 0.4 * std::cos(2.0 * 3.14159265358979 * (turns - offset)));
    };
    return {wave(0.0), wave(1.0 / 3.0), wave(2.0 / 3.0)};
}

float quantile(std::vector<float>& values, double share) {
    const auto index = static_cast<std::size_t>(
        std::lround(share * static_cast<double>(values.size() - 1)));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(index),
                     values.end());
    return values[index];
}

bool isSeen(float depth) {
    return std::isfinite(depth) && depth > 0;
}

void putDepths(Pixels& out, const float* depths, std::size_t count) {
    std::vector<float> seen;
    std::copy_if(depths, depths + count, std::back_inserter(seen), isSeen);
    const float low = seen.empty() ? 1.0f : std::log2(quantile(seen, kNearQuantile));
    const float high = seen.empty() ? 1.0f : std::log2(quantile(seen, kFarQuantile));
    const float width = std::max(high - low, 1.0e-6f);
    for (std::size_t i = 0; i < count; ++i) {
        if (!isSeen(depths[i])) {
            put(out, glm::vec3(0.0f));
            continue;
        }
        const float t = std::clamp((std::log2(depths[i]) - low) / width, 0.0f, 1.0f);
        put(out, glm::vec3(1.0f + t * (kFarGrey - 1.0f)));
    }
}

void putRange(Pixels& out, const float* values, std::size_t count, std::size_t channels) {
    float largest = 0;
    for (std::size_t i = 0; i < count * channels; ++i) {
        // The fourth channel of four is no colour: it neither shows nor scales.
        const bool shown = channels == 1 || i % channels < 3;
        largest = shown && std::isfinite(values[i]) ? std::max(largest, std::abs(values[i]))
                                                    : largest;
    }
    const float scale = largest > 0 ? 0.5f / largest : 0.0f;
    for (std::size_t i = 0; i < count; ++i) {
        const float* v = values + i * channels;
        const glm::vec3 value = channels == 1 ? glm::vec3(v[0]) : glm::vec3(v[0], v[1], v[2]);
        put(out, glm::vec3(0.5f) + scale * finite(value));
    }
}

// A variance spans powers of ten; its root is what a person sees as noise.
bool isVariance(std::string_view name) {
    return name == "heat_variance";
}

float heatOf(std::string_view name, float value) {
    const float finiteValue = std::isfinite(value) ? std::max(value, 0.0f) : 0.0f;
    return isVariance(name) ? std::sqrt(finiteValue) : finiteValue;
}

void putHeat(Pixels& out, const std::string& name, const float* rgba, std::size_t count) {
    const float high = heatScaleOf(name, rgba, count).high;
    for (std::size_t i = 0; i < count; ++i) {
        put(out, heatColor(high > 0 ? heatOf(name, rgba[4 * i]) / high : 0.0f));
    }
}

glm::vec3 visible(ImageScale scale, const glm::vec3& value, float factor) {
    switch (scale) {
        case ImageScale::light: return encoded(factor * value);
        case ImageScale::deviation: return encoded(factor * glm::sqrt(glm::max(value, 0.0f)));
        case ImageScale::direction:
            return value == glm::vec3(0.0f) ? value : finite(0.5f + 0.5f * value);
        default: return finite(value);
    }
}

}  // namespace

ImageScale scaleOf(const GpImageInfo& info) {
    for (const NamedScale& known : kScales) {
        if (known.name == info.name) {
            return known.scale;
        }
    }
    switch (info.format) {
        case GP_IMAGE_RGBA8: return ImageScale::display;
        case GP_IMAGE_R32UI: return ImageScale::number;
        default: return ImageScale::range;
    }
}

std::string explanationOf(ImageScale scale) {
    switch (scale) {
        case ImageScale::display: return "the picture, tone mapped";
        case ImageScale::light: return "times 2^exposure, clipped at 1";
        case ImageScale::deviation: return "its square root, times 2^exposure";
        case ImageScale::data: return "0..1 as it stands";
        case ImageScale::direction: return "-1..1 as black to full";
        case ImageScale::distance: return "near is bright, on a scale of powers";
        case ImageScale::number: return "a colour for each number";
        case ImageScale::heat: return "black is nothing, light yellow the most";
        case ImageScale::range: return "grey is 0, the largest value is full";
    }
    return "";
}

const std::vector<ImageName>& allImages() {
    static const std::vector<ImageName> all = [] {
        std::vector<ImageName> images;
        for (int i = 0; i < GP_IMAGE_COUNT; ++i) {
            ImageName image;
            image.kind = static_cast<GpFrameImage>(i);
            gpGetImageInfo(*image.kind, &image.info);
            images.push_back(image);
        }
        const char* name = nullptr;
        const char* meaning = nullptr;
        for (std::uint32_t i = 0; gpGetFrameLayerInfo(i, &name, &meaning) == GP_SUCCESS; ++i) {
            const auto isIt = [name](const ImageName& image) {
                return std::string_view(name) == image.info.name;
            };
            if (std::none_of(images.begin(), images.end(), isIt)) {
                images.push_back(
                    {{name, GP_IMAGE_RGBA32F, 4 * sizeof(float)}, std::nullopt, meaning});
            }
        }
        gpGetError(nullptr, nullptr);  // that there are no more is no failure
        return images;
    }();
    return all;
}

const ImageName* imageNamed(const std::string& name) {
    for (const ImageName& image : allImages()) {
        if (name == image.info.name) {
            return &image;
        }
    }
    return nullptr;
}

std::vector<std::string> imageNames() {
    std::vector<std::string> names;
    for (const ImageName& image : allImages()) {
        names.emplace_back(image.info.name);
    }
    return names;
}

bool needsHeatMaps(const std::string& name) {
    return name == "heat_rays" || name == "heat_time";
}

HeatScale heatScaleOf(const std::string& name, const float* rgba, std::size_t count) {
    std::vector<float> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        values[i] = heatOf(name, rgba[4 * i]);
    }
    const float high = values.empty() ? 0.0f : quantile(values, kHeatQuantile);
    const bool isTime = name == "heat_time";
    return {high, isVariance(name) ? "deviation of luminance" : isTime ? "microseconds" : "rays"};
}

glm::vec3 heatColor(float t) {
    return metrics::magmaSrgb(t);
}

bool hasImage(GpFrameMode mode, const ImageName& image) {
    return mode == GP_MODE_REALTIME ? image.kind != GP_IMAGE_VARIANCE : image.kind.has_value();
}

std::vector<std::uint8_t> visiblePixels(const GpImageInfo& info, const void* bytes,
                                        std::size_t count, float exposureEv) {
    Pixels out;
    out.reserve(4 * count);
    const ImageScale scale = scaleOf(info);
    if (info.format == GP_IMAGE_RGBA8) {
        const auto* rgba = static_cast<const std::uint8_t*>(bytes);
        out.assign(rgba, rgba + 4 * count);
        for (std::size_t i = 3; i < out.size(); i += 4) {
            out[i] = 255;
        }
    } else if (info.format == GP_IMAGE_R32UI) {
        const auto* numbers = static_cast<const std::uint32_t*>(bytes);
        std::for_each(numbers, numbers + count,
                      [&out](std::uint32_t number) { put(out, colorOfNumber(number)); });
    } else if (scale == ImageScale::distance && info.format == GP_IMAGE_R32F) {
        putDepths(out, static_cast<const float*>(bytes), count);
    } else if (scale == ImageScale::heat) {
        putHeat(out, info.name, static_cast<const float*>(bytes), count);
    } else if (scale == ImageScale::range || info.format == GP_IMAGE_R32F) {
        putRange(out, static_cast<const float*>(bytes), count,
                 info.format == GP_IMAGE_R32F ? 1 : 4);
    } else {
        const bool reflectance = std::string_view(info.name).ends_with("albedo");
        const float factor = reflectance ? 1.0f : std::exp2(exposureEv);
        const auto* rgba = static_cast<const float*>(bytes);
        for (std::size_t i = 0; i < count; ++i) {
            const glm::vec3 value(rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]);
            put(out, visible(scale, value, factor));
        }
    }
    return out;
}

}  // namespace gp::tool::view
