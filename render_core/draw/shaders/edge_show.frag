// The edges of some rows of a picture, white on black; or over the picture its regions (REGIONS), tinted by their density, with
// lines between them. The texture's first row is the uppermost one.
uniform sampler2D first;
uniform vec2 first_size;
uniform vec2 picture;
uniform float top;  // the first of the rows, from the picture's top

float texel(vec2 at) { return TEXTURE2D(first, (at + 0.5) / first_size).r; }

#ifdef REGIONS
// Of places that count, from the first one: the region's number, and its first place.
vec2 region_at(float at, float places, float regions) {
    float number = clamp(floor((regions * at + regions - 0.5) / places), 0.0, regions - 1.0);
    return vec2(number, floor((number * places + 0.5) / regions));
}
#endif

void main() {
    vec2 at = vec2(floor(gl_FragCoord.x), picture.y - 1.0 - floor(gl_FragCoord.y));
#ifdef REGIONS
    vec2 inner = max(picture - 2.0, 1.0), inner_at = at - 1.0;
    vec2 column = region_at(inner_at.x, inner.x, 8.0), row = region_at(inner_at.y, inner.y, 6.0);
    float value = texel(vec2(column.x, row.x));
    bool is_line = inner_at.x == column.y && column.x > 0.5 || inner_at.y == row.y && row.x > 0.5;
    FRAGMENT_COLOR = is_line ? vec4(vec3(0.85), 0.7) : vec4(heat_color(value), 0.2 + 0.5 * value);
#else
    FRAGMENT_COLOR = vec4(vec3(texel(vec2(at.x, at.y - top))), 1.0);
#endif
}
