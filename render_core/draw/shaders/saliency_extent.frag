// Saliency: of 16 x 16 texels the greatest (MOST, of two bytes: WIDE), or how many show a feature (COUNT), or their sum (SUM).
uniform sampler2D first;
uniform vec2 first_size;
uniform vec2 origin;  // of the target's part
#ifdef COUNT
uniform float column;  // of the figures of what is counted
#endif

void main() {
    vec2 corner = 16.0 * (floor(gl_FragCoord.xy) - origin), beyond = first_size - 0.5;
    vec4 all = vec4(0.0);
#ifdef WIDE
    float most = 0.0;
#endif
#ifdef COUNT
    vec4 least = scale.y > 0.5 ? scale.zzzz : 0.5 * most_of(column);
#endif
    for (int n = 0; n < 256; ++n) {  // one loop: compilers unroll short ones
        float y = floor(float(n) / 16.0);
        vec2 at = corner + vec2(float(n) - 16.0 * y, y);
        if (at.x > beyond.x || at.y > beyond.y) continue;
        vec4 texel = TEXEL(first, at, first_size);
#ifdef WIDE
        most = max(most, wide(texel));
#elif defined(COUNT)
        all += vec4(greaterThan(squared(texel), least));
#elif defined(SUM)
        all += counted(texel);
#else
        all = max(all, texel);
#endif
    }
#ifdef WIDE
    FRAGMENT_COLOR = vec4(wide_code(most), 0.0, 1.0);
#elif defined(COUNT) || defined(SUM)
    FRAGMENT_COLOR = count_code(all);
#else
    FRAGMENT_COLOR = all;
#endif
}
