#include "ray_replay.h"

#include <algorithm>
#include <atomic>

#include <pmmintrin.h>
#include <tbb/parallel_for.h>
#include <xmmintrin.h>

#include "backend/cpu/embree_api.h"
#include "spread.h"

namespace gp::bench {
namespace {

using cpu::QueryContext;
using cpu::RecordedRay;
using cpu::SceneView;

constexpr size_t blockSize = 4096;  // a multiple of every packet's width
constexpr unsigned masks[rayKinds] = {1, 2, 4};  // VisibilityBits of scene/scene.h

struct DenormalsOff {  // Embree wants both set on every thread that traces
    unsigned before = _mm_getcsr();
    DenormalsOff() {
        _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
        _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    }
    ~DenormalsOff() { _mm_setcsr(before); }
};

// Any seed will do for the chances of blended surfaces; it must only change from ray to ray.
uint32_t alphaSeed(size_t ray) { return uint32_t(ray) * 0x9E3779B9u; }

void fill(RTCRay& q, const RecordedRay& r, unsigned mask) {
    q.org_x = r.origin[0], q.org_y = r.origin[1], q.org_z = r.origin[2];
    q.dir_x = r.direction[0], q.dir_y = r.direction[1], q.dir_z = r.direction[2];
    q.tnear = r.tNear, q.tfar = r.tFar, q.time = 0;
    q.mask = mask, q.id = 0, q.flags = 0;
}

uint64_t closest(const SceneView& view, RayKind kind, const std::vector<RecordedRay>& rays,
                 size_t begin, size_t end) {
    QueryContext query;
    cpu::initQuery(query, &view, nullptr, kind == cameraRays);
    uint64_t met = 0;
    for (size_t i = begin; i < end; ++i) {
        RTCRayHit q;
        fill(q.ray, rays[i], masks[kind]);
        q.hit.geomID = q.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        query.alphaSeed = alphaSeed(i);
        cpu::intersect1(view.scene, query, q);
        met += q.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    return met;
}

uint64_t occluded(const SceneView& view, const std::vector<RecordedRay>& rays, size_t begin,
                  size_t end) {
    QueryContext query;
    cpu::initQuery(query, &view, nullptr, false);
    uint64_t met = 0;
    for (size_t i = begin; i < end; ++i) {
        RTCRay q;
        fill(q, rays[i], masks[shadowRays]);
        query.alphaSeed = alphaSeed(i);
        cpu::occluded1(view.scene, query, q);
        met += q.tfar < 0;
    }
    return met;
}

void intersectPacket(const int* valid, RTCScene s, QueryContext& c, RTCRayHit8& q) {
    cpu::intersect8(valid, s, c, q);
}
void intersectPacket(const int* valid, RTCScene s, QueryContext& c, RTCRayHit16& q) {
    cpu::intersect16(valid, s, c, q);
}

template <class Packet, size_t width>
uint64_t packets(const SceneView& view, const std::vector<RecordedRay>& rays, size_t begin,
                 size_t end) {
    uint64_t met = 0;
    uint32_t seeds[width];
    QueryContext query;
    cpu::initQuery(query, &view, seeds, true);
    for (size_t first = begin; first < end; first += width) {
        alignas(64) int valid[width];
        alignas(64) Packet q;
        for (size_t k = 0; k < width; ++k) {
            const RecordedRay& r = rays[std::min(first + k, end - 1)];
            valid[k] = first + k < end ? -1 : 0;
            seeds[k] = alphaSeed(first + k);
            q.ray.org_x[k] = r.origin[0], q.ray.org_y[k] = r.origin[1];
            q.ray.org_z[k] = r.origin[2], q.ray.dir_x[k] = r.direction[0];
            q.ray.dir_y[k] = r.direction[1], q.ray.dir_z[k] = r.direction[2];
            q.ray.tnear[k] = r.tNear, q.ray.tfar[k] = r.tFar, q.ray.time[k] = 0;
            q.ray.mask[k] = masks[cameraRays], q.ray.id[k] = unsigned(k), q.ray.flags[k] = 0;
            q.hit.geomID[k] = q.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
        }
        intersectPacket(valid, view.scene, query, q);
        for (size_t k = 0; k < width; ++k)
            met += valid[k] != 0 && q.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
    }
    return met;
}

// trace(begin, end) for all blocks on all threads: what they met, and how long it took.
template <class Trace>
Replay onAllThreads(size_t count, tbb::task_arena& arena, const Trace& trace) {
    std::atomic<uint64_t> met{0};
    const Stopwatch watch;
    arena.execute([&] {
        tbb::parallel_for(size_t(0), (count + blockSize - 1) / blockSize, [&](size_t block) {
            const DenormalsOff denormalsOff;
            met += trace(block * blockSize, std::min((block + 1) * blockSize, count));
        }, tbb::simple_partitioner());
    });
    return {watch.wall(), watch.core(), met};
}

}  // namespace

Replay replay(const SceneView& view, RayKind kind, const std::vector<RecordedRay>& rays,
              tbb::task_arena& arena) {
    return onAllThreads(rays.size(), arena, [&](size_t begin, size_t end) {
        return kind == shadowRays ? occluded(view, rays, begin, end)
                                  : closest(view, kind, rays, begin, end);
    });
}

Replay replayPackets(const SceneView& view, const std::vector<RecordedRay>& rays,
                     tbb::task_arena& arena) {
    const bool wide = __builtin_cpu_supports("avx512f");
    return onAllThreads(rays.size(), arena, [&](size_t begin, size_t end) {
        return wide ? packets<RTCRayHit16, 16>(view, rays, begin, end)
                    : packets<RTCRayHit8, 8>(view, rays, begin, end);
    });
}

}  // namespace gp::bench
