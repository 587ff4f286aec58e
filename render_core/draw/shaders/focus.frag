// Focus and context on the ground: how much of the focus a place is, what context looks like, and the rims. Numbers and their
// places in the table: draw/drawers/focus_ground.hpp. Follows ground_data.frag and surface_line.frag, followed by terrain.frag.
#ifdef FOCI
uniform sampler2D palette;     // its second row
uniform vec4 focus_parts;      // of each focus: 32 times the number of its parts that matter in this chunk, and the first one
uniform vec4 focus_look;       // of context: brightness, saturation; 1: without shades; metres a unit of the table
uniform float focus_least;     // no place of this chunk has a smaller degree
VARYING vec2 v_focus[FOCI];    // metres east and north of each focus' anchor

vec4 focus_texel(float at) { return TEXTURE2D(palette, vec2((at + 0.5) / 1024.0, 0.75)); }

float focus_number(float at) {
    vec3 code = floor(focus_texel(at).rgb * 255.0 + 0.5);
    return (dot(code, vec3(65536.0, 256.0, 1.0)) - 8388608.0) * focus_look.w;
}

vec2 focus_point(float at) { return vec2(focus_number(at), focus_number(at + 1.0)); }

vec2 steepest(vec2 way) { return abs(way.x) > abs(way.y) ? vec2(sign(way.x), 0.0) : vec2(0.0, sign(way.y)); }

// Distances from a rim, negative within, and how they rise a metre east and north. `kind`: 1 for a square, 1 for Chebyshev's.
vec3 rim_of_place(vec2 way, float radius, vec2 kind) {
#ifdef FOCUS_SQUARES
    if (kind.x > 0.5) {
        vec2 over = abs(way) - radius;
        if (kind.y > 0.5 || min(over.x, over.y) <= 0.0) return vec3(max(over.x, over.y), steepest(way));
        return vec3(length(over), sign(way) * normalize(over));
    }
#endif
    float away = length(way);
#ifdef FOCUS_CHEBYSHEV
    if (kind.y > 0.5 && away > radius) {
        vec2 far = abs(way);
        float apart = abs(far.x - far.y);
        if (max(far.x, far.y) - radius >= min(far.x, far.y)) return vec3(max(far.x, far.y) - radius, steepest(way));
        float corner = 0.5 * (far.x + far.y - sqrt(max(2.0 * radius * radius - apart * apart, 0.0)));
        vec2 touched = far - corner;
        return vec3(corner, sign(way) * touched / (touched.x + touched.y));
    }
#endif
    return vec3(away - radius, way / max(away, 1e-3));
}

#ifdef FOCUS_PATHS
vec3 rim_of_leg(vec2 way, vec2 along, float radius, float chebyshev) {
    vec2 across = vec2(-along.y, along.x);
    vec2 off = vec2(0.0);  // from the leg's nearest place, were it endless
#ifdef FOCUS_CHEBYSHEV
    if (chebyshev > 0.5) off = dot(way, across) / max(abs(across.x) + abs(across.y), 1e-3) * sign(across);
#endif
    float part = clamp(dot(way - off, along) / max(dot(along, along), 1e-3), 0.0, 1.0);
    vec2 from = way - along * part;
    if (chebyshev < 0.5) return vec3(length(from) - radius, from / max(length(from), 1e-3));
    vec2 rise = sign(dot(way, across)) * across / max(abs(across.x) + abs(across.y), 1e-3);
    return vec3(max(abs(from.x), abs(from.y)) - radius, part > 0.0 && part < 1.0 ? rise : steepest(from));
}
#endif

// The nearest of `parts` from the texel `at` on.
vec3 nearest_rim(vec2 ground, float at, float parts, float radius, vec3 kind) {
    vec3 nearest = vec3(1e9, 0.0, 1.0);
    for (int n = 0; n < 16; ++n) {
        if (float(n) >= parts) break;
        float from = at + 2.0 * float(n);
        vec2 way = ground - focus_point(from);
#ifdef FOCUS_PATHS
        vec3 rim = kind.x > 0.5 ? rim_of_leg(way, focus_point(from + 2.0) - ground + way, radius, kind.z)
                                : rim_of_place(way, radius, kind.yz);
#else
        vec3 rim = rim_of_place(way, radius, kind.yz);
#endif
        if (rim.x < nearest.x) nearest = rim;
    }
    return nearest;
}

// 1 within, then steps down to 0; the edge of a step is as wide as a pixel. Steps of 0: evenly over `step_m`.
float degree_beyond(float rim_m, float step_m, float steps, float reach_m) {
    float at = rim_m / step_m;
    float edge = floor(at + 0.5);
    float passed = clamp(edge + clamp((at - edge) * step_m / reach_m + 0.5, 0.0, 1.0), 0.0, steps);
    return steps < 0.5 ? 1.0 - clamp(at, 0.0, 1.0) : 1.0 - passed / steps;
}

#ifdef FOCUS_GRIDS
float focus_grid(vec2 ground, float spacing_m, float half_px, vec3 n, vec3 bare, vec3 ray, float pixel_m) {
    vec2 from_line = (fract(ground / spacing_m + 0.5) - 0.5) * spacing_m;
    float east_m = shorter_reach(vec3(1.0, 0.0, 0.0), n, bare, ray, pixel_m);
    float north_m = shorter_reach(vec3(0.0, 1.0, 0.0), n, bare, ray, pixel_m);
    vec2 sparse = clamp(spacing_m / (vec2(east_m, north_m) * half_px) * 0.1 - 0.4, 0.0, 1.0);
    return max(line_at(from_line.x, east_m, half_px) * sparse.x, line_at(from_line.y, north_m, half_px) * sparse.y);
}
#endif

// What a rim takes of the pixel; `halo`: 0 where it must not change colours.
float rim_cover(float border, float rim_m, float reach_m, float width_px, float halo) {
    float cover = 0.0;
#ifdef FOCUS_LINES
    if (border > 0.5 && border < 1.5) cover = line_at(rim_m, reach_m, 0.5 * width_px);
#endif
#ifdef FOCUS_HALOS
    float out_px = rim_m / reach_m;
    float fades = 1.0 - clamp(out_px / width_px, 0.0, 1.0);
    if (border > 1.5 && border < 2.5) cover = halo * clamp(out_px + 0.5, 0.0, 1.0) * fades * fades;
#endif
    return cover;
}

// 0..1. `bare`: normal of the mesh. `speaks`: colours of this place say something of their own, which is never changed. `border`: of all rims, times what
// they take.
float focus_degree(vec3 n, vec3 bare, vec3 ray, float pixel_m, bool speaks, out vec4 border) {
    float degree = focus_least;
#ifdef GROUND_DATA
    speaks = speaks || data_speaks();
#endif
    border = vec4(0.0);
    for (int k = 0; k < FOCI; ++k) {
        float parts = floor(focus_parts[k] / 32.0), at = 64.0 * float(k);
        if (parts < 0.5) continue;
        float first = focus_parts[k] - 32.0 * parts;
        vec4 kind = floor(focus_texel(at + 2.0) * 255.0 + 0.5);  // steps; 1 path, 2 square, 4 Chebyshev's; border; -
        vec3 shape = mod(floor(kind.g / vec3(1.0, 2.0, 4.0)), 2.0);
        vec4 look = focus_texel(at + 3.0);
        float width_px = look.a * 25.5;
        vec3 rim = nearest_rim(v_focus[k], at + 5.0 + 2.0 * first, parts, focus_number(at), shape);
        // Ground that is seen edge-on would have the rim far beside it.
        float reach_m = clamp(shorter_reach(vec3(rim.yz, 0.0), n, bare, ray, pixel_m), 1e-3, 10.0 * pixel_m);
        degree = max(degree, degree_beyond(rim.x, focus_number(at + 1.0), kind.r, reach_m));
        float cover = rim_cover(kind.b, rim.x, reach_m, width_px, speaks ? 0.0 : 1.0);
#ifdef FOCUS_GRIDS
        if (kind.b > 2.5) {
            float lines = focus_grid(v_focus[k], focus_number(at + 4.0), 0.5 * width_px, n, bare, ray, pixel_m);
            cover = max(lines * clamp(0.5 - rim.x / reach_m, 0.0, 1.0), line_at(rim.x, reach_m, 0.5 * width_px));
        }
#endif
        border = border * (1.0 - cover) + vec4(look.rgb, 1.0) * cover;
    }
    return speaks ? 1.0 : degree;
}

/// How much of what only detail shows is left.
float detail_at(float focused) { return 1.0 - focus_look.z * (1.0 - focused); }

// `plain`: without what only detail shows. All of it in focus, bit by bit.
vec3 in_context(vec3 color, vec3 plain, float focused) {
    if (focused >= 1.0) return color;
    vec3 outside = mix(color, plain, focus_look.z);
    outside = mix(vec3(dot(outside, vec3(0.2126, 0.7152, 0.0722))), outside, focus_look.y) * focus_look.x;
    return mix(outside, color, focused);
}
#endif

#ifdef FOCUS_BLUR
#ifndef FOCI
const float focused = 1.0;     // this chunk is in focus
const vec4 rim = vec4(0.0);
#endif
// As view_effects.frag reads it: a distance at which the blur is what the degree wants. What is sharp has the code 20.
float sharpness_code(float sharp) {
    return min(log2(1.0 + 1.0273678 / max(sharp, 1e-4)) / 13.0, 254.0 / 255.0);
}
#endif
