// Rays by Embree: part of the hot code, included inside an unnamed namespace by isa/kernels.h only.

inline void setRay(RTCRay& q, const Ray& ray, uint32_t mask) {
    q.org_x = ray.origin.x, q.org_y = ray.origin.y, q.org_z = ray.origin.z;
    q.dir_x = ray.direction.x, q.dir_y = ray.direction.y, q.dir_z = ray.direction.z;
    q.tnear = ray.t_min, q.tfar = ray.t_max, q.time = 0;
    q.mask = mask, q.id = 0, q.flags = 0;
}

// Embree's answer in our terms. Without an instance it is the shape of a light.
inline Hit makeHit(const SceneView& view, uint32_t instance, uint32_t geometry, uint32_t primitive,
                   float t, float u, float v) {
    Hit h;
    h.t = t, h.u = u, h.v = v;
    if (geometry == RTC_INVALID_GEOMETRY_ID) {
        h.instance = HIT_NOTHING, h.primitive = 0;
    } else if (instance == RTC_INVALID_GEOMETRY_ID) {
        h.instance = HIT_LIGHT;
        h.primitive = view.lightOfPrimitive[geometry - view.instanceCount][primitive];
    } else {
        h.instance = instance, h.primitive = primitive;
        const GeometryView& g = view.geometries[view.instances[instance].geometry];
        if (g.latticeColumns != 0) latticeHit(g, h);
    }
    return h;
}

void Kernels::record(uint32_t kind, const Ray& ray) const {
    if (!recorder || recorder->count[kind] >= recorder->capacity) return;
    recorder->rays[kind][recorder->count[kind]++] = {
        {ray.origin.x, ray.origin.y, ray.origin.z},
        {ray.direction.x, ray.direction.y, ray.direction.z}, ray.t_min, ray.t_max};
}

Hit Kernels::trace(RTCScene scene, const Ray& ray, uint32_t mask) {
    ++counts.bounce;
    RTCRayHit q;
    setRay(q.ray, ray, mask);
    q.hit.geomID = q.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    query.alphaSeed = nextAlphaSeed();
    intersect1(scene, query, q);
    return makeHit(view, q.hit.instID[0], q.hit.geomID, q.hit.primID, q.ray.tfar, q.hit.u, q.hit.v);
}

Hit Kernels::trace_closest(const Ray& ray) {
    record(1, ray);
    return trace(view.scene, ray, rayBounce);
}

Hit Kernels::trace_sky(const Ray& ray) { return trace(view.sky, ray, raySky); }

float Kernels::trace_visible(const Ray& ray) {
    ++counts.shadow;
    record(2, ray);
    RTCRay q;
    setRay(q, ray, rayShadow);
    query.alphaSeed = nextAlphaSeed();
    occluded1(view.scene, query, q);
    return q.tfar < 0 ? 0.0f : 1.0f;
}

#if defined(__AVX512F__)
constexpr uint32_t packetSize = 16;
using RayPacket = RTCRayHit16;
#else
constexpr uint32_t packetSize = 8;
using RayPacket = RTCRayHit8;
#endif

inline void intersectPacket(const int* valid, RTCScene scene, QueryContext& query, RayPacket& q) {
#if defined(__AVX512F__)
    intersect16(valid, scene, query, q);
#else
    intersect8(valid, scene, query, q);
#endif
}

// Camera rays of neighbouring pixels, as coherent packets.
void Kernels::trace_camera(const Ray* rays, const uint32_t* alphaSeeds, Hit* hits, uint32_t count) {
    counts.camera += count;
    for (uint32_t begin = 0; begin < count; begin += packetSize) {
        alignas(64) int valid[packetSize];
        alignas(64) RayPacket q;
        const uint32_t n = std::min(packetSize, count - begin);
        for (uint32_t i = 0; i < packetSize; ++i) {
            const Ray& r = rays[begin + std::min(i, n - 1)];
            valid[i] = i < n ? -1 : 0;
            q.ray.org_x[i] = r.origin.x, q.ray.org_y[i] = r.origin.y, q.ray.org_z[i] = r.origin.z;
            q.ray.dir_x[i] = r.direction.x, q.ray.dir_y[i] = r.direction.y,
            q.ray.dir_z[i] = r.direction.z;
            q.ray.tnear[i] = r.t_min, q.ray.tfar[i] = r.t_max, q.ray.time[i] = 0;
            q.ray.mask[i] = rayCamera, q.ray.id[i] = i, q.ray.flags[i] = 0;
            q.hit.geomID[i] = q.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
            if (i < n) record(0, r);
        }
        QueryContext packetQuery;
        initQuery(packetQuery, &view, alphaSeeds + begin, true);
        intersectPacket(valid, view.scene, packetQuery, q);
        for (uint32_t i = 0; i < n; ++i)
            hits[begin + i] = makeHit(view, q.hit.instID[0][i], q.hit.geomID[i], q.hit.primID[i],
                                      q.ray.tfar[i], q.hit.u[i], q.hit.v[i]);
    }
}

// Whether a ray meets a point of an alpha-tested or blended surface, or passes through it. Blending
// is by chance, the same for the same ray and triangle however often Embree asks.
inline bool meetsSurface(const SceneView& view, uint32_t instance, uint32_t primitive, float u,
                         float v, uint32_t seed) {
    const InstanceRecord& r = view.instances[instance];
    const MaterialRecord& m = view.materials[r.material];
    if ((m.flags & (MATERIAL_ALPHA_MASK | MATERIAL_ALPHA_BLEND)) == 0) return true;
    const GeometryView& g = view.geometries[r.geometry];
    const uvec3 t = g.triangles[primitive];
    const float w = 1 - u - v;
    float alpha = m.base_color.w;
    if (m.textures & SLOT_BASE_COLOR) {
        const TextureSlot& slot = m.base_color_slot;
        const auto* p = static_cast<const PackedVertex*>(g.vertices);
        const bool second = slot.tex_coord != 0;
        const vec2 uv = !second ? p[t.x].uv * w + p[t.y].uv * u + p[t.z].uv * v
            : g.uv1 ? g.uv1[t.x] * w + g.uv1[t.y] * u + g.uv1[t.z] * v : vec2(0);
        const vec3 h(uv, 1);
        const vec2 moved(dot(vec3(slot.row_u), h), dot(vec3(slot.row_v), h));
        // Of the finest level: smaller copies would eat thin leaves.
        alpha *= sampleTexture(view.textures[slot.texture_index], moved, FINEST_LEVEL, 0.0f).w;
    }
    if (g.colors && (m.flags & MATERIAL_VERTEX_COLOR))
        alpha *=
            (float(g.colors[t.x].w) * w + float(g.colors[t.y].w) * u + float(g.colors[t.z].w) * v) /
            255.0f;
    if (m.flags & MATERIAL_ALPHA_MASK) return alpha >= m.alpha_cutoff;
    return unit_float(hash_u32(seed ^ hash_u32(instance * 0x9E3779B9u + primitive))) < alpha;
}

void alphaFilter(const RTCFilterFunctionNArguments* a) {
    const auto* query = reinterpret_cast<const QueryContext*>(a->context);
    for (unsigned i = 0; i < a->N; ++i) {
        if (a->valid[i] != -1) continue;
        const uint32_t seed = query->packetSeeds ? query->packetSeeds[RTCRayN_id(a->ray, a->N, i)]
                                                 : query->alphaSeed;
        const Hit h = makeHit(*query->scene, RTCHitN_instID(a->hit, a->N, i, 0), 0,
                              RTCHitN_primID(a->hit, a->N, i), 0, RTCHitN_u(a->hit, a->N, i),
                              RTCHitN_v(a->hit, a->N, i));
        if (!meetsSurface(*query->scene, h.instance, h.primitive, h.u, h.v, seed)) a->valid[i] = 0;
    }
}
