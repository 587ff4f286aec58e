// A grid over the whole screen, fine enough that what varies smoothly over it may be computed at its corners: the view ray's
// height over the visible horizon, which lies below the horizontal by the dip.
VERTEX_IN vec2 position;

uniform vec2 half_tangent;   // of the field of view, right and up
uniform vec3 down_of_axes;   // down components of forward, right and down axis
uniform float sine_of_dip;

VARYING vec2 v_at;           // place in an off-screen picture, 0..1 from the bottom left
VARYING vec2 v_above;        // above the horizon: sine of the angle, and the same for a ray of unit length forward

void main() {
    v_at = 0.5 * position + 0.5;
    vec2 tangent = vec2(position.x, -position.y) * half_tangent;
    float down = down_of_axes.x + down_of_axes.y * tangent.x + down_of_axes.z * tangent.y;
    float ray_length = sqrt(1.0 + dot(tangent, tangent));
    float above = sine_of_dip * ray_length - down;
    v_above = vec2(above / ray_length, above);
    gl_Position = vec4(position, 1.0, 1.0);  // on the far plane: only where nothing else was drawn
}
