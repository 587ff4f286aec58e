// A triangle over the whole target.
VERTEX_IN vec2 position;

VARYING vec2 v_at;  // 0..1 from the left and the target's first row

void main() {
    v_at = 0.5 * position + 0.5;
    gl_Position = vec4(position, 0.0, 1.0);
}
