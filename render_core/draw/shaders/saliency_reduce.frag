// Saliency: the next level of the pyramid, half as large. Weights 1 3 3 1 across and down.
uniform sampler2D first;
uniform vec2 first_size;

float weight(int n) { return n == 0 || n == 3 ? 1.0 : 3.0; }

void main() {
    vec2 corner = 2.0 * floor(gl_FragCoord.xy) - 1.0;
    vec3 sum = vec3(0.0);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            sum += weight(x) * weight(y) * triple_of(texel_at(first, first_size, corner + vec2(float(x), float(y))));
    FRAGMENT_COLOR = triple_code(sum / 64.0);
}
