// Follows sky_color.frag.
void main() { FRAGMENT_COLOR = vec4(sky_color(), 1.0); }
