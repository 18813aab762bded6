#include "scene/measured_brdf.h"

#include <array>
#include <vector>

#include <tbb/parallel_for.h>

#include "merl_format.h"
#include "shading/shading.h"

namespace gp {
namespace {

using namespace shading;

static_assert(merl::sizes == std::array<int32_t, 3>{MERL_THETA_H, MERL_THETA_D, MERL_PHI_D});
static_assert(merl::cellCount == MERL_CELLS);

constexpr int views = HALF_DENSITY_VIEWS;
constexpr int rows = HALF_DENSITY_ROWS;
constexpr int azimuths = HALF_DENSITY_AZIMUTHS;
static_assert(HALF_DENSITY_INTEGRALS == rows * azimuths);
static_assert(HALF_DENSITY_SHARES == HALF_DENSITY_INTEGRALS + rows);
static_assert(HALF_DENSITY_ALBEDO == HALF_DENSITY_SHARES + rows);
static_assert(HALF_DENSITY_VIEW_WORDS == HALF_DENSITY_ALBEDO + 3);
static_assert(MEASURED_WORDS == 3 * MERL_CELLS + views * HALF_DENSITY_VIEW_WORDS);

// Points along each side of a cell between nodes: the data's cells are 1.4 times as many as the
// rows, so that none is missed.
constexpr int points = 3;
// The last view cannot be the horizon, where no light goes either way.
constexpr double lastView = 88.0 / 180.0 * M_PI;

glm::uvec2 addressOf(const LargeVector<float>& words) {
    const auto address = uint64_t(reinterpret_cast<uintptr_t>(words.data()));
    return {uint32_t(address), uint32_t(address >> 32u)};
}

// The densities of one view.
class ViewMaker {
public:
    ViewMaker(LargeVector<float>& words, int view) : table_(addressOf(words)) {
        const double theta = std::min(0.5 * M_PI * view / (views - 1), lastView);
        wo_ = vec3(dvec3(std::sin(theta), 0.0, std::cos(theta)));
        out_ = words.data() + half_density_base(view);
    }

    void make() {
        for (int row = 0; row + 1 < rows; ++row) {
            for (int azimuth = 0; azimuth + 1 < azimuths; ++azimuth) measureCell(row, azimuth);
        }
        for (int row = 0; row < rows; ++row) {
            for (int azimuth = 0; azimuth < azimuths; ++azimuth) makeNode(row, azimuth);
        }
        normalise();
        for (int c = 0; c < 3; ++c) out_[HALF_DENSITY_ALBEDO + uint(c)] = float(albedo_[c]);
    }

private:
    // f cos_i by solid angle of the half vector.
    dvec3 light(double height, double phi) const {
        const double sine = std::sqrt(height * (2.0 - height));
        const vec3 wm(dvec3(sine * std::cos(phi), sine * std::sin(phi), 1.0 - height));
        const float cosH = dot(wo_, wm);
        const vec3 wi = wm * (2.0f * cosH) - wo_;
        if (cosH <= 0.0f || wi.z <= 0.0f) return dvec3(0.0);
        return dvec3(merl_trilinear(table_, wo_, wi)) * double(4.0f * cosH * wi.z);
    }

    // The mean of the light between two rows and two azimuths, on both sides of the viewer.
    void measureCell(int row, int azimuth) {
        constexpr double stepT = 1.0 / ((rows - 1) * points);
        constexpr double stepPhi = M_PI / ((azimuths - 1) * points);
        double mean = 0.0;
        for (int i = 0; i < points; ++i) {
            const double low = std::pow((row * points + i) * stepT, 4.0);
            const double high = std::pow((row * points + i + 1) * stepT, 4.0);
            const double height = std::pow((row * points + i + 0.5) * stepT, 4.0);
            for (int j = 0; j < points; ++j) {
                const double phi = (azimuth * points + j + 0.5) * stepPhi;
                const dvec3 both = light(height, phi) + light(height, -phi);
                albedo_ += both * ((high - low) * stepPhi);
                mean += double(luminance(vec3(both))) / (2.0 * points * points);
            }
        }
        means_[size_t(row * (azimuths - 1) + azimuth)] = mean;
    }

    // From the cells around a node: it is 0 only where all of them are.
    void makeNode(int row, int azimuth) {
        double sum = 0.0;
        int count = 0;
        for (int r = std::max(row - 1, 0); r <= std::min(row, rows - 2); ++r) {
            for (int a = std::max(azimuth - 1, 0); a <= std::min(azimuth, azimuths - 2); ++a) {
                sum += means_[size_t(r * (azimuths - 1) + a)];
                ++count;
            }
        }
        nodes_[size_t(row * azimuths + azimuth)] = sum / count;
    }

    double rowIntegral(int row) const {
        const double* g = &nodes_[size_t(row * azimuths)];
        double sum = -0.5 * (g[0] + g[azimuths - 1]);
        for (int a = 0; a < azimuths; ++a) sum += g[a];
        return 2.0 * M_PI / (azimuths - 1) * sum;
    }

    void normalise() {
        std::array<double, rows> share{};
        for (int row = 1; row < rows; ++row) share[size_t(row)] = shareUpTo(row, share);
        if (!(share.back() > 0.0)) {  // a black view: any density will do
            nodes_.fill(1.0);
            for (int row = 1; row < rows; ++row) share[size_t(row)] = shareUpTo(row, share);
        }
        const double all = share.back();
        for (size_t i = 0; i < nodes_.size(); ++i) out_[i] = float(nodes_[i] / all);
        for (int row = 0; row < rows; ++row) {
            out_[HALF_DENSITY_INTEGRALS + uint(row)] = float(rowIntegral(row) / all);
            out_[HALF_DENSITY_SHARES + uint(row)] = float(share[size_t(row)] / all);
        }
    }

    double shareUpTo(int row, const std::array<double, rows>& share) const {
        const double step = std::pow(double(row) / (rows - 1), 4.0)
                          - std::pow(double(row - 1) / (rows - 1), 4.0);
        return share[size_t(row - 1)] + 0.5 * step * (rowIntegral(row - 1) + rowIntegral(row));
    }

    glm::uvec2 table_;
    vec3 wo_;
    float* out_;
    std::array<double, (rows - 1) * (azimuths - 1)> means_{};
    std::array<double, rows * azimuths> nodes_{};
    dvec3 albedo_{0.0};
};

}  // namespace

glm::uvec2 MeasuredBrdf::address() const { return addressOf(words); }

std::shared_ptr<const MeasuredBrdf> makeMeasuredBrdf(std::string name, LargeVector<float> cells) {
    auto brdf = std::make_shared<MeasuredBrdf>();
    brdf->name = std::move(name);
    brdf->words = std::move(cells);
    brdf->words.resize(MEASURED_WORDS);
    tbb::parallel_for(0, views, [&](int view) { ViewMaker(brdf->words, view).make(); });
    return brdf;
}

}  // namespace gp
