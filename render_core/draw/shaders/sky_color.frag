// Sky above and ground below the visible horizon.
uniform float pixels_per_down;  // pixels by which the horizon is crossed per unit of the ray's down component
uniform vec3 zenith_color;
uniform vec3 horizon_color;
uniform vec3 ground_horizon_color;
uniform vec3 ground_color;

VARYING vec2 v_above;

// Towards the zenith, towards the ground's own colour, over the edge of a pixel at the horizon.
vec3 sky_shares() { return clamp(vec3(v_above.x * 1.6, v_above.x * -4.0, v_above.y * pixels_per_down + 0.5), 0.0, 1.0); }

vec3 sky_color() {
    vec3 shares = sky_shares();
    return mix(mix(ground_horizon_color, ground_color, shares.y), mix(horizon_color, zenith_color, shares.x), shares.z);
}

// Column of the table of colours, which has these ones in a row: see color_table.hpp.
float sky_column() { return dot(sky_shares(), vec3(127.0, -64.0, 64.0) / 255.0) + 64.0 / 255.0; }
