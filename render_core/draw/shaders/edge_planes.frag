// Edges: a strip of the picture as planes, four pixels of a colour in a texel. Bands have a texel more at both ends, where the
// outermost pixel is repeated. The strip's rows are the surface's: the last one is its top.
uniform sampler2D first;
uniform vec2 first_size;
uniform vec2 picture;
uniform float band;

void main() {
    vec2 place = in_band(floor(gl_FragCoord.x), band);
    vec3 color = vec3(equal(place.xxx, kSteps.xyz));
    vec4 x = clamp(4.0 * (place.y - 1.0) + kSteps, 0.0, picture.x - 1.0);
    float row = first_size.y - 1.0 - floor(gl_FragCoord.y);
    FRAGMENT_COLOR = vec4(dot(TEXEL(first, vec2(x.x, row), first_size).rgb, color),
                          dot(TEXEL(first, vec2(x.y, row), first_size).rgb, color),
                          dot(TEXEL(first, vec2(x.z, row), first_size).rgb, color),
                          dot(TEXEL(first, vec2(x.w, row), first_size).rgb, color));
}
