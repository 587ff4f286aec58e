// One triangle over the whole screen.
VERTEX_IN vec2 position;

VARYING vec2 v_at;

void main() {
    v_at = position * 0.5 + 0.5;
    gl_Position = vec4(position, 0.0, 1.0);
}
