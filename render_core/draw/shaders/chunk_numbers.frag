// Leaves the chunk's number in each pixel of the geometry picture (geometry_picture.hpp) as a depth, so that a depth test lets
// only the pixels of one chunk pass. Such depths are exact in binary floating point.
precision highp int;           // else the upper bits may be lost

uniform highp usampler2D geometry;

void main() {
    float number = float(texelFetch(geometry, ivec2(gl_FragCoord.xy), 0).z >> 22u);
    gl_FragDepth = number < 0.5 ? 1.0 : number / 1024.0;
    FRAGMENT_COLOR = vec4(1.0);
}
