// Saliency: numbers in the four bytes of a texel, and how they are read. First rows are the picture's top ones.
#ifdef LANE_ES3
#define TEXEL(image, at, size) texelFetch(image, ivec2(at), 0)
#else
#define TEXEL(image, at, size) TEXTURE2D(image, ((at) + 0.5) / (size))
#endif

// x: 0..1 in twelve bits; y, z: -1.08..1.08 in ten, whose 0 is one of them.
vec3 triple_of(vec4 texel) {
    vec4 n = floor(texel * 255.0 + 0.5);
    vec2 high = floor(n.gb * vec2(0.0625, 0.25)), low = n.gb - vec2(16.0, 4.0) * high;
    return vec3(n.r * 16.0 + high.x, low.x * 64.0 + high.y - 512.0, low.y * 256.0 + n.a - 512.0) *
           vec3(1.0 / 4095.0, 1.0 / 470.0, 1.0 / 470.0);
}

vec4 triple_code(vec3 value) {
    vec3 n = clamp(floor(value * vec3(4095.0, 470.0, 470.0) + vec3(0.5, 512.5, 512.5)), vec3(0.0), vec3(4095.0, 1023.0, 1023.0));
    vec3 high = floor(n / vec3(16.0, 64.0, 256.0));
    return vec4(high.x, (n.x - 16.0 * high.x) * 16.0 + high.y, (n.y - 64.0 * high.y) * 4.0 + high.z, n.z - 256.0 * high.z) / 255.0;
}

// 0..1 by its root in each byte: small values keep their order.
vec4 rooted(vec4 value) { return sqrt(clamp(value, 0.0, 1.0)); }
vec4 squared(vec4 texel) { return texel * texel; }

// 0..1 in the first two bytes.
vec2 wide_code(float value) {
    float n = floor(clamp(value, 0.0, 1.0) * 65535.0 + 0.5), high = floor(n / 256.0);
    return vec2(high, n - 256.0 * high) / 255.0;
}
float wide(vec4 texel) { return dot(floor(texel.rg * 255.0 + 0.5), vec2(256.0, 1.0)) / 65535.0; }

// A number of pixels by the logarithm of one more: within 3 %, whatever it is; up to 800,000.
vec4 count_code(vec4 count) { return floor(13.0 * log2(count + 1.0) + 0.5) / 255.0; }
vec4 logarithm_of_count(vec4 texel) { return texel * (255.0 / 13.0); }
vec4 counted(vec4 texel) { return exp2(logarithm_of_count(texel)) - 1.0; }
