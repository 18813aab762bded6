// Smith's Lambda of isotropic distributions without a closed form, from masking_table.glsl. G1 is
// off by at most 0.005 for widths from 1e-4 to 1 and shapes from 0.1 to 10 (exponential power: 0.25
// to 4; shifted gamma: 0 to 3); outside, the table's edge is used. tests/statistics checks this.
#ifndef GP_SHADING_MICROFACET_TABULATED_LAMBDA_GLSL
#define GP_SHADING_MICROFACET_TABULATED_LAMBDA_GLSL
#include "shading/microfacet/abc.glsl"
#include "shading/microfacet/gtr.glsl"
#include "shading/microfacet/masking_table.glsl"

// The three entries around a place of a table's axis and what each counts: a parabola.
struct TablePlace {
    int first;
    vec3 weight;
};

TablePlace table_place(float where, int count) {
    float x = clamp(where, 0.0f, 1.0f) * float(count - 1);
    TablePlace p;
    p.first = clamp(int(x + 0.5f) - 1, 0, count - 3);
    float t = x - float(p.first);
    p.weight = vec3(0.5f * (t - 1.0f) * (t - 2.0f), t * (2.0f - t), 0.5f * t * (t - 1.0f));
    return p;
}

TablePlace table_no_place() {
    TablePlace p;
    p.first = 0;
    p.weight = vec3(1.0f, 0.0f, 0.0f);
    return p;
}

float table_row(int first, IN(TablePlace) p) {
    int i = first + p.first;
    return p.weight.x * masking_entry(i) + p.weight.y * masking_entry(i + 1)
         + p.weight.z * masking_entry(i + 2);
}

float table_plane(int first, int columns, IN(TablePlace) row, IN(TablePlace) column) {
    int i = first + row.first * columns;
    return row.weight.x * table_row(i, column) + row.weight.y * table_row(i + columns, column)
         + row.weight.z * table_row(i + 2 * columns, column);
}

float table_volume(int first, int rows, int columns, IN(TablePlace) slab, IN(TablePlace) row,
                   IN(TablePlace) column) {
    int size = rows * columns;
    int i = first + slab.first * size;
    return slab.weight.x * table_plane(i, columns, row, column)
         + slab.weight.y * table_plane(i + size, columns, row, column)
         + slab.weight.z * table_plane(i + 2 * size, columns, row, column);
}

// |z| over the length of the projection: 1 / tan of the direction.
float cotangent(vec3 w) {
    return abs(w.z) * inversesqrt(max(w.x * w.x + w.y * w.y, 1.0e-30f));
}

// The place of a width between `low` and 1, spaced by its power.
float table_width_place(float width, float low, float power) {
    float first = pow(low, power);
    // From low = 1 on all widths are one.
    return first > 0.9999f ? 1.0f : (pow(width, power) - first) / (1.0f - first);
}

// The place of a shape between 0.1 and 10, densest around 1.25, where lobes change most.
float table_shape_place(float shape) {
    float x = (shape - 1.25f) * 2.5f;
    float e = abs(x) + sqrt(x * x + 1.0f);
    float inverse_sinh = x < 0.0f ? -log(e) : log(e);
    return (inverse_sinh + 1.77815889f) * 0.179947625f;
}

// u = c / (c + m), by which the tables are sorted; m is the slope with which Lambda begins.
float table_cotangent_place(float c, float mean_slope) {
    return max(c / (c + mean_slope), 1.0e-30f);
}

float lambda_from_table(float u, float entry) {
    return 1.0f / min(u * entry, 1.0f) - 1.0f;
}

float gtr_lambda(vec3 w, float alpha, float gamma) {
    float width = inversesqrt(PI * gtr_peak(alpha, gamma));
    float low = inversesqrt(PI * gtr_peak(1.0e-4f, gamma));
    float at_width = table_width_place(width, low, 0.2f);
    float at_shape = table_shape_place(gamma);
    float slope = width * exp(table_plane(MASKING_GTR_SLOPE, 33, table_place(at_width, 17),
                                          table_place(at_shape, 33)));
    float u = table_cotangent_place(cotangent(w), slope);
    return lambda_from_table(u, table_volume(MASKING_GTR, 13, 17, table_place(at_width, 9),
                                             table_place(at_shape, 13), table_place(u, 17)));
}

float abc_lambda(vec3 w, float alpha, float c) {
    float at_width = table_width_place(alpha, 1.0e-4f, 0.2f);
    float at_shape = table_shape_place(c);
    float slope = alpha * exp(table_plane(MASKING_ABC_SLOPE, 33, table_place(at_width, 17),
                                          table_place(at_shape, 33)));
    float u = table_cotangent_place(cotangent(w), slope);
    return lambda_from_table(u, table_volume(MASKING_ABC, 13, 17, table_place(at_width, 9),
                                             table_place(at_shape, 13), table_place(u, 17)));
}

float shifted_gamma_lambda(vec3 w, float alpha, float p) {
    float at_width = table_width_place(alpha, 1.0e-4f, 0.1f);
    float at_shape = p / 3.0f;
    float slope = alpha * exp(table_plane(MASKING_SGD_SLOPE, 17, table_place(at_width, 17),
                                          table_place(at_shape, 17)));
    float u = table_cotangent_place(cotangent(w), slope);
    return lambda_from_table(u, table_volume(MASKING_SGD, 9, 13, table_place(at_width, 7),
                                             table_place(at_shape, 9), table_place(u, 13)));
}

float blinn_phong_lambda(vec3 w, float alpha) {
    float slope = alpha * exp(table_row(MASKING_BLINN_PHONG_SLOPE, table_place(alpha, 9)));
    float u = table_cotangent_place(cotangent(w), slope);
    return lambda_from_table(u, table_plane(MASKING_BLINN_PHONG, 17, table_place(alpha, 9),
                                            table_place(u, 17)));
}

// Here the mean slope has a closed form: Gamma(3 / (2 p)) / (pi Gamma(1 / p)).
float exponential_power_lambda(vec3 w, float alpha, float p) {
    float slope = alpha * INV_PI * exp(log_gamma(1.5f / p) - log_gamma(1.0f / p));
    float u = table_cotangent_place(cotangent(w), slope);
    float at_shape = (p / (1.0f + p) - 0.2f) / 0.6f;
    return lambda_from_table(u, table_plane(MASKING_EXPONENTIAL_POWER, 25,
                                            table_place(at_shape, 9), table_place(u, 25)));
}

#endif
