#include "api/texture_overrides.h"

#include <algorithm>
#include <filesystem>

#include "api/check.h"
#include "api/pixels.h"
#include "scene/mipmap.h"

namespace gp::api {

namespace {

namespace fs = std::filesystem;

// The file for a name with a postfix; "" where there is none.
std::string fileOf(const TextureOverrides& overrides, const std::string& name,
                   const std::string& postfix) {
    for (const char* ending : {".png", ".jpg", ".jpeg", ".exr", ".hdr"}) {
        const std::string path = overrides.folder + '/' + name + postfix + ending;
        std::error_code ignored;
        if (fs::is_regular_file(path, ignored)) return path;
    }
    return "";
}

// Names come with the content of an application: they must not lead out of the folder.
bool staysInside(const std::string& name) {
    const fs::path path(name);
    return path.is_relative() && std::none_of(path.begin(), path.end(),
                                              [](const fs::path& part) { return part == ".."; });
}

// Read as the texture is that it stands for.
TextureDesc descFor(const Texture& base, const std::string& path, ColorSpace colorSpace,
                    Image&& image) {
    TextureDesc desc;
    desc.name = path;
    desc.image = std::move(image);
    desc.colorSpace = colorSpace;
    desc.wrapU = base.wrapU, desc.wrapV = base.wrapV;
    desc.magFilter = base.magFilter, desc.minFilter = base.minFilter;
    desc.mipmapped = base.mipmapped;
    return desc;
}

float channel(const Image& image, size_t texel, size_t c) {
    return image.format == PixelFormat::rgba8 ? float(image.bytes()[texel * 4 + c]) / 255
                                              : image.floats()[texel * 4 + c];
}

// As glTF packs them: G roughness, B metallic.
Image metallicRoughnessOf(const Image& rme) {
    Image image = rme;
    const size_t bytes = bytesPerPixel(rme.format) / 4;  // of a channel
    for (size_t i = 0; i < rme.pixels.size(); i += 4 * bytes)
        std::copy_n(rme.pixels.begin() + ptrdiff_t(i), 2 * bytes,
                    image.pixels.begin() + ptrdiff_t(i + bytes));
    return image;
}

// The colour of `base` at a point of the unit square, on the level that is no wider than `width`.
glm::vec3 colorAt(const Texture& base, float u, float v, uint32_t width) {
    const MipLevel* level = &base.levels[0];
    while (level->width > width && level != &base.levels.back()) ++level;
    const auto at = [](float x, uint32_t n) { return std::min(uint32_t(x * float(n)), n - 1); };
    const size_t texel = size_t(at(v, level->height)) * level->width + at(u, level->width);
    const std::byte* p = base.pixels.data() + level->offset + texel * bytesPerPixel(base.format);
    glm::vec3 color;
    for (int c = 0; c < 3; ++c) {
        color[c] = base.format == PixelFormat::rgba8
            ? float(p[c]) / 255 : reinterpret_cast<const float*>(p)[c];
        if (base.colorSpace == ColorSpace::srgb) color[c] = linearFromSrgb(color[c]);
    }
    return color;
}

// Colour times the third channel; empty where nothing glows. Of bytes it is sRGB again.
Image emissionOf(const Image& rme, const Texture& base) {
    Image image = rme;
    bool glows = false;
    for (size_t i = 0; i < size_t(rme.width) * rme.height; ++i) {
        const float u = (float(i % rme.width) + 0.5f) / float(rme.width);
        const float v = (float(i / rme.width) + 0.5f) / float(rme.height);
        const glm::vec3 e = colorAt(base, u, v, rme.width) * std::max(channel(rme, i, 2), 0.0f);
        glows |= e != glm::vec3(0);
        for (int c = 0; c < 3; ++c) {
            const size_t at = i * 4 + size_t(c);
            if (image.format == PixelFormat::rgba8)
                image.bytes()[at] =
                    uint8_t(srgbFromLinear(std::clamp(e[c], 0.0f, 1.0f)) * 255 + 0.5f);
            else
                image.floats()[at] = std::max(e[c], 0.0f);
        }
    }
    return glows ? image : Image{};
}

TextureOverrides overridesFrom(const GpTextureOverrides& o) {
    checkPointer(o.folder, "folder");
    TextureOverrides result;
    result.folder = o.folder;
    result.albedo = o.albedoPostfix ? o.albedoPostfix : "_albedo";
    result.rme = o.rmePostfix ? o.rmePostfix : "_rme";
    result.normal = o.normalPostfix ? o.normalPostfix : "_n";
    if (result.albedo == result.rme || result.albedo == result.normal ||
        result.rme == result.normal)
        fail(GP_ERROR_INVALID_ARGUMENT, "two of the postfixes are the same: \"{}\", \"{}\", \"{}\"",
             result.albedo, result.rme, result.normal);
    std::error_code ignored;
    if (!fs::is_directory(result.folder, ignored))
        fail(GP_ERROR_FILE_NOT_FOUND, "{}: there is no such folder", result.folder);
    return result;
}

}  // namespace

void makeWithOverrides(TextureObject& object, TextureDesc&& desc) {
    const auto& overrides = object.device->overrides;
    const std::string name = desc.name;
    if (!overrides || name.empty() || !staysInside(name)) {
        object.texture = makeTexture(std::move(desc));
        return;
    }
    if (const std::string path = fileOf(*overrides, name, overrides->albedo); !path.empty()) {
        ImageFile file = readImageFile(path);
        desc.colorSpace = file.displayReferred ? ColorSpace::srgb : ColorSpace::linear;
        desc.image = std::move(file.image);
        desc.name = object.replacedBy = path;
    }
    object.texture = makeTexture(std::move(desc));
    const Texture& base = *object.texture;
    if (const std::string path = fileOf(*overrides, name, overrides->rme); !path.empty()) {
        const Image rme = readImageFile(path).image;
        object.metallicRoughness =
            makeTexture(descFor(base, path, ColorSpace::linear, metallicRoughnessOf(rme)));
        Image emission = emissionOf(rme, base);
        const bool bytes = emission.format == PixelFormat::rgba8;
        if (!emission.pixels.empty())
            object.emission = makeTexture(descFor(
                base, path, bytes ? ColorSpace::srgb : ColorSpace::linear, std::move(emission)));
    }
    if (const std::string path = fileOf(*overrides, name, overrides->normal); !path.empty())
        object.normal = makeTexture(
            descFor(base, path, ColorSpace::linear, readImageFile(path).image));
}

}  // namespace gp::api

using namespace gp::api;

extern "C" GpError gpSetTextureOverrides(GpDevice device, const GpTextureOverrides* overrides) {
    return enter("gpSetTextureOverrides", "device", device, [&](DeviceObject& d) {
        if (overrides) d.overrides = overridesFrom(*overrides);
        else d.overrides.reset();
    });
}
