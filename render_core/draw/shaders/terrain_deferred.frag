// Shades the ground of one chunk from a geometry picture (geometry_picture.hpp), once a pixel; the depth test lets only pixels
// with the chunk's number pass. Follows terrain.frag, alert_place.vert and terrain_varyings.vert.
precision highp int;           // else the upper bits may be lost

uniform highp usampler2D geometry;
uniform vec2 place_end;        // lattice posts across and down the chunk
uniform vec3 ray_axes[4];      // the eye from its whole metres; the ray at the lower left corner, and its change to the right and up
uniform mat3 to_local;         // ECEF to east, north, up at the chunk

vec3 normal_of_code(uint code) {
    vec2 at = vec2(code & 1023u, (code >> 10u) & 1023u) * (2.0 / 1023.0) - 1.0;
    vec3 n = vec3(at, 1.0 - abs(at.x) - abs(at.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
    return n;
}

void main() {
    uvec4 words = texelFetch(geometry, ivec2(gl_FragCoord.xy), 0);
    vec2 place = vec2(words.x & 65535u, words.x >> 16u) * (1.0 / 65535.0) * place_end;
    vec3 ray = ray_axes[1] + gl_FragCoord.x * ray_axes[2] + gl_FragCoord.y * ray_axes[3];
    vec3 eye_relative = ray_axes[0] + ray * uintBitsToFloat(words.w);
    vec2 post_class = vec2((words.z >> 20u) & 1u, (words.z >> 21u) & 1u);
    leave_varyings(eye_relative, eye_relative, to_local * eye_relative, to_local * normal_of_code(words.z),
                   uintBitsToFloat(words.y), post_class, place);
    shade_ground();
}
