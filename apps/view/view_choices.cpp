#include "view/view_choices.h"

#include "view/fly_camera.h"
#include "view/image_view.h"

namespace gp::tool::view {

bool eyeDecides(const ViewChoices& choices) {
    return choices.live == LiveMode::realtime && choices.realtime.eye.seconds > 0;
}

bool sameView(const ViewChoices& a, const ViewChoices& b) {
    return sameCamera(a.camera, b.camera) && a.size == b.size && a.live == b.live &&
           a.realtime == b.realtime && a.surroundings == b.surroundings && a.lamp == b.lamp &&
           a.lights == b.lights && a.beside == b.beside &&
           needsHeatMaps(a.image) == needsHeatMaps(b.image);
}

bool sameChoices(const ViewChoices& a, const ViewChoices& b) {
    return sameView(a, b) && a.liveSeconds == b.liveSeconds && a.reference == b.reference &&
           a.mostSamples == b.mostSamples && a.image == b.image && a.divider == b.divider &&
           a.autoExposure == b.autoExposure && a.exposureEv == b.exposureEv &&
           a.tonemap == b.tonemap;
}

}  // namespace gp::tool::view
