// Saliency: CIE 1976 L*a*b* of a block's mean levels, in hundredths. The strip's rows are the surface's: the last one is its top.
uniform sampler2D first;
uniform vec2 first_size;
uniform vec3 strip;  // first row of the map that it holds; texels across; rows of the strip that the picture has

float linear_light(float level) { return level <= 0.04045 ? level / 12.92 : pow((level + 0.055) / 1.055, 2.4); }

float compressed(float share) {
    return share > 216.0 / 24389.0 ? pow(share, 1.0 / 3.0) : share * (24389.0 / 27.0 / 116.0) + 16.0 / 116.0;
}

void main() {
    vec2 block = vec2(floor(gl_FragCoord.x), floor(gl_FragCoord.y) - strip.x) * float(BLOCK);
    vec3 sum = vec3(0.0);
    for (int n = 0; n < BLOCK * BLOCK; ++n) {  // one loop: compilers unroll short ones
        float y = floor(float(n) / float(BLOCK)), x = float(n) - float(BLOCK) * y;
        vec2 at = vec2(min(block.x + x, strip.y - 1.0), first_size.y - 1.0 - min(block.y + y, strip.z - 1.0));
        sum += TEXEL(first, at, first_size).rgb;
    }
    vec3 level = sum / float(BLOCK * BLOCK);
    vec3 light = vec3(linear_light(level.r), linear_light(level.g), linear_light(level.b));
    float x = compressed(dot(light, vec3(0.43395633, 0.37621531, 0.18982836)));
    float y = compressed(dot(light, vec3(0.2126729, 0.7151522, 0.0721749)));
    float z = compressed(dot(light, vec3(0.01775657, 0.10946961, 0.87277382)));
    FRAGMENT_COLOR = triple_code(vec3(1.16 * y - 0.16, 5.0 * (x - y), 2.0 * (y - z)));
}
