// Checks of what comes from outside. Each throws an ApiError that names the field.
#pragma once

#include <cmath>
#include <cstring>
#include <string>

#include <glm/glm.hpp>

#include "api/boundary.h"

namespace gp::api {

inline void checkPointer(const void* pointer, const char* field) {
    if (!pointer) fail(GP_ERROR_INVALID_ARGUMENT, "{} is NULL", field);
}

void checkPath(const char* path);  // not NULL, not empty

void checkFinite(double value, const std::string& field);
void checkFinite(const float* values, size_t count, const std::string& field);  // names the index
void checkRange(double value, double lo, double hi, const std::string& field);  // and finite
void checkRange(const float* values, size_t count, double lo, double hi, const std::string& field);
void checkNotNegative(double value, const std::string& field);                  // and finite
void checkNotNegative(const float* values, size_t count, const std::string& field);

// 1..limit on each side, and at most `maxPixels` together.
void checkImageSize(uint32_t width, uint32_t height, uint32_t limit, uint64_t maxPixels);

// By reference and through memcpy: a C program may have put any number there, which a C++ enum
// must not hold.
template <class E>
uint32_t checkEnum(const E& value, uint32_t count, const char* field) {
    static_assert(sizeof(E) == sizeof(uint32_t));
    uint32_t number;
    std::memcpy(&number, &value, sizeof number);
    if (number >= count)
        fail(GP_ERROR_INVALID_ARGUMENT, "{} is {}, which is not one of its {} values", field,
             number, count);
    return number;
}

// A text for the caller's buffer, by the rules of gpDescribeScene.
void giveText(const std::string& result, char* text, size_t size, size_t* needed);

inline bool allZero(const float* values, size_t count) {
    for (size_t i = 0; i < count; ++i)
        if (values[i] != 0) return false;
    return true;
}

inline std::string nameOr(const char* name) { return name ? name : ""; }
inline glm::vec3 vec3From(const float* v) { return {v[0], v[1], v[2]}; }

}  // namespace gp::api
