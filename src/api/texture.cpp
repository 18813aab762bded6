#include "api/check.h"
#include "api/pixels.h"
#include "api/scenes.h"
#include "api/texture_overrides.h"

namespace gp::api {

namespace {

constexpr uint32_t textureLimit = 32768;
constexpr uint64_t pixelLimit = uint64_t(1) << 28;

static_assert(GP_WRAP_CLAMP == int(Wrap::clampToEdge) &&
              GP_WRAP_MIRROR == int(Wrap::mirroredRepeat));
static_assert(GP_FILTER_NEAREST == int(Filter::nearest));

// How the texture is read: what both kinds of texture take from their descriptor.
TextureDesc samplingFrom(const GpTextureDesc& desc) {
    TextureDesc t;
    t.name = nameOr(desc.name);
    const bool linear = checkEnum(desc.colorSpace, 2, "colorSpace") == GP_COLOR_LINEAR;
    t.colorSpace = linear ? ColorSpace::linear : ColorSpace::srgb;
    t.wrapU = Wrap(checkEnum(desc.wrapU, 3, "wrapU"));
    t.wrapV = Wrap(checkEnum(desc.wrapV, 3, "wrapV"));
    t.magFilter = Filter(checkEnum(desc.magFilter, 2, "magFilter"));
    t.minFilter = Filter(checkEnum(desc.minFilter, 2, "minFilter"));
    t.mipmapped = !desc.noMipmaps;
    return t;
}

// Bytes from row to row.
template <class Desc>
size_t strideOf(const Desc& desc, PixelFormat format) {
    const size_t packed = size_t(desc.width) * bytesPerPixel(format);
    const size_t stride = desc.rowBytes ? desc.rowBytes : packed;
    if (stride < packed)
        fail(GP_ERROR_OUT_OF_RANGE, "rowBytes is {}, but a row has {} bytes", stride, packed);
    if (stride > size_t(PTRDIFF_MAX) / desc.height)
        fail(GP_ERROR_TOO_LARGE, "{} rows of {} bytes are more than memory holds", desc.height,
             stride);
    return stride;
}

// Rows may stand apart; what is made is tightly packed.
Image imageFrom(const GpTextureDesc& desc) {
    checkImageSize(desc.width, desc.height, textureLimit, pixelLimit);
    checkPointer(desc.pixels, "pixels");
    Image image;
    image.width = desc.width;
    image.height = desc.height;
    image.format = PixelFormat(checkEnum(desc.format, 2, "format"));
    const size_t packed = size_t(desc.width) * bytesPerPixel(image.format);
    const size_t stride = strideOf(desc, image.format);
    image.pixels.resize(packed * desc.height);
    for (size_t y = 0; y < desc.height; ++y)
        std::memcpy(image.pixels.data() + y * packed,
                    static_cast<const std::byte*>(desc.pixels) + y * stride, packed);
    if (image.format == PixelFormat::rgba32f)
        checkFinite(image.floats(), size_t(desc.width) * desc.height * 4, "pixels");
    return image;
}

GpTexture publishTexture(DeviceObject& device, TextureDesc&& desc) {
    auto object = std::make_shared<TextureObject>(device);
    makeWithOverrides(*object, std::move(desc));
    return publish<GpTexture>(object);
}

// `length` texels from `first` on, of `size` along one axis.
void checkSpan(uint32_t first, uint32_t length, uint32_t size, const char* firstName,
               const char* lengthName) {
    if (length == 0) fail(GP_ERROR_INVALID_ARGUMENT, "{} is 0", lengthName);
    if (first >= size || length > size - first)
        fail(GP_ERROR_OUT_OF_RANGE, "{} {} and {} {} end past the texture's {}", firstName, first,
             lengthName, length, size);
}

void updateFrom(const GpTextureUpdate& update, TextureObject& object) {
    Texture& texture = *object.texture;
    if (!object.replacedBy.empty())
        fail(GP_ERROR_INVALID_OPERATION, "{} stands in the texture's place", object.replacedBy);
    const MipLevel& whole = texture.levels[0];
    checkSpan(update.x, update.width, whole.width, "x", "width");
    checkSpan(update.y, update.height, whole.height, "y", "height");
    const auto format = PixelFormat(checkEnum(update.format, 2, "format"));
    if (format != texture.format)
        fail(GP_ERROR_INVALID_ARGUMENT, "format is not that of the texture, {}",
             texture.format == PixelFormat::rgba8 ? "GP_FORMAT_RGBA8" : "GP_FORMAT_RGBA32F");
    checkPointer(update.pixels, "pixels");
    const size_t stride = strideOf(update, format);
    const auto* rows = static_cast<const std::byte*>(update.pixels);
    if (format == PixelFormat::rgba32f) {
        std::vector<float> row(size_t(update.width) * 4);  // strides may leave floats anywhere
        for (size_t y = 0; y < update.height; ++y) {
            std::memcpy(row.data(), rows + y * stride, row.size() * sizeof(float));
            checkFinite(row.data(), row.size(), fmt::format("row {} of pixels", y));
        }
    }
    textureChanged(*object.device, texture);  // first, because it may run out of memory
    updateTexture(texture, {update.x, update.y, update.width, update.height}, rows, stride);
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpTexture gpNewTexture(GpDevice device, const GpTextureDesc* desc) {
    return enter("gpNewTexture", "device", device, [&](DeviceObject& d) {
        checkPointer(desc, "desc");
        gp::TextureDesc texture = samplingFrom(*desc);
        texture.image = imageFrom(*desc);
        if (texture.image.format == gp::PixelFormat::rgba32f)
            texture.colorSpace = gp::ColorSpace::linear;
        return publishTexture(d, std::move(texture));
    });
}

GpTexture gpNewTextureFromFile(GpDevice device, const char* path, const GpTextureDesc* desc) {
    return enter("gpNewTextureFromFile", "device", device, [&](DeviceObject& d) {
        checkPath(path);
        gp::TextureDesc texture = samplingFrom(desc ? *desc : GpTextureDesc{});
        ImageFile file = readImageFile(path);
        texture.image = std::move(file.image);
        if (!file.displayReferred) texture.colorSpace = gp::ColorSpace::linear;
        if (texture.name.empty()) texture.name = path;
        return publishTexture(d, std::move(texture));
    });
}

GpError gpUpdateTexture(GpTexture texture, const GpTextureUpdate* update) {
    return enter("gpUpdateTexture", "texture", texture, [&](TextureObject& object) {
        checkPointer(update, "update");
        updateFrom(*update, object);
    });
}

GpError gpReleaseTexture(GpTexture texture) {
    return enter("gpReleaseTexture", "texture", texture,
                 [&](TextureObject&) { handles().remove(bitsOf(texture)); });
}

}  // extern "C"
