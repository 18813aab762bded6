// How many pixels a frame may have to be there in time.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace gp::tool::view {

struct RenderSize {
    std::uint32_t width = 0, height = 0;
    friend bool operator==(const RenderSize&, const RenderSize&) = default;
};

// Rays go in steps of 2^(1/4) along each side. Two slow frames in a row, never one, make them
// fewer; eight quick ones make them more by a step. Where the mode can scale pictures up over time
// (GpRealtimeOptions::renderScale) the picture keeps its size until half of the rays along each
// side are gone, since another size costs a frame its history.
class ResolutionController {
public:
    static constexpr int kSteps = 16;  // down to a sixteenth of each side

    void setTarget(double seconds) { m_target = seconds; }
    double target() const { return m_target; }
    // How long the frame of the present scale took.
    void record(double seconds);
    // The most that renderScale may be, 0.5..1; nothing: the mode has none.
    void setMostRenderScale(std::optional<double> most) { m_mostRenderScale = most; }
    // Rays along each side for a pixel of the full picture, 1 at most.
    double scale() const { return scaleOf(m_step); }
    // What makes that up: rays for a pixel of the frame, and the frame's part of each side.
    double renderScale() const;
    double sizeScale() const;
    RenderSize sizeFor(RenderSize full) const;

private:
    static constexpr int kHistory = 8;
    double scaleOf(int step) const;
    // What a frame of the given step would take if time goes with the number of pixels.
    double predicted(int step, double cost) const { return cost * scaleOf(step) * scaleOf(step); }

    double m_target = 1.0 / 30.0;
    std::optional<double> m_mostRenderScale;
    int m_step = 8;                        // a quarter of each side: quick on any machine
    std::array<double, kHistory> m_costs{};  // seconds a full-size frame, newest first
    int m_known = 0;
};

}  // namespace gp::tool::view
