// Calls from many threads at once: they follow one another, and nothing is lost or seen half.
// Meant to run under the thread sanitizer too.
#include <atomic>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "api/world.h"

namespace gp::test {

namespace {

constexpr int threadCount = 8;
constexpr int rounds = 40;

void onAllThreads(const std::function<void(int)>& work) {
    std::vector<std::thread> threads;
    for (int t = 0; t < threadCount; ++t) threads.emplace_back(work, t);
    for (std::thread& thread : threads) thread.join();
}

TEST(Threads, OneDeviceServesEight) {
    const GpDevice device = newNullDevice();
    const GpScene scene = gpNewScene(device);
    std::atomic<int> failures{0};
    onAllThreads([&](int t) {
        for (int i = 0; i < rounds; ++i) {
            const GpMeshDesc meshDesc = triangleDesc(GP_MESH_DYNAMIC);
            const GpMesh mesh = gpNewMesh(device, &meshDesc);
            GpInstanceDesc desc{};
            desc.id = uint64_t(t * rounds + i + 1);
            desc.mesh = mesh;
            const GpInstance instance = gpNewInstance(scene, &desc);
            failures += gpUpdateMesh(mesh, &meshDesc) != GP_SUCCESS;
            failures += gpSetInstanceTransform(instance, identity) != GP_SUCCESS;
            if (i % 2) failures += gpRemoveInstance(instance) != GP_SUCCESS;
            failures += gpReleaseMesh(mesh) != GP_SUCCESS;
            failures += gpReleaseMesh(mesh) != GP_ERROR_INVALID_HANDLE;
            failures += gpGetError(device, nullptr) != GP_SUCCESS;
            failures += gpGetError(nullptr, nullptr) != GP_ERROR_INVALID_HANDLE;
        }
    });
    EXPECT_EQ(failures, 0);
    GpSceneInfo info{};
    EXPECT_EQ(gpGetSceneInfo(scene, &info), GP_SUCCESS);
    EXPECT_EQ(info.instances, uint64_t(threadCount * rounds / 2));
    EXPECT_EQ(gpReleaseDevice(device), GP_SUCCESS);
}

TEST(Threads, ReleasingIsWonByOne) {
    for (int round = 0; round < rounds; ++round) {
        const GpDevice device = newNullDevice();
        const GpScene scene = gpNewScene(device);
        std::atomic<int> released{0}, refused{0};
        onAllThreads([&](int t) {
            // Half of them race for the scene, half for the device under it.
            const GpError error = t % 2 ? gpReleaseScene(scene) : gpReleaseDevice(device);
            (error == GP_SUCCESS ? released : refused)++;
            EXPECT_TRUE(error == GP_SUCCESS || error == GP_ERROR_INVALID_HANDLE);
            gpGetError(nullptr, nullptr);
        });
        EXPECT_GE(released, 1);
        EXPECT_LE(released, 2);
        EXPECT_EQ(released + refused, threadCount);
    }
}

TEST(Threads, DevicesOfTheirOwn) {
    std::atomic<int> failures{0};
    onAllThreads([&](int) {
        for (int i = 0; i < 5; ++i) {
            World w;
            const GpRenderOptions one = fewSamples();
            failures += gpRender(w.frame, w.scene, nullptr, &one) != GP_SUCCESS;
        }
    });
    EXPECT_EQ(failures, 0);
}

TEST(Threads, CancellingFromAnotherThreadEndsTheRender) {
    World w;
    struct Shared {
        std::atomic<bool> running{false}, cancelled{false};
    } shared;
    GpRenderOptions options{};
    options.timeLimit = 60;
    options.progressUser = &shared;
    options.progress = [](void* user, const GpProgress*) {
        // The null backend would be done before the other thread has begun.
        Shared& s = *static_cast<Shared*>(user);
        s.running = true;
        while (!s.cancelled) std::this_thread::yield();
        return 0;
    };
    std::thread canceller([&] {
        while (!shared.running) std::this_thread::yield();
        gpCancelRender(w.device);
        shared.cancelled = true;
    });
    EXPECT_EQ(gpRender(w.frame, w.scene, nullptr, &options), GP_ERROR_CANCELLED);
    canceller.join();
    GpFrameStatistics statistics{};
    EXPECT_EQ(gpGetFrameStatistics(w.frame, &statistics), GP_SUCCESS);
    EXPECT_GE(statistics.samplesPerPixel, 1u);
    EXPECT_LT(statistics.secondsRender, 30);
    EXPECT_EQ(gpGetError(w.device, nullptr), GP_ERROR_CANCELLED);
}

}  // namespace
}  // namespace gp::test
