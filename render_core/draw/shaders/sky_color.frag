// Sky above and ground below the visible horizon. Follows unknown_ground.frag; with AIR it follows air.frag.
uniform float pixels_per_down;  // pixels by which the horizon is crossed per unit of the ray's down component
uniform vec3 zenith_color;
uniform vec3 horizon_color;
uniform vec3 ground_horizon_color;
uniform vec3 ground_color;
uniform float ground_hatch;     // 1 where the ground is not known, else 0

VARYING vec2 v_above;
VARYING vec2 v_at;
#ifdef AIR
uniform vec2 half_tangent;      // as in screen.vert: rays go forward, right, down
uniform vec3 air_horizon[2];    // light of the sky just over the horizon, by molecules and by aerosol, before phases
#endif

// Towards the zenith, towards the ground's own colour, over the edge of a pixel at the horizon.
vec3 sky_shares() { return clamp(vec3(v_above.x * 1.6, v_above.x * -4.0, v_above.y * pixels_per_down + 0.5), 0.0, 1.0); }

// What the ground keeps of its color; within a degree of the horizon, where haze hides it, all.
float ground_hatch_here() {
    vec3 shares = sky_shares();
    return 1.0 - ground_hatch * min(16.0 * shares.y, 1.0) * (1.0 - shares.z) * (1.0 - hatch_at(gl_FragCoord.xy));
}

#ifdef AIR
vec3 view_ray() { return normalize(vec3(1.0, (v_at * 2.0 - 1.0) * vec2(half_tangent.x, -half_tangent.y))); }

// What is seen behind the air, and its column of the table.
struct BehindAir {
    vec3 plain, lit;  // without air; of that what air shows
    float column;
    float sky;        // share of the sky in a pixel of the horizon
};
BehindAir sky_behind_air(vec3 ray) {
    vec3 shares = sky_shares();
    vec3 ground = mix(ground_horizon_color, ground_color, shares.y), sky = mix(horizon_color, zenith_color, shares.x);
    // The sea's distance, as far as the horizon.
    float height_m = max(air_sun.w, 1.0), down = -dot(ray, air_up.xyz);
    float sea_m = height_m / max(down, 0.5 * max(air_up.w, 1e-4));
    vec3 plain = mix(ground, sky, shares.z);
    return shares.z < 1.0 ? BehindAir(plain, ground, air_column(sea_m), shares.z) : BehindAir(plain, vec3(0.0), kAirOut, 0.0);
}

// `share` of the air's effect.
vec3 color_behind_air(BehindAir seen, vec3 ray, float share) {
    if (air_look.x <= 0.0) return seen.plain;
    vec2 phases = air_phases(ray);
    vec3 horizon = min(sqrt(phases.x * air_horizon[0] + phases.y * air_horizon[1]), vec3(1.0));
    return mix(seen.plain, mix(behind_air(seen.lit, ray, seen.column), horizon, seen.sky), share);
}

vec3 sky_color() {
    vec3 ray = view_ray();
    return color_behind_air(sky_behind_air(ray), ray, air_look.x) * ground_hatch_here();
}
#else
vec3 sky_color() {
    vec3 shares = sky_shares();
    vec3 ground = mix(ground_horizon_color, ground_color, shares.y), sky = mix(horizon_color, zenith_color, shares.x);
    return mix(ground, sky, shares.z) * ground_hatch_here();
}
#endif

// Column of the table of colours, which has these ones in a row: see color_table.hpp.
float sky_column() { return dot(sky_shares(), vec3(127.0, -64.0, 64.0) / 255.0) + 64.0 / 255.0; }
