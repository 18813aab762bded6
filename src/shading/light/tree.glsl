// The light tree: how much a group of lights may matter to a point. Lights are chosen by descending
// the tree with these numbers as probabilities, so they need not be exact, but never zero where the
// group gives light.
// [Conty Estevez and Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree Splitting";
//  cosines without angles: Pharr, Jakob and Humphreys 2023, section 12.6.3]
#ifndef GP_SHADING_LIGHT_TREE_GLSL
#define GP_SHADING_LIGHT_TREE_GLSL
#include "shading/constants.glsl"

// A node bounds its lights' positions by a sphere, their normals by a cone of half angle theta_o
// around w, and what each emits by theta_e on every side of its normal.
struct LightNode {
    vec3 centre;
    float radius2;      // squared
    float phi;          // power, W
    vec3 w;
    float cos_theta_o;
    float cos_theta_e;
    uint two_sided;     // 1: along -w as well
};

float sin_from_cos(float cosine) {
    return sqrt(max(0.0f, 1.0f - cosine * cosine));
}

// cos(max(0, a - b)) for angles in [0, pi].
float cos_of_difference(float cos_a, float cos_b) {
    return cos_a >= cos_b ? 1.0f
                          : cos_a * cos_b + sin_from_cos(cos_a) * sin_from_cos(cos_b);
}

// `ng` is the surface's unit normal, on the viewer's side; zero in a medium. A surface that lets
// light through (`transmissive`) receives from both sides. Without branches: all children of a node
// are weighed at once, in the lanes of a vector.
float light_node_importance(IN(LightNode) n, vec3 p, vec3 ng, uint transmissive) {
    vec3 to_node = n.centre - p;
    float true_d2 = dot(to_node, to_node);
    // Nearer than its radius, a node's distance says nothing about that of its lights.
    float d2 = max(max(true_d2, n.radius2), 1.0e-20f);
    // theta_b: how far a light's direction may be from the centre's; inside of the sphere anywhere.
    float cos_b = true_d2 > n.radius2 ? sqrt(max(0.0f, 1.0f - n.radius2 / true_d2)) : -1.0f;
    bool apart = true_d2 > 0.0f;
    vec3 wi = to_node * inversesqrt(apart ? true_d2 : 1.0f);
    wi.z = apart ? wi.z : 1.0f;

    float cos_w = -dot(n.w, wi);
    cos_w = n.two_sided != 0u ? abs(cos_w) : cos_w;
    // The smallest angle that a light's normal may have with the direction to p.
    float cos_emission = cos_of_difference(cos_of_difference(cos_w, n.cos_theta_o), cos_b);
    // The margin keeps a light alive that rounding alone would put beyond its edge.
    float margin = 1.0e-3f;
    float importance = n.phi * max(cos_emission, margin) / d2;
    importance = cos_emission < n.cos_theta_e - margin ? 0.0f : importance;
    float cos_i = dot(wi, ng);
    cos_i = transmissive != 0u ? abs(cos_i) : cos_i;
    float cos_incident = cos_of_difference(cos_i, cos_b);
    float received = cos_incident < -margin ? 0.0f : max(cos_incident, margin);
    importance *= dot(ng, ng) > 0.0f ? received : 1.0f;
    return min(importance, 1.0e30f);  // so that sums of them are numbers
}

#endif
