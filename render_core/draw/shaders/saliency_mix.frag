// Saliency: feature maps become conspicuities, by parts of their bounds (CONSPICUITY); those the map, by part of the greatest that it
// may be (TOTAL); and that the map on its scale (MAP).
uniform sampler2D first;
#ifdef CONSPICUITY
uniform sampler2D second;
uniform sampler2D third;
#endif
uniform vec2 first_size;

// The sum cannot be greater.
float greatest_total() { return dot(parts(), most_of(3.0).xyz); }

void main() {
    vec2 at = floor(gl_FragCoord.xy);
    vec4 here = TEXEL(first, at, first_size);
#ifdef CONSPICUITY
    vec4 colors = squared(here) * weights_of(0.0);
    vec2 blues = squared(TEXEL(second, at, first_size)).xy * weights_of(1.0).xy;
    float directions = dot(squared(TEXEL(third, at, first_size)), weights_of(2.0));
    vec3 sums = vec3(colors.x + colors.y, colors.z + colors.w + blues.x + blues.y, directions);
    FRAGMENT_COLOR = rooted(vec4(sums / max(bounds(), 1e-12), 0.0));
#elif defined(TOTAL)
    float most = greatest_total();
    FRAGMENT_COLOR = vec4(wide_code(most > 0.0 ? dot(parts(), squared(here).xyz) / most : 0.0), 0.0, 1.0);
#else
    float most = wide(TEXEL(figures, vec2(4.0, 0.0), figures_size));
    float value = scale.y > 0.5 ? wide(here) * greatest_total() * scale.w : most > 0.0 ? wide(here) / most : 0.0;
    value = clamp(value, 0.0, 1.0);
    FRAGMENT_COLOR = vec4(wide_code(value), value, 1.0);
#endif
}
