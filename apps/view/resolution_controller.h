// How many pixels a frame may have to be there in time.
#pragma once

#include <array>
#include <cstdint>

namespace gp::tool::view {

struct RenderSize {
    std::uint32_t width = 0, height = 0;
    friend bool operator==(const RenderSize&, const RenderSize&) = default;
};

// Sizes go in steps of 2^(1/4) of each side, because every change costs a frame its history. Two
// slow frames in a row, never one, make frames smaller; eight quick ones make them a step larger.
class ResolutionController {
public:
    static constexpr int kSteps = 16;  // down to a sixteenth of each side

    void setTarget(double seconds) { m_target = seconds; }
    double target() const { return m_target; }
    // How long the frame of the present scale took.
    void record(double seconds);
    // Of each side, 1 at most.
    double scale() const { return scaleOf(m_step); }
    RenderSize sizeFor(RenderSize full) const;

private:
    static constexpr int kHistory = 8;
    static double scaleOf(int step);
    // What a frame of the given step would take if time goes with the number of pixels.
    double predicted(int step, double cost) const { return cost * scaleOf(step) * scaleOf(step); }

    double m_target = 1.0 / 30.0;
    int m_step = 8;                        // a quarter of each side: quick on any machine
    std::array<double, kHistory> m_costs{};  // seconds a full-size frame, newest first
    int m_known = 0;
};

}  // namespace gp::tool::view
