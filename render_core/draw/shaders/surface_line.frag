// How wide lines are on a surface: of the terrain and of data alike.

/// Metres along `axis` (a unit vector) from a pixel to the next across the surface, at most; `facing`: cosine between the
/// normal and the way to the eye.
float reach_of(vec3 axis, vec3 n, vec3 ray, float facing, float pixel_m) {
    return pixel_m * length(axis + n * (dot(ray, axis) / facing));
}

/// Coverage by a line of the surface grid; lines fade before they would stand closer than a few pixels.
float grid_line(float from_line_m, float spacing_m, float reach_m) {
    return clamp(1.3 - abs(from_line_m) / reach_m, 0.0, 1.0) * clamp(spacing_m / reach_m * 0.2 - 0.8, 0.0, 1.0);
}

/// Mesh and map do not know the same slope. The shorter of both reaches: with the longer one lines would run into blots.
float shorter_reach(vec3 axis, vec3 n, vec3 bare, vec3 ray, float pixel_m) {
    return min(reach_of(axis, n, ray, max(-dot(n, ray), 0.03), pixel_m),
               reach_of(axis, bare, ray, max(-dot(bare, ray), 0.03), pixel_m));
}

/// A line's coverage at a distance from its middle.
float line_at(float distance_m, float pixel_m, float half_width_px) {
    return clamp(half_width_px + 0.5 - abs(distance_m) / pixel_m, 0.0, 1.0);
}
