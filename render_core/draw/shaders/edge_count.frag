// Edges: how many pixels are edges in any colour, of four rows of a part of a region of the picture.
uniform sampler2D first;
uniform vec2 first_size;
uniform vec2 picture;
uniform float band;
uniform float parts;  // of a region, side by side, each of 255 pixels at most

vec4 strong(float color, vec2 block) { return rows_of(bytes_of(TEXEL(first, block + vec2(color * band, 0.0), first_size)).zw); }

float in_any(float red, float green, float blue, vec4 inside) {
    return dot(max(bits_of(red), max(bits_of(green), bits_of(blue))), inside);
}

void main() {
    vec2 at = floor(gl_FragCoord.xy), place = in_band(at.x, parts);
    vec2 sides = 1.0 + floor((vec2(place.x, place.x + 1.0) * max(picture.x - 2.0, 0.0) + 0.5) / 8.0);
    sides = sides.x + floor((vec2(place.y, place.y + 1.0) * (sides.y - sides.x) + 0.5) / parts);
    float block = floor(sides.x / 4.0);
    vec4 count = vec4(0.0);
    for (int n = 0; n < MOST; ++n) {
        vec4 x = 4.0 * block + kSteps;
        if (x.x > sides.y - 0.5) break;
        vec4 inside = vec4(greaterThanEqual(x, sides.xxxx)) * vec4(lessThan(x, sides.yyyy));
        vec4 red = strong(0.0, vec2(block, at.y)), green = strong(1.0, vec2(block, at.y)), blue = strong(2.0, vec2(block, at.y));
        count += vec4(in_any(red.x, green.x, blue.x, inside), in_any(red.y, green.y, blue.y, inside),
                      in_any(red.z, green.z, blue.z, inside), in_any(red.w, green.w, blue.w, inside));
        block += 1.0;
    }
    FRAGMENT_COLOR = count / 255.0;
}
