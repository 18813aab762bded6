// Scenes as the other nouns need them.
#pragma once

#include <utility>

#include "api/objects.h"

namespace gp::api {

// Counts the instances that a dynamic mesh has in a scene. Throws only where `change` is positive.
void countUse(SceneObject& scene, const Mesh* mesh, int change);

// The vertices of a dynamic mesh are new: every scene of the device that shows it has changed.
void meshChanged(DeviceObject& device, const Mesh& mesh);

// The same for what all kinds of things share: every scene of the device with such an instance has
// changed. Costs a look at each instance.
void texCoordsChanged(DeviceObject& device, const Mesh& mesh);
void materialChanged(DeviceObject& device, const Material& material);
void textureChanged(DeviceObject& device, const Texture& texture);

// Takes back a step of a change that a later step could not finish, unless told to keep it.
template <class F>
class Undo {
public:
    explicit Undo(F undo) : undo_(std::move(undo)) {}
    ~Undo() {
        if (armed_) undo_();
    }
    Undo(const Undo&) = delete;
    Undo& operator=(const Undo&) = delete;
    void keep() { armed_ = false; }

private:
    F undo_;
    bool armed_ = true;
};

// Fills what a descriptor leaves open; throws ApiError.
Camera cameraFrom(const GpCameraDesc& desc);
GpCameraDesc descFrom(const Camera& camera);

}  // namespace gp::api
