// The depths of terrain that was traced, from a picture whose texels are the bytes of 32-bit floats, rows from the top: depths
// along the view's axis in metres, infinite where there is nothing. Ground nearer than the range hides all of it. ES 3 only.
precision highp int;           // else their upper bytes may be lost

uniform sampler2D depths;
uniform vec2 depth_range;      // nearest and farthest that the buffer holds, m

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    uvec4 bytes = uvec4(texelFetch(depths, ivec2(at.x, textureSize(depths, 0).y - 1 - at.y), 0) * 255.0 + 0.5);
    float depth_m = uintBitsToFloat(bytes.r | (bytes.g << 8u) | (bytes.b << 16u) | (bytes.a << 24u));
    float depth = depth_range.y * (depth_m - depth_range.x) / ((depth_range.y - depth_range.x) * depth_m);
    gl_FragDepth = depth_m < depth_range.y ? clamp(depth, 0.0, 1.0) : 1.0;
    FRAGMENT_COLOR = vec4(1.0);
}
