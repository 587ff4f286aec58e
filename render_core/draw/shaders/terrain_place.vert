// Where a vertex of a terrain chunk lies. Offset and position are exact in float and their sum is rounded once, so a vertex
// that two chunks share gets the same bits from both: no cracks between levels. Everything after that sum is common to all
// chunks. Followed by terrain.vert or terrain_code.vert.
VERTEX_IN vec3 position;   // ECEF minus the chunk's centre, m
VERTEX_IN float height;    // above MSL, m
VERTEX_IN vec3 normal;     // ECEF
VERTEX_IN float kind;      // post class in the lowest two bits
VERTEX_IN vec2 place;      // lattice posts from the chunk's north-west corner

uniform vec3 chunk_offset;     // chunk's centre minus the eye's whole metres
uniform mat4 view_projection;  // from there, with the eye's remaining fraction
uniform mat3 to_local;         // ECEF to east, north, up at the chunk
#ifdef LIFTED
uniform float lift[9];         // by row and column: north-west corner, north side, ...
uniform vec2 place_end;        // of the south-east corner
#endif
#ifdef FLAT
uniform float flat_height;     // above MSL, of all that is drawn
#endif
#if defined(LIFTED) || defined(FLAT)
uniform vec3 earth_centre;     // from the eye's whole metres

// Along the ellipsoid's normal: z weighs a^2 / b^2.
vec3 raised(vec3 eye_relative, float by) {
    return eye_relative + normalize((eye_relative - earth_centre) * vec3(1.0, 1.0, 1.0067394967)) * by;
}
#endif

vec3 eye_relative_place() {
    vec3 eye_relative = position + chunk_offset;
#ifdef LIFTED
    vec2 side = step(0.5, place) + step(place_end - 0.5, place);
    eye_relative = raised(eye_relative, lift[int(side.y * 3.0 + side.x + 0.5)]);
#endif
#ifdef FLAT
    eye_relative = raised(eye_relative, flat_height - height);
#endif
    return eye_relative;
}

// Sea, void.
vec2 class_of_vertex() {
    float post_class = mod(kind, 4.0);
    return vec2(abs(post_class - 1.0) < 0.5 ? 1.0 : 0.0, abs(post_class - 2.0) < 0.5 ? 1.0 : 0.0);
}
