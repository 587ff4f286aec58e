// Terrain chunks. Offset and position are exact in float and their sum is rounded once, so a vertex that two chunks share
// gets the same bits from both: no cracks between levels. Everything after that sum is common to all chunks.
VERTEX_IN vec3 position;   // ECEF minus the chunk's centre, m
VERTEX_IN float height;    // above MSL, m
VERTEX_IN vec3 normal;     // ECEF
VERTEX_IN float kind;      // post class in the lowest two bits
VERTEX_IN vec2 place;      // lattice posts from the chunk's north-west corner

uniform vec3 chunk_offset;     // chunk's centre minus the eye's whole metres
uniform mat4 view_projection;  // from there, with the eye's remaining fraction
uniform mat3 to_local;         // ECEF to east, north, up at the chunk
uniform float haze_per_m;      // 1 / distance, 0 for none
#ifdef LIFTED
uniform float lift[9];         // by row and column: north-west corner, north side, ...
uniform vec2 place_end;        // of the south-east corner
uniform vec3 earth_centre;     // from the eye's whole metres
#endif
#ifdef BAKED
uniform vec4 page_window;      // texels of the page = place * xy + zw
VARYING vec2 v_page;
#endif
#ifdef MAP_DRAPE
uniform vec3 drape_window;     // texels of the page = place * x + yz
VARYING vec2 v_drape;
#endif
#ifdef STROKES
uniform vec4 stroke_window;    // metres east and south, modulo a whole number of strokes = place * xy + zw
VARYING vec2 v_ground;
#endif

VARYING float v_height;
VARYING vec2 v_class;          // sea, void
VARYING vec3 v_normal;         // east, north, up
VARYING vec3 v_eye;            // from the eye, east, north, up, m
VARYING float v_haze;

void main() {
    vec3 eye_relative = position + chunk_offset;
#ifdef LIFTED
    vec2 side = step(0.5, place) + step(place_end - 0.5, place);
    // Along the ellipsoid's normal: z weighs a^2 / b^2.
    eye_relative += normalize((eye_relative - earth_centre) * vec3(1.0, 1.0, 1.0067394967)) * lift[int(side.y * 3.0 + side.x + 0.5)];
#endif
    gl_Position = view_projection * vec4(eye_relative, 1.0);
    v_height = height;
    float post_class = mod(kind, 4.0);
    v_class = vec2(abs(post_class - 1.0) < 0.5 ? 1.0 : 0.0, abs(post_class - 2.0) < 0.5 ? 1.0 : 0.0);
    v_normal = to_local * normal;
    v_eye = to_local * eye_relative;
    v_haze = 1.0 - exp(-length(eye_relative) * haze_per_m);
#ifdef BAKED
    v_page = place * page_window.xy + page_window.zw;
#endif
#ifdef MAP_DRAPE
    v_drape = place * drape_window.x + drape_window.yz;
#endif
#ifdef STROKES
    v_ground = place * stroke_window.xy + stroke_window.zw;
#endif
}
