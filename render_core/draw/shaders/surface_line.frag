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
