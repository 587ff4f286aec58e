// Leaves of a draw what lies in its part of a magnifier's plane. Before the program's own text; follows magnified.vert.
uniform vec3 lens_part[12];  // 8 edges, 3 limits: metres within = dot((east, north, 1), edge); 1 for what lies within the edges,
                             // -1 for what does not; so many metres over them; the scale changes at 0 none, 1 all, 2 the first
VARYING vec2 v_lens;

/// The edge at which the scale changes, and metres to it.
vec3 leave_other_parts() {
    vec3 at = vec3(v_lens, 1.0), nearest = lens_part[0];
    float within = dot(nearest, at);
    for (int n = 1; n < 8; ++n) {
        float there = dot(lens_part[n], at);
        if (there < within) nearest = lens_part[n];
        within = min(within, there);
    }
    float inside = within * lens_part[11].x;
    for (int n = 8; n < 11; ++n) inside = min(inside, dot(lens_part[n], at));
    if (inside < -lens_part[11].y) discard;
    vec3 edge = lens_part[11].z > 1.5 ? lens_part[0] : nearest;
    return lens_part[11].z > 0.5 ? vec3(edge.xy, dot(edge, at)) : vec3(1.0, 0.0, 1e9);
}
