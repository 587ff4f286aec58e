// The depths of the ground in a geometry picture (geometry_picture.hpp), as the projection of a range of depths has them. Ground
// nearer than the range hides all of it.
precision highp int;           // else the upper bits may be lost

uniform highp usampler2D geometry;
uniform vec2 depth_range;      // nearest and farthest that the buffer holds, m

void main() {
    uvec4 words = texelFetch(geometry, ivec2(gl_FragCoord.xy), 0);
    float depth_m = uintBitsToFloat(words.w);
    bool is_ground = words.z >> 22u != 0u && depth_m < depth_range.y;
    float depth = depth_range.y * (depth_m - depth_range.x) / ((depth_range.y - depth_range.x) * depth_m);
    gl_FragDepth = is_ground ? clamp(depth, 0.0, 1.0) : 1.0;
    FRAGMENT_COLOR = vec4(1.0);
}
