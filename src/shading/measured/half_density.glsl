// Sampling what is only known as a table: a density of half vectors for each of some views, made
// from the data by scene/measured_brdf.cpp. Highlights keep their place among half vectors while
// the view turns, so few views are enough; a wi follows by reflection.
//
// The density is linear in 1 - cos theta_h and in the half vector's azimuth phi to the viewer's,
// of which both sides are alike; between two views it is a mixture of theirs. Everything is
// continuous, and exact: the density is what is tabulated, not the data.
//
// A view's part of the table is, behind all the cells: densities (a row of azimuths for each of the
// theta_h), the rows' integrals over the azimuth, the share of all up to each row, the albedo.
#ifndef GP_SHADING_MEASURED_HALF_DENSITY_GLSL
#define GP_SHADING_MEASURED_HALF_DENSITY_GLSL
#include "shading/measured/merl.glsl"

#define HALF_DENSITY_VIEWS 16
#define HALF_DENSITY_ROWS 64
#define HALF_DENSITY_AZIMUTHS 17
#define HALF_DENSITY_INTEGRALS 1088u    // 64 * 17
#define HALF_DENSITY_SHARES 1152u       // … + 64
#define HALF_DENSITY_ALBEDO 1216u       // … + 64
#define HALF_DENSITY_VIEW_WORDS 1219u   // … + 3
#define MEASURED_WORDS 4393504u         // 3 * 1458000 + 16 * 1219: 17.5 MB, and 78 kB to sample by

// Where a number lies between the nodes of a table.
struct TableSpan {
    int first;   // the node below
    float part;  // 0 at it, 1 at the next
};

TableSpan table_span(float at, int count) {
    TableSpan s;
    s.first = clamp(int(at), 0, count - 2);
    s.part = clamp(at - float(s.first), 0.0f, 1.0f);
    return s;
}

// Views are evenly spaced in theta.
TableSpan half_density_view(float cos_o) {
    float sine = sqrt(max((1.0f - cos_o) * (1.0f + cos_o), 0.0f));
    return table_span(4.0f * float(HALF_DENSITY_VIEWS - 1) * turns_from_vector(sine, cos_o),
                      HALF_DENSITY_VIEWS);
}

// 1 - cos theta_h of a row. Nearly even in the square root of theta_h, as the cells are.
float half_density_height(int row) {
    float t = float(row) / float(HALF_DENSITY_ROWS - 1);
    return t * t * t * t;
}

// Which rows a half vector lies between. Linear in the height, as half_density_sample_row has it.
TableSpan half_density_row(float height) {
    TableSpan s = table_span(float(HALF_DENSITY_ROWS - 1) * sqrt(sqrt(height)), HALF_DENSITY_ROWS);
    float low = half_density_height(s.first);
    s.part = clamp((height - low) / (half_density_height(s.first + 1) - low), 0.0f, 1.0f);
    return s;
}

uint half_density_base(int view) {
    return 3u * MERL_CELLS + uint(view) * HALF_DENSITY_VIEW_WORDS;
}

float half_density_node(uvec2 table, int view, int row, int azimuth) {
    return table_float(table, half_density_base(view)
                            + uint(row * HALF_DENSITY_AZIMUTHS + azimuth));
}

float half_density_integral(uvec2 table, int view, int row) {
    return table_float(table, half_density_base(view) + HALF_DENSITY_INTEGRALS + uint(row));
}

float half_density_share(uvec2 table, int view, int row) {
    return table_float(table, half_density_base(view) + HALF_DENSITY_SHARES + uint(row));
}

// The light that a white light all around returns to a view.
vec3 half_density_albedo(uvec2 table, float cos_o) {
    TableSpan view = half_density_view(cos_o);
    uint low = half_density_base(view.first) + HALF_DENSITY_ALBEDO;
    uint high = half_density_base(view.first + 1) + HALF_DENSITY_ALBEDO;
    vec3 a = vec3(table_float(table, low), table_float(table, low + 1u),
                  table_float(table, low + 2u));
    vec3 b = vec3(table_float(table, high), table_float(table, high + 1u),
                  table_float(table, high + 2u));
    return mix(a, b, view.part);
}

// The viewer's azimuth; any where the viewer looks along the normal.
vec2 half_density_azimuth(vec3 wo) {
    float largest = max(abs(wo.x), abs(wo.y));
    vec2 xy = vec2(wo.x, wo.y) / max(largest, 1.0e-37f);
    return largest > 0.0f ? normalize(xy) : vec2(1.0f, 0.0f);
}

// Per solid angle of the half vector; unit length, above the horizon.
float half_density_pdf(uvec2 table, vec3 wo, vec3 wm) {
    TableSpan view = half_density_view(wo.z);
    TableSpan row = half_density_row((wm.x * wm.x + wm.y * wm.y) / (1.0f + wm.z));
    vec2 to = half_density_azimuth(wo);
    float phi = turns_from_vector(abs(wm.y * to.x - wm.x * to.y), wm.x * to.x + wm.y * to.y);
    TableSpan column = table_span(2.0f * float(HALF_DENSITY_AZIMUTHS - 1) * phi,
                                  HALF_DENSITY_AZIMUTHS);
    float sum = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
        int v = corner >> 2;
        int r = (corner >> 1) & 1;
        int c = corner & 1;
        sum += half_density_node(table, view.first + v, row.first + r, column.first + c)
             * (v == 1 ? view.part : 1.0f - view.part) * (r == 1 ? row.part : 1.0f - row.part)
             * (c == 1 ? column.part : 1.0f - column.part);
    }
    return sum;
}

// The place in [0, 1] up to which a density that goes linearly from a to b has the integral `area`,
// at most (a + b) / 2. In this form nothing cancels, and either may be 0.
float linear_density_place(float a, float b, float area) {
    float root = sqrt(max(a * a + 2.0f * (b - a) * area, 0.0f));
    return clamp(2.0f * area / max(a + root, 1.0e-37f), 0.0f, 1.0f);
}

// The last row whose share lies below u.
int half_density_find_row(uvec2 table, int view, float u) {
    int low = 0;
    int high = HALF_DENSITY_ROWS - 1;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (half_density_share(table, view, middle) <= u) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

// An azimuth of a row, in turns; from 0 to 0.5 and to the other side by halves of u.
float half_density_sample_azimuth(uvec2 table, int view, int row, float u) {
    bool left = u < 0.5f;
    float rest = (left ? 2.0f * u : 2.0f * u - 1.0f);
    // The integrals of a row count both sides: half of it is one, in intervals of pi / 16.
    float wanted = rest * half_density_integral(table, view, row)
                 * (0.5f * float(HALF_DENSITY_AZIMUTHS - 1) * INV_PI);
    float a = half_density_node(table, view, row, 0);
    float place = 0.0f;
    for (int k = 0; k < HALF_DENSITY_AZIMUTHS - 1; ++k) {
        float b = half_density_node(table, view, row, k + 1);
        float area = 0.5f * (a + b);
        place = float(k) + linear_density_place(a, b, min(wanted, area));
        if (wanted < area) {
            break;
        }
        wanted -= area;
        a = b;
    }
    float turns = place / (2.0f * float(HALF_DENSITY_AZIMUTHS - 1));
    return left ? -turns : turns;
}

// A half vector with the density half_density_pdf; u_view chooses between two views.
vec3 half_density_sample(uvec2 table, vec3 wo, float u_view, vec2 u) {
    TableSpan views = half_density_view(wo.z);
    int view = views.first + (u_view < views.part ? 1 : 0);
    int row = half_density_find_row(table, view, u.x);
    float low = half_density_height(row);
    float step = half_density_height(row + 1) - low;
    float a = half_density_integral(table, view, row);
    float b = half_density_integral(table, view, row + 1);
    float area = (u.x - half_density_share(table, view, row)) / step;
    float place = linear_density_place(a, b, clamp(area, 0.0f, 0.5f * (a + b)));
    float height = low + place * step;
    // The azimuth's density there is a mixture of those of the two rows.
    float upper = lobe_share(place * b, (1.0f - place) * a);
    bool next = u.y < upper;
    float rest = next ? u.y / upper : (u.y - upper) / (1.0f - upper);
    SinCos phi = sincos_turns(half_density_sample_azimuth(table, view, next ? row + 1 : row,
                                                          min(rest, ONE_MINUS_EPSILON)));
    vec2 to = half_density_azimuth(wo);
    float sine = sqrt(height * (2.0f - height));
    return vec3(sine * (phi.c * to.x - phi.s * to.y), sine * (phi.c * to.y + phi.s * to.x),
                1.0f - height);
}

#endif
