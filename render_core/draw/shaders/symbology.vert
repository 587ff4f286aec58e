// Flat symbology in screen pixels, y down (quad_batch.hpp).
VERTEX_IN vec2 position;
VERTEX_IN vec2 uv;
VERTEX_IN vec2 extent;
VERTEX_IN vec4 color;
#ifdef AMONG_TERRAIN
VERTEX_IN float distance_m;
#endif

uniform vec2 clip_per_pixel;  // 2 / width, 2 / height
#ifdef AMONG_TERRAIN
uniform vec2 depth;       // of the perspective: scale, offset
uniform float parting_m;  // where two ranges of depth part; 0: there is one
#endif

VARYING vec2 v_uv;
VARYING vec2 v_extent;
VARYING vec4 v_color;
#ifdef AMONG_TERRAIN
VARYING float v_parting;  // over the distance: more than 1 in the nearer range
#endif

void main() {
    v_uv = uv;
    v_extent = extent;
    v_color = color;
    float z = 0.0;
#ifdef AMONG_TERRAIN
    z = depth.x + depth.y / distance_m;
    v_parting = parting_m / distance_m;
#endif
    gl_Position = vec4(position.x * clip_per_pixel.x - 1.0, 1.0 - position.y * clip_per_pixel.y, z, 1.0);
}
