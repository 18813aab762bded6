// Where the tables of microfacet/albedo_tables.glsl have their nodes; the program that bakes them
// reads this file too.
#ifndef GP_SHADING_MICROFACET_ALBEDO_GRID_GLSL
#define GP_SHADING_MICROFACET_ALBEDO_GRID_GLSL

#define ALBEDO_TABLE_COSINES 20
#define ALBEDO_TABLE_WIDTHS 20
#define ALBEDO_AVERAGE_WIDTHS 39

// The rows: even in sqrt(alpha), closer where the surface is smooth. The first row stands for
// alpha = 0, where every cosine but 0 would have the same column: it is baked at 1e-4.
float albedo_row(float alpha) {
    return sqrt(clamp(alpha, 0.0f, 1.0f));
}

// The columns: half of them below a cosine of about 2 alpha, where albedo drops towards grazing
// angles; with correlated masking GGX rises again at the very end, like a root.
float albedo_column(float cos_o, float alpha, bool root) {
    float x = cos_o * (1.0f + 2.0f * alpha) / max(cos_o + 2.0f * alpha, 1.0e-20f);
    return root ? sqrt(x) : x;
}

// The inverse, for baking.
float albedo_column_cosine(float column, float alpha, bool root) {
    float x = (root ? column * column : column) / (1.0f + 2.0f * alpha);
    return 2.0f * alpha * x / (1.0f - x);
}

#endif
