// Saliency: gives a share of each texel to those beside it, then to those above and below: means of blocks become as wide as levels are.
uniform sampler2D first;
uniform vec2 first_size;
uniform float share;

void main() {
    vec2 at = floor(gl_FragCoord.xy);
    vec3 sum = vec3(0.0);
    for (int y = -1; y < 2; ++y)
        for (int x = -1; x < 2; ++x) {
            float weight = (x == 0 ? 1.0 - 2.0 * share : share) * (y == 0 ? 1.0 - 2.0 * share : share);
            sum += weight * triple_of(texel_at(first, first_size, at + vec2(float(x), float(y))));
        }
    FRAGMENT_COLOR = triple_code(sum);
}
