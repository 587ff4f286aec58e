// One triangle over the whole screen; every pixel gets its view ray.
VERTEX_IN vec2 position;

uniform vec2 half_tangent;   // of the field of view, right and up
uniform vec3 down_of_axes;   // down components of forward, right and down axis

VARYING vec2 v_tangent;      // right and down of the ray, per unit forward
VARYING float v_down;        // down component of the ray

void main() {
    v_tangent = vec2(position.x, -position.y) * half_tangent;
    v_down = down_of_axes.x + down_of_axes.y * v_tangent.x + down_of_axes.z * v_tangent.y;
    gl_Position = vec4(position, 1.0, 1.0);  // on the far plane: only where nothing else was drawn
}
