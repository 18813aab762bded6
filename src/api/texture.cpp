#include "api/check.h"
#include "api/pixels.h"

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

// Rows may stand apart; what is made is tightly packed.
Image imageFrom(const GpTextureDesc& desc) {
    checkImageSize(desc.width, desc.height, textureLimit, pixelLimit);
    checkPointer(desc.pixels, "pixels");
    Image image;
    image.width = desc.width;
    image.height = desc.height;
    image.format = PixelFormat(checkEnum(desc.format, 2, "format"));
    const size_t packed = size_t(desc.width) * bytesPerPixel(image.format);
    const size_t stride = desc.rowBytes ? desc.rowBytes : packed;
    if (stride < packed)
        fail(GP_ERROR_OUT_OF_RANGE, "rowBytes is {}, but a row has {} bytes", stride, packed);
    if (stride > size_t(PTRDIFF_MAX) / desc.height)
        fail(GP_ERROR_TOO_LARGE, "{} rows of {} bytes are more than memory holds", desc.height,
             stride);
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
    object->texture = makeTexture(std::move(desc));
    return publish<GpTexture>(object);
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

GpError gpReleaseTexture(GpTexture texture) {
    return enter("gpReleaseTexture", "texture", texture,
                 [&](TextureObject&) { handles().remove(bitsOf(texture)); });
}

}  // extern "C"
