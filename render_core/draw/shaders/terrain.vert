// Terrain chunks. Offset and position are exact in float and their sum is rounded once, so a vertex that two chunks share
// gets the same bits from both: no cracks between levels. Everything after that sum is common to all chunks.
VERTEX_IN vec3 position;   // ECEF minus the chunk's centre, m
VERTEX_IN float height;    // above MSL, m
VERTEX_IN vec3 normal;     // ECEF
VERTEX_IN float kind;      // top level + 16 * post class
#ifdef RASTER_ENDS
VERTEX_IN vec2 place;      // lattice posts from the chunk's north-west corner
#endif

uniform vec3 chunk_offset;     // chunk's centre minus the eye's whole metres
uniform mat4 view_projection;  // from there, with the eye's remaining fraction
uniform vec3 light_direction;  // towards the light, ECEF
uniform vec2 light;            // ambient, diffuse
uniform float haze_per_m;      // 1 / distance, 0 for none

VARYING float v_height;
VARYING float v_light;
VARYING float v_sea;
VARYING float v_haze;
#ifdef RASTER_ENDS
VARYING vec2 v_place;
#endif

void main() {
    vec3 eye_relative = position + chunk_offset;
    gl_Position = view_projection * vec4(eye_relative, 1.0);
    v_height = height;
    v_light = light.x + light.y * max(dot(normal, light_direction), 0.0);
    v_sea = abs(mod(floor(kind / 16.0), 4.0) - 1.0) < 0.5 ? 1.0 : 0.0;
    v_haze = 1.0 - exp(-length(eye_relative) * haze_per_m);
#ifdef RASTER_ENDS
    v_place = place;
#endif
}
