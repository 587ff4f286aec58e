// Saliency: rows of lightness under a Gaussian, and under a wave's two phases.
uniform sampler2D first;
uniform vec2 first_size;
uniform float bell[5];
uniform float cosine[5];
uniform float sine[5];

float lightness(float x) {
    vec2 at = floor(gl_FragCoord.xy);
    return triple_of(texel_at(first, first_size, at + vec2(x, 0.0))).x;
}

void main() {
    float here = lightness(0.0);
    vec3 sum = vec3(bell[0] * here, cosine[0] * here, 0.0);
    for (int k = 1; k < 5; ++k) {
        float left = lightness(-float(k)), right = lightness(float(k));
        sum += vec3(bell[k] * (left + right), cosine[k] * (left + right), sine[k] * (right - left));
    }
    FRAGMENT_COLOR = triple_code(sum * vec3(1.0, ROW_GAIN, ROW_GAIN));
}
