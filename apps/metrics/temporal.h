// What can be wrong with a moving picture beside its frames: errors that flicker, and light that
// stays when its lamp has gone out.
#pragma once

#include <optional>
#include <span>

#include "metrics/picture.h"

namespace gp::metrics {

using Offsets = Grid<glm::vec2>;

// Where the things of a frame were in the frame before.
struct Motion {
    Offsets toPrevious;   // pixels, to the right and down
    Plane previousDepth;  // metres that the points had then
    Plane slope;          // metres by which depth changes to the next pixel
};

// The errors of one picture against two references whose noise is independent. The product of both
// is on average the square of the error against what the references would be without noise.
struct ErrorPair {
    Plane a, b;
};

// The mean square, over all pixels, of error(p) - previousError(where p was), without the noise of
// the references: errors that move along with the surfaces do not flicker, however large they are;
// white noise of deviation s of the picture, new in each frame, flickers by 2 s^2 (less where
// motion falls between pixels, since the previous error is interpolated). Pixels that were outside
// of the picture do not count, nor those that were hidden: previousSeen, the depths of the frame
// before, has others there. Without motion (null) everything is taken to have been in its place.
// 0 where no pixel counts; may be negative where there is little but noise of the references.
double squaredFlicker(const ErrorPair& error, const ErrorPair& previousError,
                      const Motion* motion = nullptr, const Plane* previousSeen = nullptr);

// How much of a light that has gone out a picture still shows: error * step / step^2, summed over
// all pixels, where `error` is the picture minus what it should be, and `step` what it should be
// with the light minus what it should be. 1: all of it, 0: nothing; noise that knows nothing of the
// light averages out, also that of the references, since errors are multiplied with the steps of
// the other reference. None where the light does not show at all.
std::optional<double> afterglow(const ErrorPair& error, const ErrorPair& step);

// The number of the first of these frames from which on the afterglow, whatever its sign, stays
// below `limit`; 0: at once. None where the last one is still above.
std::optional<std::size_t> lagFrames(std::span<const double> afterglow, double limit);

}  // namespace gp::metrics
