// gp_bench_ocean: what one step of time costs the sea, part by part, over the cascades that
// OceanSettings has by default; on TBB's threads. Prints JSON: milliseconds by the wall's clock and
// those that all threads computed.
#include <cstdio>
#include <iostream>

#include <CLI/CLI.hpp>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include "ocean/ocean_parts.h"
#include "spread.h"

namespace gp::bench {
namespace {

using Json = nlohmann::ordered_json;

struct Part {
    Spread wall, core;

    template <class F>
    void measure(const F& work) {
        const Stopwatch watch;
        work();
        wall.add(1e3 * watch.wall());
        core.add(1e3 * watch.core());
    }
    Json json() const { return {{"wall_ms", wall.json()}, {"core_ms", core.json()}}; }
};

struct Parts {
    Part start, columns, rows, foam, slopes, all;
};

// The steps of Ocean::setTime, one after the other.
class Steps {
public:
    explicit Steps(const OceanSettings& settings)
        : kernels_(waveKernels()), plan_(kernels_.newPlan(settings.size), kernels_.freePlan) {
        for (uint32_t i = 0; i < settings.cascades; ++i) cascades_.emplace_back(settings, i);
    }

    void run(double seconds, Parts& parts) {
        parts.columns.measure([&] { transform(seconds, kernels_.columns); });
        parts.rows.measure([&] { transform(seconds, kernels_.rows); });
        // Without the ticks, which the whole has.
        parts.foam.measure([&] {
            for (OceanCascade& c : cascades_) {
                c.foam.update(seconds, c.squeeze.data(), c.points.data(),
                              [](double, uint16_t*) {});
            }
        });
        parts.slopes.measure([&] {
            for (OceanCascade& c : cascades_) c.slopes.build(c.points.data(), c.waves.size);
        });
    }

private:
    void transform(double seconds, void (*step)(const WaveTask&, uint32_t)) {
        for (OceanCascade& c : cascades_) {
            WaveTask task;
            task.waves = &c.waves;
            task.plan = plan_.get();
            task.between = c.between.get();
            task.seconds = seconds;
            task.points = c.points.data();
            task.squeeze = c.squeeze.data();
            tbb::parallel_for(0u, c.waves.size / kernels_.lanes,
                              [&](uint32_t group) { step(task, group); });
        }
    }

    const WaveKernels& kernels_;
    std::unique_ptr<void, void (*)(void*)> plan_;
    std::vector<OceanCascade> cascades_;
};

int run(int argc, char** argv) {
    CLI::App app("Milliseconds of the sea's parts", "gp_bench_ocean");
    unsigned steps = 60, threads = 0;
    OceanSettings settings;
    app.add_option("--steps", steps, "steps of 1/30 s")->check(CLI::Range(2u, 100000u));
    app.add_option("--threads", threads, "0: all");
    app.add_option("--size", settings.size, "points along a side");
    CLI11_PARSE(app, argc, argv);
    if (const std::string fault = oceanFault(settings); !fault.empty()) {
        std::fprintf(stderr, "gp_bench_ocean: %s\n", fault.c_str());
        return 1;
    }
    const size_t most = threads ? threads : size_t(tbb::this_task_arena::max_concurrency());
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, most);

    Parts parts;
    std::unique_ptr<Ocean> ocean;
    for (int i = 0; i < 5; ++i) {
        parts.start.measure([&] { ocean = std::make_unique<Ocean>(settings); });
    }
    Steps pieces(settings);
    {
        Parts warm;
        pieces.run(0.0, warm);
    }
    for (unsigned i = 1; i <= steps; ++i) {
        const double seconds = i / 30.0;
        pieces.run(seconds, parts);
        parts.all.measure([&] { ocean->setTime(seconds); });
    }
    std::cout << Json{{"instructions", waveKernels().name}, {"threads", most},
                      {"size", settings.size}, {"cascades", settings.cascades},
                      {"construction", parts.start.json()},
                      {"spectrum and FFTs along x", parts.columns.json()},
                      {"FFTs along y and points", parts.rows.json()},
                      {"foam", parts.foam.json()}, {"slope moments", parts.slopes.json()},
                      {"update", parts.all.json()}}.dump(2) << "\n";
    return 0;
}

}  // namespace
}  // namespace gp::bench

int main(int argc, char** argv) { return gp::bench::run(argc, argv); }
