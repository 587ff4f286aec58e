// Colour of spatial data behind haze.
uniform vec3 haze_color;
VARYING vec4 v_color;
VARYING float v_haze;

void main() {
    FRAGMENT_COLOR = vec4(mix(v_color.rgb, haze_color, v_haze), v_color.a);
}
