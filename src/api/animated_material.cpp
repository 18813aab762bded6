// Materials that show one of several others.
#include "api/check.h"
#include "api/scenes.h"

namespace gp::api {

namespace {

constexpr uint32_t frameLimit = 65536;

std::shared_ptr<Material> animatedFrom(DeviceObject& device, const GpMaterial* frames,
                                       uint32_t count) {
    if (count == 0) fail(GP_ERROR_INVALID_ARGUMENT, "count is 0");
    if (count > frameLimit)
        fail(GP_ERROR_TOO_LARGE, "count is {}, more than {}", count, frameLimit);
    checkPointer(frames, "frames");
    auto animated = std::make_shared<Material>();
    for (uint32_t i = 0; i < count; ++i) {
        auto frame = resolve(device, frames[i], fmt::format("frames[{}]", i))->material;
        if (!frame->frames.empty())
            fail(GP_ERROR_INVALID_ARGUMENT, "frames[{}] is animated itself", i);
        animated->frames.push_back(std::move(frame));
    }
    return animated;
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpMaterial gpNewAnimatedMaterial(GpDevice device, const GpMaterial* frames, uint32_t count) {
    return enter("gpNewAnimatedMaterial", "device", device, [&](DeviceObject& d) {
        auto object = std::make_shared<MaterialObject>(d);
        object->animated = animatedFrom(d, frames, count);
        object->material = object->animated;
        return publish<GpMaterial>(object);
    });
}

GpError gpSetMaterialFrame(GpMaterial material, uint32_t frame) {
    return enter("gpSetMaterialFrame", "material", material, [&](MaterialObject& object) {
        if (!object.animated)
            fail(GP_ERROR_INVALID_OPERATION, "the material is not of gpNewAnimatedMaterial");
        gp::Material& animated = *object.animated;
        if (frame >= animated.frames.size())
            fail(GP_ERROR_OUT_OF_RANGE, "frame is {}, but the material has {}", frame,
                 animated.frames.size());
        if (frame == animated.frame) return;
        animated.frame = frame;
        materialChanged(*object.device, animated);
    });
}

}  // extern "C"
