// The color that a square's surroundings blur into it, alpha: their share of its color. Squares: blur_source.frag. Follows
// blur_radius.frag.
uniform sampler2D squares;
uniform int taps;              // squares that a square's blur reads

// Places on a spiral of equal areas. What lies farther than this square blurs into it only as far as itself is blurred:
// else edges of what is sharp would glow. Places within the square are the pixel's own: its color stands for them.
void main() {
    ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(squares, 0) - 1;
    vec4 here = texelFetch(squares, at, 0);
    float own = abs(coded_blur(here.a));
    vec4 sum = vec4(0.0);
    float inside = 1.0;
    vec2 way = vec2(1.0, 0.0);
    for (int n = 0; n < taps; ++n) {
        float radius = sqrt((float(n) + 0.5) / float(taps)) * focus.z;
        ivec2 off = ivec2(floor(way * radius / float(TEXEL) + 0.5));
        vec4 tap = texelFetch(squares, clamp(at + off, ivec2(0), last), 0);
        float other = abs(coded_blur(tap.a));
        float weight = clamp((tap.a > here.a ? min(other, own) : other) - radius + 0.5, 0.0, 1.0);
        if (off == ivec2(0))
            inside += weight;
        else
            sum += vec4(tap.rgb, 1.0) * weight;
        way = mat2(-0.73736888, 0.67549029, -0.67549029, -0.73736888) * way;  // by the golden angle
    }
    FRAGMENT_COLOR = vec4(sum.a > 0.0 ? sum.rgb / sum.a : here.rgb, sum.a / (inside + sum.a));
}
