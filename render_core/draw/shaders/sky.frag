// Sky above and ground below the visible horizon, which lies below the horizontal by the dip.
uniform float sine_of_dip;
uniform float pixels_per_down;  // pixels by which the horizon is crossed per unit of the ray's down component
uniform vec3 zenith_color;
uniform vec3 horizon_color;
uniform vec3 ground_horizon_color;
uniform vec3 ground_color;

VARYING vec2 v_tangent;
VARYING float v_down;

void main() {
    float ray_length = sqrt(1.0 + dot(v_tangent, v_tangent));
    float above = sine_of_dip * ray_length - v_down;
    float sine = above / ray_length;
    vec3 sky = mix(horizon_color, zenith_color, clamp(sine * 1.6, 0.0, 1.0));
    vec3 ground = mix(ground_horizon_color, ground_color, clamp(-sine * 4.0, 0.0, 1.0));
    FRAGMENT_COLOR = vec4(mix(ground, sky, clamp(above * pixels_per_down + 0.5, 0.0, 1.0)), 1.0);
}
