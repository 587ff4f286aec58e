// What white becomes; the picture is multiplied with it by blending.
uniform vec3 white;

void main() { FRAGMENT_COLOR = vec4(white, 1.0); }
