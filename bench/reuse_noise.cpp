// How noisy the indirect light of a real-time frame is, with each kind of indirect reuse: the
// numbers of docs/realtime.md.
//     reuse_noise SCENE.glb [--size WxH] [--frames N] [--runs N] [--step METRES] [--spp N]
// The camera is the scene's first (or shows it all) and goes aside by --step a frame, so that it
// ends where the reference is taken: the mean of --spp plain frames from there, whose own noise is
// taken off the errors.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "glitterpath/glitterpath.hpp"

namespace {

struct Settings {
    std::string scene;
    uint32_t width = 160, height = 90, frames = 16, runs = 4, spp = 1024;
    float step = 0;
    std::vector<std::string> tuning;
};

using Light = std::vector<double>;  // luminance, pixel after pixel

Light indirectOf(const gp::Frame& frame) {
    const std::vector<std::byte> bytes = frame.read(GP_IMAGE_INDIRECT);
    std::vector<float> rgba(bytes.size() / sizeof(float));
    std::memcpy(rgba.data(), bytes.data(), bytes.size());
    Light light(rgba.size() / 4);
    for (size_t i = 0; i < light.size(); ++i)
        light[i] = 0.2126 * rgba[4 * i] + 0.7152 * rgba[4 * i + 1] + 0.0722 * rgba[4 * i + 2];
    return light;
}

GpCameraDesc cameraAside(const GpCameraDesc& camera, float metres) {
    GpCameraDesc moved = camera;
    moved.position[0] += metres, moved.target[0] += metres;
    return moved;
}

double meanOf(const Light& light) {
    double sum = 0;
    for (double l : light) sum += l;
    return sum / double(light.size());
}

struct Reference {
    Light mean, variance;  // the latter of the mean
};

// Squared errors over squares; what is darker than a tenth of the mean counts as so bright.
double relativeError(const Light& light, const Reference& reference) {
    const double floor = 0.1 * meanOf(reference.mean);
    double sum = 0;
    for (size_t i = 0; i < light.size(); ++i) {
        const double expected = reference.mean[i], error = light[i] - expected;
        sum += (error * error - reference.variance[i]) / (expected * expected + floor * floor);
    }
    return sum / double(light.size());
}

struct Measured {
    double error = 0, brightness = 0, rays = 0;
    double milliseconds = 1e9;  // the least: the machine may have other things to do
};

double lightingTime(const gp::Frame& frame) {
    double sum = 0;
    for (const GpPassTime& pass : frame.passTimes())
        if (pass.name == std::string("lighting")) sum += pass.milliseconds;
    return sum;
}

class Bench {
public:
    explicit Bench(const Settings& s) : s_(s), scene_(device_) {
        scene_.load(s.scene);
        camera_ = scene_.info().cameras > 0 ? scene_.camera(0)
                                            : scene_.frame(float(s.width) / float(s.height));
        for (const std::string& word : s_.tuning) {
            const size_t equals = word.find('=');
            names_.push_back(word.substr(0, equals));
            parameters_.push_back({nullptr, std::stof(word.substr(equals + 1))});
        }
        for (size_t i = 0; i < names_.size(); ++i) parameters_[i].name = names_[i].c_str();
    }

    void reference() {
        gp::Frame frame(device_, s_.width, s_.height, GP_MODE_REALTIME);
        reference_ = {Light(pixels()), Light(pixels())};
        for (uint32_t i = 0; i < s_.spp; ++i) {
            GpRenderOptions o = options(GP_REUSE_NONE, GP_DENOISER_NONE);
            o.seed = 1u << 20 | i, o.realtime.resetHistory = 1;
            frame.render(scene_, camera_, o);
            const Light light = indirectOf(frame);
            for (size_t p = 0; p < light.size(); ++p) {
                reference_.mean[p] += light[p] / s_.spp;
                reference_.variance[p] += light[p] * light[p] / s_.spp;
            }
        }
        for (size_t p = 0; p < pixels(); ++p)
            reference_.variance[p] =
                (reference_.variance[p] - reference_.mean[p] * reference_.mean[p]) / (s_.spp - 1);
    }

    Measured measure(GpLightReuse reuse, GpDenoiser denoiser) {
        Measured m;
        const double runs = s_.runs;
        for (uint32_t run = 0; run < s_.runs; ++run) {
            gp::Frame frame(device_, s_.width, s_.height, GP_MODE_REALTIME);
            for (uint32_t i = 0; i < s_.frames; ++i) {
                GpRenderOptions o = options(reuse, denoiser);
                o.seed = run;
                const GpCameraDesc now =
                    cameraAside(camera_, s_.step * float(s_.frames - 1 - i));
                frame.render(scene_, now, o);
                if (i > 0) m.milliseconds = std::min(m.milliseconds, lightingTime(frame));
            }
            const Light light = indirectOf(frame);
            m.error += relativeError(light, reference_) / runs;
            m.brightness += meanOf(light) / meanOf(reference_.mean) / runs;
            const GpFrameStatistics statistics = frame.statistics();
            m.rays += double(statistics.cameraRays + statistics.bounceRays +
                             statistics.shadowRays) / double(pixels()) / runs;
        }
        return m;
    }

private:
    size_t pixels() const { return size_t(s_.width) * s_.height; }
    GpRenderOptions options(GpLightReuse reuse, GpDenoiser denoiser) const {
        GpRenderOptions o{};
        o.realtime.antiAliasing = GP_AA_NONE;
        o.realtime.denoiser = denoiser;
        o.realtime.indirectReuse = reuse;
        o.realtime.parameters = parameters_.data();
        o.realtime.parameterCount = uint32_t(parameters_.size());
        return o;
    }

    Settings s_;
    gp::Device device_;
    gp::Scene scene_;
    GpCameraDesc camera_{};
    std::vector<std::string> names_;
    std::vector<GpDenoiserParameter> parameters_;
    Reference reference_;
};

void run(const Settings& s) {
    Bench bench(s);
    bench.reference();
    std::printf("%-9s %-9s %8s %11s %9s %11s\n", "denoiser", "reuse", "relMSE", "brightness",
                "rays", "lighting ms");
    const std::pair<const char*, GpDenoiser> denoisers[] = {{"none", GP_DENOISER_NONE},
                                                            {"asvgf", GP_DENOISER_ASVGF}};
    const std::pair<const char*, GpLightReuse> kinds[] = {
        {"none", GP_REUSE_NONE}, {"biased", GP_REUSE_BIASED}, {"unbiased", GP_REUSE_UNBIASED}};
    for (const auto& [denoiser, d] : denoisers)
        for (const auto& [name, kind] : kinds) {
            const Measured m = bench.measure(kind, d);
            std::printf("%-9s %-9s %8.4f %11.3f %9.2f %11.1f\n", denoiser, name, m.error,
                        m.brightness, m.rays, m.milliseconds);
        }
}

}  // namespace

int main(int argc, char** argv) {
    Settings s;
    std::string size = "160x90";
    CLI::App app("Noise of indirect light, by indirect reuse");
    app.add_option("scene", s.scene)->required();
    app.add_option("--size", size);
    app.add_option("--frames", s.frames)->check(CLI::Range(2u, 10000u));
    app.add_option("--runs", s.runs)->check(CLI::Range(1u, 10000u));
    app.add_option("--spp", s.spp)->check(CLI::Range(2u, 1000000u));
    app.add_option("--step", s.step);
    app.add_option("--tune", s.tuning);
    CLI11_PARSE(app, argc, argv);
    if (std::sscanf(size.c_str(), "%ux%u", &s.width, &s.height) != 2) {
        std::fprintf(stderr, "--size: WxH\n");
        return 2;
    }
    try {
        run(s);
        return 0;
    } catch (const gp::Error& error) {
        std::fprintf(stderr, "%s: %s\n", gpErrorName(error.code()), error.what());
        return 1;
    }
}
