// Colour of spatial data behind haze.
uniform vec3 haze_color;
uniform float haze_per_m;  // 1 / distance, 0 for none
#ifdef FADES_NEAR
uniform vec2 near_fade;    // m from the eye where it begins to be seen; share a metre from there on
#endif
VARYING vec4 v_color;
VARYING vec3 v_eye;

void main() {
    float distance_m = length(v_eye), shown = 1.0;
#ifdef FADES_NEAR
    shown = clamp((distance_m - near_fade.x) * near_fade.y, 0.0, 1.0);
    if (shown <= 0.0) discard;  // what is not seen hides nothing
#endif
    float haze = 1.0 - exp(-distance_m * haze_per_m);
    FRAGMENT_COLOR = vec4(mix(v_color.rgb, haze_color, haze), v_color.a * shown);
}
