// Flat symbology in screen pixels, y down (quad_batch.hpp).
VERTEX_IN vec2 position;
VERTEX_IN vec2 uv;
VERTEX_IN vec2 extent;
VERTEX_IN vec4 color;

uniform vec2 clip_per_pixel;  // 2 / width, 2 / height

VARYING vec2 v_uv;
VARYING vec2 v_extent;
VARYING vec4 v_color;

void main() {
    v_uv = uv;
    v_extent = extent;
    v_color = color;
    gl_Position = vec4(position.x * clip_per_pixel.x - 1.0, 1.0 - position.y * clip_per_pixel.y, 0.0, 1.0);
}
