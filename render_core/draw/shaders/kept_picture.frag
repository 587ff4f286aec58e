// A part of a picture that was kept off screen.
uniform sampler2D picture;
uniform vec4 part;  // the part's lower left corner and its extents, 0..1

VARYING vec2 v_at;

void main() { FRAGMENT_COLOR = vec4(TEXTURE2D(picture, part.xy + v_at * part.zw).rgb, 1.0); }
