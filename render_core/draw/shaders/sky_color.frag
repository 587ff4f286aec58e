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
#endif

// Towards the zenith, towards the ground's own colour, over the edge of a pixel at the horizon.
vec3 sky_shares() { return clamp(vec3(v_above.x * 1.6, v_above.x * -4.0, v_above.y * pixels_per_down + 0.5), 0.0, 1.0); }

// What the ground keeps of its color; within a degree of the horizon, where haze hides it, all.
float ground_hatch_here() {
    vec3 shares = sky_shares();
    return 1.0 - ground_hatch * min(16.0 * shares.y, 1.0) * (1.0 - shares.z) * (1.0 - hatch_at(gl_FragCoord.xy));
}

vec3 sky_color() {
    vec3 shares = sky_shares();
    vec3 ground = mix(ground_horizon_color, ground_color, shares.y), sky = mix(horizon_color, zenith_color, shares.x);
#ifdef AIR
    if (air_look.x > 0.0) {
        vec3 ray = normalize(vec3(1.0, (v_at * 2.0 - 1.0) * vec2(half_tangent.x, -half_tangent.y)));
        if (shares.z > 0.0) sky = mix(sky, min(sqrt(air_light(ray, kAirOut)), vec3(1.0)), air_look.x);
        if (shares.z < 1.0) {
            // The sea's distance, as far as the horizon.
            float height_m = max(air_sun.w, 1.0), down = -dot(ray, air_up.xyz);
            ground = through_air(ground, ray, height_m / max(down, 0.5 * max(air_up.w, 1e-4)));
        }
    }
#endif
    return mix(ground, sky, shares.z) * ground_hatch_here();
}

// Column of the table of colours, which has these ones in a row: see color_table.hpp.
float sky_column() { return dot(sky_shares(), vec3(127.0, -64.0, 64.0) / 255.0) + 64.0 / 255.0; }
