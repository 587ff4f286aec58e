// The edges of a picture, white on black; or over it its regions (REGIONS), tinted by their density, with lines between them.
uniform sampler2D first;
uniform vec2 first_size;
uniform vec2 picture;
uniform float band;

#ifdef REGIONS
// Of places that count, from the first one: the region's number, and its first place and that of the next one.
vec3 region_at(float at, float places, float regions) {
    float number = clamp(floor((regions * at + regions - 0.5) / places), 0.0, regions - 1.0);
    return vec3(number, floor((vec2(number, number + 1.0) * places + 0.5) / regions));
}
#endif

void main() {
    vec2 at = vec2(floor(gl_FragCoord.x), picture.y - 1.0 - floor(gl_FragCoord.y));
#ifdef REGIONS
    vec2 inner = max(picture - 2.0, 1.0), inner_at = at - 1.0;
    vec3 column = region_at(inner_at.x, inner.x, 8.0), row = region_at(inner_at.y, inner.y, 6.0);
    vec3 count = bytes_of(TEXEL(first, vec2(column.x, row.x), first_size)).rgb;
    float pixels = (column.z - column.y) * (row.z - row.y);
    float density = dot(count, vec3(65536.0, 256.0, 1.0)) / max(pixels, 1.0);
    float value = clamp(density / FULL_TINT, 0.0, 1.0);
    bool is_line = inner_at.x == column.y && column.x > 0.5 || inner_at.y == row.y && row.x > 0.5;
    FRAGMENT_COLOR = is_line ? vec4(vec3(0.85), 0.7) : vec4(heat_color(value), 0.2 + 0.5 * value);
#else
    vec2 block = floor(at / 4.0), inside = at - 4.0 * block;
    vec4 is_row = vec4(equal(inside.yyyy, kSteps)), is_column = vec4(equal(inside.xxxx, kSteps));
    float edge = 0.0;
    for (int color = 0; color < 3; ++color) {
        vec4 rows = rows_of(bytes_of(TEXEL(first, block + vec2(float(color) * band, 0.0), first_size)).zw);
        edge = max(edge, dot(bits_of(dot(rows, is_row)), is_column));
    }
    FRAGMENT_COLOR = vec4(vec3(edge), 1.0);
#endif
}
