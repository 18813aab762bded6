// Embree 3.13 and 4 behind one set of names; the only file that includes Embree's header.
#pragma once

#if GP_EMBREE_VERSION >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cstdint>

namespace gp::cpu {

struct SceneView;

// What travels with a query to the filter function: Embree's own context first.
struct QueryContext {
#if GP_EMBREE_VERSION >= 4
    RTCRayQueryContext rtc;
#else
    RTCIntersectContext rtc;
#endif
    const SceneView* scene;
    uint32_t alphaSeed;            // one ray: decides which transparent surfaces it passes
    const uint32_t* packetSeeds;   // packets: the same for each ray, by its id; null for one ray
};

inline void initQuery(QueryContext& context, const SceneView* scene,
                      const uint32_t* packetSeeds, [[maybe_unused]] bool coherent) {
#if GP_EMBREE_VERSION >= 4
    rtcInitRayQueryContext(&context.rtc);
#else
    rtcInitIntersectContext(&context.rtc);
    context.rtc.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                 : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
#endif
    context.scene = scene;
    context.alphaSeed = 0;
    context.packetSeeds = packetSeeds;
}

#if GP_EMBREE_VERSION >= 4
inline RTCIntersectArguments intersectArguments(QueryContext& context, bool coherent) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context.rtc;
    arguments.flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
    return arguments;
}
#endif

inline void intersect1(RTCScene scene, QueryContext& context, RTCRayHit& ray) {
#if GP_EMBREE_VERSION >= 4
    RTCIntersectArguments arguments = intersectArguments(context, false);
    rtcIntersect1(scene, &ray, &arguments);
#else
    rtcIntersect1(scene, &context.rtc, &ray);
#endif
}

inline void intersect8(const int* valid, RTCScene scene, QueryContext& context, RTCRayHit8& rays) {
#if GP_EMBREE_VERSION >= 4
    RTCIntersectArguments arguments = intersectArguments(context, true);
    rtcIntersect8(valid, scene, &rays, &arguments);
#else
    rtcIntersect8(valid, scene, &context.rtc, &rays);
#endif
}

inline void intersect16(const int* valid, RTCScene scene, QueryContext& context,
                        RTCRayHit16& rays) {
#if GP_EMBREE_VERSION >= 4
    RTCIntersectArguments arguments = intersectArguments(context, true);
    rtcIntersect16(valid, scene, &rays, &arguments);
#else
    rtcIntersect16(valid, scene, &context.rtc, &rays);
#endif
}

inline void occluded1(RTCScene scene, QueryContext& context, RTCRay& ray) {
#if GP_EMBREE_VERSION >= 4
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &context.rtc;
    arguments.flags = RTC_RAY_QUERY_FLAG_INCOHERENT;
    rtcOccluded1(scene, &ray, &arguments);
#else
    rtcOccluded1(scene, &context.rtc, &ray);
#endif
}

}  // namespace gp::cpu
