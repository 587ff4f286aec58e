// Sky above and ground below the visible horizon.
uniform float pixels_per_down;  // pixels by which the horizon is crossed per unit of the ray's down component
uniform vec3 zenith_color;
uniform vec3 horizon_color;
uniform vec3 ground_horizon_color;
uniform vec3 ground_color;

VARYING vec2 v_above;

vec3 sky_color() {
    vec3 sky = mix(horizon_color, zenith_color, clamp(v_above.x * 1.6, 0.0, 1.0));
    vec3 ground = mix(ground_horizon_color, ground_color, clamp(v_above.x * -4.0, 0.0, 1.0));
    return mix(ground, sky, clamp(v_above.y * pixels_per_down + 0.5, 0.0, 1.0));
}
