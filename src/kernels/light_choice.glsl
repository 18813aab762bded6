// Which light a shadow ray goes to: the environment, a directional light, or one that the light
// tree picks, in proportion to the irradiance that each may bring.
// Based on: Conty Estevez and Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree
// Splitting", HPG; here without splitting, one light a choice.
// Resources: load_frame, load_light, load_light_node, and surface.glsl's for textured lights.
#ifndef GP_KERNELS_LIGHT_CHOICE_GLSL
#define GP_KERNELS_LIGHT_CHOICE_GLSL
#include "kernels/environment.glsl"
#include "kernels/material.glsl"
#include "kernels/sky.glsl"
#include "shading/colour.glsl"
#include "shading/light/directional.glsl"
#include "shading/light/rectangle.glsl"
#include "shading/light/sphere.glsl"
#include "shading/light/tree.glsl"
#include "shading/light/triangle.glsl"
#include "shared/scene_structs.glsl"

#define LIGHT_ENVIRONMENT 0xFFFFFFFDu  // LightChoice::light of the environment

struct LightChoice {
    uint light;
    float pmf;  // 0: there is none
};

// Irradiance, as luminance, that each group may bring to a point. normal: of a surface that only
// reflects, on the viewer's side; the zero vector where light counts from all around.
struct LightGroups {
    float environment;
    float directional;
    float tree;
    float sum;              // of those that a shadow ray chooses among
    float directional_sum;  // the same of the shadow ray that may choose directional lights
    uint resampled;         // 1: lights that are not directional come from a reservoir, and weights
                            // between techniques leave out how probable each light was
    uint suns_elsewhere;    // 1: what a ray finds of directional lights has been counted already
};

float directional_importance(IN(LightRecord) record, vec3 normal) {
    bool all_around = normal == vec3(0.0f);
    // A disk of light still reaches a surface whose horizon hides its centre.
    float c = all_around ? 1.0f : dot(normal, -record.direction) + sin(record.radius);
    return luminance(record.emission) * clamp(c, 0.0f, 1.0f);
}

// How much each child of a node may matter to a point.
struct LightChildren {
    float importance[LIGHT_TREE_WIDTH];
    float sum;
};

LightChildren light_children(uint node, vec3 p, vec3 normal) {
    LET_REF(LightTreeNode) n = load_light_node(node);
    uint transmissive = normal == vec3(0.0f) ? 1u : 0u;
    LightChildren c;
    for (int i = 0; i < LIGHT_TREE_WIDTH; ++i) {
        LightNode child;
        child.centre = vec3(n.centre_x[i], n.centre_y[i], n.centre_z[i]);
        child.radius2 = n.radius2[i];
        child.phi = n.phi[i];
        child.w = vec3(n.axis_x[i], n.axis_y[i], n.axis_z[i]);
        child.cos_theta_o = n.cos_theta_o[i];
        child.cos_theta_e = n.cos_theta_e[i];
        child.two_sided = n.child[i] & LIGHT_TREE_TWO_SIDED;
        c.importance[i] = light_node_importance(child, p, normal, transmissive);
    }
    c.sum = 0.0f;
    for (int i = 0; i < LIGHT_TREE_WIDTH; ++i) { c.sum += c.importance[i]; }
    return c;
}

LightGroups light_groups(vec3 p, vec3 normal) {
    LET_REF(FrameConstants) f = load_frame();
    LightGroups g;
    g.environment = f.environment_power * f.environment_visibility;
    g.directional = 0.0f;
    for (uint i = 0u; i < f.directional_lights; ++i) {
        g.directional += directional_importance(load_light(i), normal);
    }
    g.directional *= f.directional_visibility;
    g.tree = 0.0f;
    if (f.tree_nodes != 0u) {
        // Power over squared distance is pi times the irradiance of a Lambertian emitter.
        float importance = light_children(0u, p, normal).sum * INV_PI * f.tree_visibility;
        float others = g.environment + g.directional;
        // Bounds are crude; no group that may matter is left to chance alone.
        g.tree = others > 0.0f && importance > 0.0f
                     ? clamp(importance, 0.1f * others, 10.0f * others)
                     : importance;
    }
    g.sum = g.environment + g.directional + g.tree;
    g.directional_sum = g.sum;
    g.resampled = 0u;
    g.suns_elsewhere = 0u;
    return g;
}

// With a shadow ray for directional lights and another for all else.
LightGroups light_groups_apart(IN(LightGroups) g) {
    LightGroups apart = g;
    apart.sum = g.environment + g.tree;
    apart.directional_sum = g.directional;
    return apart;
}

LightGroups light_groups_directional(IN(LightGroups) apart) {
    LightGroups g = apart;
    g.environment = 0.0f;
    g.tree = 0.0f;
    g.sum = apart.directional_sum;
    return g;
}

LightGroups light_groups_others(IN(LightGroups) apart) {
    LightGroups g = apart;
    g.directional = 0.0f;
    return g;
}

// Without what is infinitely far.
LightGroups light_groups_near(IN(LightGroups) g) {
    LightGroups near = g;
    near.environment = 0.0f;
    near.directional = 0.0f;
    near.sum = g.tree;
    near.directional_sum = 0.0f;
    return near;
}

// The group that a light belongs to: 0 the environment, 1 directional lights, 2 the tree's.
uint light_group(uint light) {
    LET_REF(FrameConstants) f = load_frame();
    if (light == LIGHT_ENVIRONMENT) { return 0u; }
    return light < f.directional_lights ? 1u : 2u;
}

// Down the tree: u is stretched anew at every node.
LightChoice choose_from_tree(vec3 p, vec3 normal, float u, float pmf) {
    LightChoice choice;
    choice.light = NO_INDEX;
    choice.pmf = 0.0f;
    uint child = 0u;
    while ((child & LIGHT_TREE_LEAF) == 0u) {
        uint node = child & LIGHT_TREE_INDEX;
        LightChildren c = light_children(node, p, normal);
        float x = u * c.sum;
        int i = 0;
        while (i < LIGHT_TREE_WIDTH - 1 && x >= c.importance[i]) {
            x -= c.importance[i];
            ++i;
        }
        float w = c.importance[i];
        if (!(w > 0.0f)) { return choice; }  // nothing matters; rounding, once in millions
        u = min(x / w, ONE_MINUS_EPSILON);
        pmf *= w / c.sum;
        child = load_light_node(node).child[i];
    }
    choice.light = child & LIGHT_TREE_INDEX;
    choice.pmf = pmf;
    return choice;
}

LightChoice choose_light(IN(LightGroups) g, vec3 p, vec3 normal, float u) {
    LET_REF(FrameConstants) f = load_frame();
    LightChoice choice;
    choice.light = NO_INDEX;
    choice.pmf = 0.0f;
    float sum = g.sum;
    if (!(sum > 0.0f)) { return choice; }
    float x = u * sum;
    if (x < g.environment) {
        choice.light = LIGHT_ENVIRONMENT;
        choice.pmf = g.environment / sum;
        return choice;
    }
    x -= g.environment;
    if (x < g.directional) {
        for (uint i = 0u; i < f.directional_lights; ++i) {
            float w = directional_importance(load_light(i), normal) * f.directional_visibility;
            if (x < w) {
                choice.light = i;
                choice.pmf = w / sum;
                return choice;
            }
            x -= w;
        }
        return choice;  // rounding: no sample, once in millions
    }
    x -= g.directional;
    return g.tree > 0.0f
               ? choose_from_tree(p, normal, min(x / g.tree, ONE_MINUS_EPSILON), g.tree / sum)
               : choice;
}

// The probability of choosing light `index` from p.
float light_choice_pmf(IN(LightGroups) g, vec3 p, vec3 normal, uint index) {
    LET_REF(FrameConstants) f = load_frame();
    float sum = index < f.directional_lights ? g.directional_sum : g.sum;
    if (!(sum > 0.0f)) { return 0.0f; }
    if (index < f.directional_lights) {
        return directional_importance(load_light(index), normal) * f.directional_visibility / sum;
    }
    if (g.resampled != 0u) { return 1.0f; }
    // From the light up to the root: no longer path than the choice took.
    float pmf = g.tree / sum;
    uint place = load_light(index).leaf;
    while (true) {
        uint node = place / uint(LIGHT_TREE_WIDTH);
        LightChildren c = light_children(node, p, normal);
        if (!(c.sum > 0.0f)) { return 0.0f; }
        pmf *= c.importance[place % uint(LIGHT_TREE_WIDTH)] / c.sum;
        if (node == 0u) { return pmf; }
        place = load_light_node(node).parent;
    }
    return pmf;
}

DirectionalLight directional_light(IN(LightRecord) r) {
    DirectionalLight l;
    l.direction = -r.direction;
    l.irradiance = r.emission;
    float s = sin(0.5f * r.radius);
    l.one_minus_cos_max = 2.0f * s * s;
    return l;
}

SphereLight sphere_light(IN(LightRecord) r) {
    SphereLight l;
    l.position = r.position;
    l.radius = r.radius;
    l.emission = r.emission;
    l.axis = r.direction;
    l.cos_inner = r.cos_inner;
    l.cos_outer = r.kind == LIGHT_SPOT ? r.cos_outer : -2.0f;
    return l;
}

RectangleLight rectangle_light(IN(LightRecord) r) {
    RectangleLight l;
    l.corner = r.position;
    l.edge_x = r.edge_u;
    l.edge_y = r.edge_v;
    l.radiance = r.emission;
    l.two_sided = r.two_sided;
    return l;
}

TriangleLight triangle_light(IN(LightRecord) r) {
    TriangleLight l;
    l.p0 = r.position;
    l.edge_1 = r.edge_u;
    l.edge_2 = r.edge_v;
    l.radiance = r.emission;
    l.two_sided = r.two_sided;
    return l;
}

// What textures and coverage make of an emissive triangle's radiance at one point. Coverage counts
// because a ray that the material sends meets the triangle only as often as that.
vec3 triangle_emission(IN(LightRecord) r, vec3 light_barycentrics) {
    if (r.instance == NO_INDEX) { return r.emission; }  // a polygon's
    LET_REF(InstanceRecord) instance = load_instance(r.instance);
    LET_REF(MaterialRecord) m = load_material(instance.material);
    bool covers = (m.flags & (MATERIAL_ALPHA_MASK | MATERIAL_ALPHA_BLEND)) == 0u;
    if ((m.textures & SLOT_EMISSION) == 0u && covers) { return r.emission; }
    vec3 b = light_barycentrics;
    // The light of a mirrored instance has its corners in the order that the mirror shows.
    if (instance.mirrored != 0u) { b = vec3(b.x, b.z, b.y); }
    TriangleCorners c = load_triangle(instance.geometry, r.primitive);
    Surface s;
    s.uv0 = interpolate(c.uv0, c.uv1, c.uv2, b.y, b.z);
    s.uv1 = load_uv1(instance.geometry, r.primitive, b.y, b.z);
    s.lod = FINEST_LEVEL;
    vec3 e = r.emission;
    if ((m.textures & SLOT_EMISSION) != 0u) { e *= vec3(read_slot(m.emission_slot, s, 0.0f)); }
    if (covers) { return e; }
    float alpha = m.base_color.w;
    if ((m.textures & SLOT_BASE_COLOR) != 0u) { alpha *= read_slot(m.base_color_slot, s, 0.0f).w; }
    if ((m.flags & MATERIAL_VERTEX_COLOR) != 0u) {
        alpha *=
            load_vertex_color(instance.geometry, r.primitive, b.y, b.z).w;
    }
    if ((m.flags & MATERIAL_ALPHA_MASK) != 0u) { return alpha >= m.alpha_cutoff ? e : vec3(0.0f); }
    return e * alpha;
}

// One point of a light that is not the environment, as seen from p.
LightSample sample_local_light(uint index, vec3 p, vec2 u) {
    LET_REF(LightRecord) r = load_light(index);
    if (r.kind == LIGHT_DIRECTIONAL) { return directional_light_sample(directional_light(r), u); }
    if (r.kind == LIGHT_RECTANGLE) { return rectangle_light_sample(rectangle_light(r), p, u); }
    if (r.kind == LIGHT_TRIANGLE) {
        LightSample s = triangle_light_sample(triangle_light(r), p, u);
        s.radiance =
            s.pdf > 0.0f ? triangle_emission(r, triangle_light_barycentrics(u)) : vec3(0.0f);
        return s;
    }
    return sphere_light_sample(sphere_light(r), p, u);
}

// A light and a point of it for a shadow ray, chosen before the material is known: the radiance of
// the environment arrives meanwhile.
struct ChosenLight {
    uint light;
    float pmf;        // 0: there is none
    LightSample point;
    vec2 environment_uv;
};

// The point of light `choice` that u stands for, as seen from p.
ChosenLight chosen_light_point(IN(LightChoice) choice, vec3 p, vec2 u) {
    ChosenLight c;
    c.light = choice.light;
    c.pmf = choice.pmf;
    c.point = light_sample_none();
    c.environment_uv = vec2(0.0f);
    if (choice.pmf <= 0.0f) { return c; }
    if (choice.light != LIGHT_ENVIRONMENT) {
        c.point = sample_local_light(choice.light, p, u);
        // No ray would meet a lamp that is farther away than rays are long.
        bool beyond = c.point.distance > load_frame().ray_length;
        if (beyond && c.point.distance < FLOAT_MAX) { c.point = light_sample_none(); }
        return c;
    }
    EnvironmentSample e = environment_sample(u);
    c.point.wi = e.wi;
    c.point.distance = FLOAT_MAX;
    c.point.pdf = e.pdf;
    c.point.is_delta = 0u;
    c.environment_uv = e.uv;
    return c;
}

ChosenLight choose_light_point(IN(LightGroups) g, vec3 p, vec3 normal, float u_choice, vec2 u) {
    return chosen_light_point(choose_light(g, p, normal, u_choice), p, u);
}

vec3 chosen_light_radiance(IN(ChosenLight) c) {
    if (c.light != LIGHT_ENVIRONMENT) { return c.point.radiance; }
    return sky_is_traced(false) ? sky_background(c.point.wi, 0.0f)
                                : environment_radiance_at(c.environment_uv);
}

// The density in solid angle with which sample_local_light leads from p to the point p + to_light
// of a light that is not infinitely far.
float light_pdf(IN(LightRecord) r, vec3 p, vec3 to_light) {
    if (r.kind == LIGHT_RECTANGLE) { return rectangle_light_pdf(rectangle_light(r), p, to_light); }
    if (r.kind == LIGHT_TRIANGLE) { return triangle_light_pdf(triangle_light(r), to_light); }
    return sphere_light_pdf(sphere_light(r), p, to_light);
}

// Radiance of a sphere, rectangle or polygon that a ray from p along `direction` met.
vec3 light_radiance(IN(LightRecord) r, vec3 p, vec3 direction) {
    if (r.kind == LIGHT_RECTANGLE || r.kind == LIGHT_TRIANGLE) {
        return dot(r.direction, direction) < 0.0f || r.two_sided != 0u ? r.emission : vec3(0.0f);
    }
    return sphere_light_emission(sphere_light(r), p);
}

#endif
