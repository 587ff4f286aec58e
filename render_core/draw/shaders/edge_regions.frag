// Edges: the sum of a region's counts, in three bytes, the highest first.
uniform sampler2D first;
uniform vec2 first_size;
uniform vec2 picture;
uniform float parts;

void main() {
    vec2 at = floor(gl_FragCoord.xy);
    vec2 sides = 1.0 + floor((vec2(at.y, at.y + 1.0) * max(picture.y - 2.0, 0.0) + 0.5) / 6.0);
    float top = floor(sides.x / 4.0), sum = 0.0;
    for (int n = 0; n < MOST; ++n) {
        vec2 place = in_band(float(n), parts);
        vec4 y = 4.0 * (top + place.x) + kSteps;
        if (y.x > sides.y - 0.5) break;
        vec4 inside = vec4(greaterThanEqual(y, sides.xxxx)) * vec4(lessThan(y, sides.yyyy));
        sum += dot(bytes_of(TEXEL(first, vec2(at.x * parts + place.y, top + place.x), first_size)), inside);
    }
    vec2 high = floor(sum / vec2(65536.0, 256.0));
    FRAGMENT_COLOR = vec4(high.x, high.y - 256.0 * high.x, sum - 256.0 * high.y, 255.0) / 255.0;
}
