// Colour of spatial data behind haze.
uniform vec3 haze_color;
uniform float haze_per_m;  // 1 / distance, 0 for none
VARYING vec4 v_color;
VARYING vec3 v_eye;

void main() {
    float haze = 1.0 - exp(-length(v_eye) * haze_per_m);
    FRAGMENT_COLOR = vec4(mix(v_color.rgb, haze_color, haze), v_color.a);
}
