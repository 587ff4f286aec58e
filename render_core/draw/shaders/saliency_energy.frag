// Saliency: how strongly lightness is striped in four directions, from filtered rows: straight ones and those of the diagonals.
uniform sampler2D first;
uniform sampler2D second;
uniform vec2 first_size;
uniform float bell[5];
uniform float cosine[5];
uniform float sine[5];
uniform float slant_cosine[5];
uniform float slant_sine[5];
uniform vec2 flat_share;  // what the filters answer to 1 everywhere: straight, slanted

vec3 row(sampler2D rows, float y) {
    return triple_of(texel_at(rows, first_size, floor(gl_FragCoord.xy) + vec2(0.0, y))) / vec3(1.0, ROW_GAIN, ROW_GAIN);
}

void main() {
    vec3 straight = row(first, 0.0), slanted = row(second, 0.0);
    vec3 bells = bell[0] * straight;             // mean, wave across: its two phases
    vec2 down = vec2(cosine[0] * straight.x, 0.0);  // wave down
    vec4 both = vec4(slant_cosine[0] * slanted.yz, 0.0, 0.0);
    for (int k = 1; k < 5; ++k) {
        vec3 above = row(first, -float(k)), below = row(first, float(k));
        bells += bell[k] * (above + below);
        down += vec2(cosine[k] * (above.x + below.x), sine[k] * (below.x - above.x));
        vec2 slanted_above = row(second, -float(k)).yz, slanted_below = row(second, float(k)).yz;
        both += vec4(slant_cosine[k] * (slanted_above + slanted_below), slant_sine[k] * (slanted_below - slanted_above));
    }
    float mean = flat_share.x * bells.x, slanted_mean = flat_share.y * bells.x;
    vec4 lengths = vec4(length(bells.yz - vec2(mean, 0.0)), length(vec2(both.x - both.w - slanted_mean, both.y + both.z)),
                        length(down - vec2(mean, 0.0)), length(vec2(both.x + both.w - slanted_mean, both.y - both.z)));
    FRAGMENT_COLOR = rooted(4.0 * lengths);
}
