#include "api/check.h"

namespace gp::api {

void checkPath(const char* path) {
    checkPointer(path, "path");
    if (*path == 0) fail(GP_ERROR_INVALID_ARGUMENT, "path is empty");
}

void checkFinite(double value, const std::string& field) {
    if (!std::isfinite(value)) fail(GP_ERROR_NOT_FINITE, "{} is {}", field, value);
}

void checkFinite(const float* values, size_t count, const std::string& field) {
    for (size_t i = 0; i < count; ++i)
        if (!std::isfinite(values[i]))
            fail(GP_ERROR_NOT_FINITE, "{}[{}] is {}", field, i, values[i]);
}

void checkRange(double value, double lo, double hi, const std::string& field) {
    checkFinite(value, field);
    if (value < lo || value > hi)
        fail(GP_ERROR_OUT_OF_RANGE, "{} is {:g}, outside of {:g}..{:g}", field, value, lo, hi);
}

void checkRange(const float* values, size_t count, double lo, double hi, const std::string& field) {
    for (size_t i = 0; i < count; ++i)
        if (!(values[i] >= lo && values[i] <= hi))  // NaN comes here too
            checkRange(values[i], lo, hi, fmt::format("{}[{}]", field, i));
}

void checkNotNegative(double value, const std::string& field) {
    checkFinite(value, field);
    if (value < 0) fail(GP_ERROR_OUT_OF_RANGE, "{} is {:g}, below 0", field, value);
}

void checkNotNegative(const float* values, size_t count, const std::string& field) {
    for (size_t i = 0; i < count; ++i)
        if (!(values[i] >= 0 && std::isfinite(values[i])))
            checkNotNegative(values[i], fmt::format("{}[{}]", field, i));
}

void checkImageSize(uint32_t width, uint32_t height, uint32_t limit, uint64_t maxPixels) {
    if (width == 0) fail(GP_ERROR_INVALID_ARGUMENT, "width is 0");
    if (height == 0) fail(GP_ERROR_INVALID_ARGUMENT, "height is 0");
    if (width > limit) fail(GP_ERROR_TOO_LARGE, "width is {}, more than {}", width, limit);
    if (height > limit) fail(GP_ERROR_TOO_LARGE, "height is {}, more than {}", height, limit);
    if (uint64_t(width) * height > maxPixels)
        fail(GP_ERROR_TOO_LARGE, "{} x {} is more than {} pixels", width, height, maxPixels);
}

void giveText(const std::string& result, char* text, size_t size, size_t* needed) {
    if (size != 0) checkPointer(text, "text");
    if (needed) *needed = result.size() + 1;
    if (size == 0) return;
    if (size < result.size() + 1)
        fail(GP_ERROR_INVALID_OPERATION, "size is {}, but the text needs {} bytes", size,
             result.size() + 1);
    std::memcpy(text, result.c_str(), result.size() + 1);
}

}  // namespace gp::api
