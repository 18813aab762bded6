// A camera that flies: where it is, where it looks, how fast it goes.
#pragma once

#include <glitterpath/glitterpath.h>

#include <glm/glm.hpp>

namespace gp::tool::view {

// Angles in radians. Heading 0 looks along -Z, a quarter turn more along +X; pitch is up from the
// horizon. What a file's camera brought stays as it was until somebody changes it, roll included.
class FlyCamera {
public:
    FlyCamera() = default;
    // reach: metres to what is seen; the speed is made from it, so that one gets there in some
    // seconds whatever the scale of the scene.
    FlyCamera(const GpCameraDesc& start, float reach);

    // rightUpForward: each -1..1, as keys are held. Up is the world's, so that flying keeps level.
    void move(const glm::vec3& rightUpForward, float seconds, bool fast);
    // A drag of the mouse by so many pixels of a picture of this height: what lies a picture's
    // height away is turned to by dragging that far.
    void turn(float pixelsRight, float pixelsDown, float pictureHeight);
    void changeSpeed(float wheelSteps);
    void levelOut() { m_roll = 0; }

    // For panels, which change them in place.
    GpCameraDesc& lens() { return m_lens; }        // kind, angle of view, aperture, focus
    glm::vec3& position() { return m_position; }
    float& heading() { return m_heading; }
    float& pitch() { return m_pitch; }
    float& speed() { return m_speed; }             // metres a second
    float speed() const { return m_speed; }

    GpCameraDesc desc() const;

private:
    glm::vec3 forward() const;
    glm::vec3 right() const;  // level, whatever the roll

    GpCameraDesc m_lens{};
    glm::vec3 m_position{0.0f};
    float m_heading = 0, m_pitch = 0, m_roll = 0;
    float m_targetDistance = 1, m_speed = 1;
};

// Whether two cameras show the same picture.
bool sameCamera(const GpCameraDesc& a, const GpCameraDesc& b);

}  // namespace gp::tool::view
