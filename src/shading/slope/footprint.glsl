// The footprint of a pixel on a surface, from the changes of a position along the pixel's two axes.
#ifndef GP_SHADING_SLOPE_FOOTPRINT_GLSL
#define GP_SHADING_SLOPE_FOOTPRINT_GLSL

// The ellipse of a a^T + b b^T, which is the same for every pair of axes of one pixel.
struct FootprintEllipse {
    vec2 axis;    // of the long one, unit length
    float major;  // lengths, those of a and b where they are at right angles
    float minor;
};

// Within +-limit; 0 where there is no number.
float footprint_bounded(float x, float limit) {
    return x >= -limit ? min(x, limit) : x < -limit ? -limit : 0.0f;
}

vec2 footprint_bounded2(vec2 v, float limit) {
    return vec2(footprint_bounded(v.x, limit), footprint_bounded(v.y, limit));
}

// Unit length, along the larger axis of the symmetric matrix ((m + d, xy), (xy, m - d)), d being
// half_difference; radius: the length of (d, xy). Where that is 0, any axis would do.
vec2 principal_axis(float half_difference, float xy, float radius) {
    // Of the two ways to write the direction, the one that does not cancel.
    vec2 axis = half_difference >= 0.0f ? vec2(half_difference + radius, xy)
                                        : vec2(xy, radius - half_difference);
    float l = length(axis);
    return l > 0.0f ? axis / l : vec2(1.0f, 0.0f);
}

// The matrix a a^T + b b^T itself: ((half_sum + half_difference, xy), (xy, half_sum -
// half_difference)) with the eigenvalues half_sum +- radius.
struct FootprintSpread {
    float half_sum;
    float half_difference;
    float xy;
    float radius;
    float area;  // of a and b, the root of the determinant, which does not cancel
};

// Any input: what is not finite counts as nothing, and nothing is longer than 1e9.
FootprintSpread footprint_spread(vec2 change_0, vec2 change_1) {
    vec2 a = footprint_bounded2(change_0, 1.0e9f);
    vec2 b = footprint_bounded2(change_1, 1.0e9f);
    FootprintSpread f;
    f.xy = a.x * a.y + b.x * b.y;
    f.half_sum = 0.5f * (a.x * a.x + b.x * b.x + a.y * a.y + b.y * b.y);
    f.half_difference = 0.5f * (a.x * a.x + b.x * b.x - a.y * a.y - b.y * b.y);
    f.radius = sqrt(f.half_difference * f.half_difference + f.xy * f.xy);
    f.area = abs(a.x * b.y - a.y * b.x);
    return f;
}

FootprintEllipse footprint_ellipse(vec2 change_0, vec2 change_1) {
    FootprintSpread f = footprint_spread(change_0, change_1);
    FootprintEllipse e;
    e.major = sqrt(f.half_sum + f.radius);
    e.minor = e.major > 0.0f ? min(f.area / e.major, e.major) : 0.0f;
    e.axis = principal_axis(f.half_difference, f.xy, f.radius);
    return e;
}

#endif
