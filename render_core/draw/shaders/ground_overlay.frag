// Uncertainty of the field on the ground by something that is added to its colours. Follows ground_data.frag; what is unknown counts
// as the least sure, and the stripes of ground_data.frag stay. Followed by terrain.frag.
#ifdef DATA_OVERLAY
uniform vec4 data_overlay;       // strength; levels, 0 for continuous; threshold; width of the finest mesh, m
uniform vec3 data_overlay_color;

float reach_of(vec3 axis, vec3 n, vec3 ray, float facing, float pixel_m);
float line_at(float distance_m, float pixel_m, float half_width_px);

#ifdef DATA_FOG
// Clouds of some fifty pixels; two sizes cross-fade with the distance. The mean of their cover is the level's.
float data_fog(float level, vec2 ground, float pixel_m) {
    float octave = log2(max(pixel_m, 0.01)) + 4.5;
    vec2 place = ground / exp2(floor(octave));
    float puff = mix(data_relief(place).x, data_relief(0.5 * place).x, fract(octave));
    return clamp(data_overlay.x * data_gradation(level, data_overlay.y) * (0.5 + puff), 0.0, 1.0);
}
#endif

#ifdef DATA_MESH
// Lines of one family; they fade before they would stand closer than a few pixels.
float data_lines(float place_m, float apart_m, float reach_m) {
    float away_m = abs(fract(place_m / apart_m + 0.5) - 0.5) * apart_m;
    return line_at(away_m, reach_m, 0.6) * clamp(apart_m / reach_m * 0.2 - 0.8, 0.0, 1.0);
}

// Triangles whose width doubles from one gradation to the next.
float data_mesh(float level, vec3 n, vec3 ray, float facing, vec2 ground, float pixel_m) {
    float gradations = data_overlay.y > 0.5 ? data_overlay.y : 5.0;
    float width_m = data_overlay.w * exp2(floor(min(level, 0.9999) * gradations));
    float across = data_lines(ground.x, width_m, reach_of(vec3(1.0, 0.0, 0.0), n, ray, facing, pixel_m));
    float down = data_lines(ground.y, width_m, reach_of(vec3(0.0, 1.0, 0.0), n, ray, facing, pixel_m));
    float aslant = data_lines((ground.x + ground.y) * 0.70710678, width_m * 0.70710678,
                              reach_of(vec3(0.70710678, -0.70710678, 0.0), n, ray, facing, pixel_m));
    return data_overlay.x * max(max(across, down), aslant);
}
#endif

#if defined(DATA_CONTOUR) || defined(DATA_HALO)
uniform vec4 data_window;
uniform vec4 stroke_window;

float data_level_of(vec2 post) { return min(data_texel(post).b * (255.0 / 254.0), 1.0); }

// Pixels from the place where the level is the threshold, along its steepest way; positive where it is less sure. Far off where the
// level hardly changes, so that no plain of just this level is a blot.
float data_from_threshold(vec3 n, vec3 ray, float facing, float pixel_m) {
    vec2 cell = floor(v_data);
    vec2 part = v_data - cell;
    float nw = data_level_of(cell);
    float east = data_level_of(cell + vec2(1.0, 0.0)) - nw;
    float south = data_level_of(cell + vec2(0.0, 1.0)) - nw;
    float twist = data_level_of(cell + vec2(1.0, 1.0)) - nw - east - south;
    float level = nw + east * part.x + south * part.y + twist * part.x * part.y;
    vec2 rise = vec2(east + twist * part.y, south + twist * part.x);  // a post
    vec2 rise_m = rise * data_window.xy / stroke_window.xy;
    float steep = max(length(rise_m), 1e-9);
    float reach_m = reach_of(vec3(rise_m.x, -rise_m.y, 0.0) / steep, n, ray, facing, pixel_m);
    float apart = (level - data_overlay.z) / (steep * reach_m);
    return length(rise) < 0.006 ? 1e4 : apart;
}
#endif

// Of lines over light ground: dark, that they are seen.
vec3 data_ink(vec3 ground) { return data_overlay_color * (dot(ground, vec3(0.2126, 0.7152, 0.0722)) > 0.4 ? 0.15 : 1.0); }

vec3 with_overlay(vec3 color, vec4 data, vec3 n, vec3 ray, float facing, vec2 ground, float pixel_m) {
    if (data.z <= 0.0) return color;
#if defined(DATA_FOG)
    return mix(color, data_overlay_color, data_fog(min(data.y, 1.0), ground, pixel_m));
#elif defined(DATA_MESH)
    return mix(color, data_ink(color), data_mesh(min(data.y, 1.0), n, ray, facing, ground, pixel_m));
#else
    float away = abs(data_from_threshold(n, ray, facing, pixel_m));
    // A dark rim sets either off from whatever is under it.
#ifdef DATA_HALO
    color = mix(color, 0.15 * data_overlay_color, data_overlay.x * 0.7 * exp(-0.004 * away * away));
    return mix(color, data_overlay_color, data_overlay.x * exp(-0.04 * away * away));
#else
    color = mix(color, 0.15 * data_overlay_color, data_overlay.x * clamp(3.5 - away, 0.0, 1.0));
    return mix(color, data_overlay_color, data_overlay.x * clamp(2.0 - away, 0.0, 1.0));
#endif
#endif
}
#endif
