#include "view/view_choices.h"

#include "sea/sea_words.h"
#include "view/fly_camera.h"
#include "view/image_view.h"

namespace gp::tool::view {

bool eyeDecides(const ViewChoices& choices) {
    return choices.live == LiveMode::realtime && choices.realtime.eye.seconds > 0;
}

// In the other modes the reference is always on, and waits for a pause.
bool seaMoves(const ViewChoices& choices) {
    const bool stands = choices.reference && choices.live == LiveMode::realtime;
    return choices.sea.isThere && !choices.sea.isPaused && choices.sea.speed > 0 && !stands;
}

bool sameWaves(const SeaChoices& a, const SeaChoices& b) {
    return a.isThere == b.isThere &&
           (!a.isThere || (a.seconds == b.seconds && sameSea(a.desc, b.desc)));
}

bool sameView(const ViewChoices& a, const ViewChoices& b) {
    return sameCamera(a.camera, b.camera) && a.size == b.size && a.live == b.live &&
           a.realtime == b.realtime && a.surroundings == b.surroundings && a.lamp == b.lamp &&
           a.lights == b.lights && sameWaves(a.sea, b.sea) && a.beside == b.beside &&
           needsHeatMaps(a.image) == needsHeatMaps(b.image);
}

bool sameChoices(const ViewChoices& a, const ViewChoices& b) {
    return sameView(a, b) && a.liveSeconds == b.liveSeconds && a.reference == b.reference &&
           a.mostSamples == b.mostSamples && a.image == b.image && a.divider == b.divider &&
           a.autoExposure == b.autoExposure && a.exposureEv == b.exposureEv &&
           a.tonemap == b.tonemap && a.sea.speed == b.sea.speed &&
           a.sea.isPaused == b.sea.isPaused;
}

}  // namespace gp::tool::view
