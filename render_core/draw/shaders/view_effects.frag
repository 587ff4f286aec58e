// Effects on the finished picture of the scene: what is out of focus is blurred (BLUR; follows blur_radius.frag), edges are
// smoothed (SMOOTH).
uniform sampler2D scene;       // alpha codes the logarithm of the distance as in terrain.frag; 1 is infinitely far
uniform vec2 scene_size;       // texels
#ifdef BLUR
uniform sampler2D squares, surroundings;  // of blur_source.frag and blur_gather.frag
#endif

#ifdef SHAFTS
uniform sampler2D shafts;      // half as large: light that shadows take from the air, as its root with AIR; alpha: of what distance
#endif

VARYING vec2 v_at;

vec4 scene_at(ivec2 at) { return texelFetch(scene, clamp(at, ivec2(0), ivec2(scene_size) - 1), 0); }

#ifdef BLUR
// What surrounds the pixel, alpha: its share of the pixel's color. Of the four squares round the pixel those that are as much out
// of focus count.
vec4 surroundings_of(ivec2 at, float code) {
    if (code < 0.5 / 255.0) return vec4(0.0);  // a warning
    float own = blur_of(code);
    vec2 place = (vec2(at) + 0.5) / float(TEXEL) - 0.5;
    ivec2 first = ivec2(floor(place)), last = textureSize(squares, 0) - 1;
    vec2 part = place - floor(place);
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (int n = 0; n < 4; ++n) {
        ivec2 side = ivec2(n & 1, n >> 1), square = clamp(first + side, ivec2(0), last);
        vec2 near = mix(1.0 - part, part, vec2(side));
        float differs = abs(coded_blur(texelFetch(squares, square, 0).a) - own);
        float weight = near.x * near.y * max(1.0 - differs, 0.001);
        vec4 tap = texelFetch(surroundings, square, 0);
        sum += vec4(tap.rgb * tap.a, tap.a) * weight;
        weights += weight;
    }
    return vec4(sum.rgb / max(sum.a, 1e-6), sum.a / weights);
}
#endif

#ifdef SMOOTH
float luma(vec3 color) { return dot(color, vec3(0.299, 0.587, 0.114)); }

// Along an edge, and only there (Lottes, "FXAA", 2009).
vec3 smoothed(ivec2 at, vec3 here) {
    float nw = luma(scene_at(at + ivec2(-1, 1)).rgb), ne = luma(scene_at(at + ivec2(1, 1)).rgb);
    float sw = luma(scene_at(at + ivec2(-1, -1)).rgb), se = luma(scene_at(at + ivec2(1, -1)).rgb);
    float least = min(min(min(nw, ne), min(sw, se)), luma(here)), most = max(max(max(nw, ne), max(sw, se)), luma(here));
    if (most - least < max(0.04, 0.1 * most)) return here;
    vec2 along = vec2((sw + se) - (nw + ne), (ne + se) - (nw + sw));
    float blunt = max((nw + ne + sw + se) / 32.0, 1.0 / 128.0);
    along = clamp(along / (min(abs(along.x), abs(along.y)) + blunt), -6.0, 6.0) / scene_size;
    vec3 inner = 0.5 * (TEXTURE2D(scene, v_at - along / 6.0).rgb + TEXTURE2D(scene, v_at + along / 6.0).rgb);
    vec3 outer = 0.5 * inner + 0.25 * (TEXTURE2D(scene, v_at - along / 2.0).rgb + TEXTURE2D(scene, v_at + along / 2.0).rgb);
    float light = luma(outer);
    return light < least || light > most ? inner : outer;
}
#endif

#ifdef SHAFTS
// Of the four places of the smaller picture round this one, those that were walked as far.
vec3 without_shafts(vec3 color, ivec2 at, float code) {
    if (code < 0.5 / 255.0) return color;  // a warning
    vec2 place = (vec2(at) - 0.5) * 0.5;
    ivec2 first = ivec2(floor(place)), last = textureSize(shafts, 0) - 1;
    vec2 part = place - floor(place);
    vec4 sum = vec4(0.0);
    for (int n = 0; n < 4; ++n) {
        ivec2 side = ivec2(n & 1, n >> 1);
        vec4 tap = texelFetch(shafts, clamp(first + side, ivec2(0), last), 0);
        vec2 near = mix(1.0 - part, part, vec2(side));
        // Half of the place's own weight for all four: their steps begin at four places, which belong together.
        float weight = (0.25 + near.x * near.y) * max(1.0 - abs(tap.a - code) * 40.0, 0.001);
        sum += vec4(tap.rgb, 1.0) * weight;
    }
    vec3 lost = sum.rgb / sum.a;
#ifdef AIR
    return sqrt(max(color * color - lost * lost, vec3(0.0)));
#else
    return max(color - lost, vec3(0.0));
#endif
}
#endif

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 here = scene_at(at);
    vec3 color = here.rgb;
#ifdef BLUR
    vec4 soft = surroundings_of(at, here.a);
    color = mix(color, soft.rgb, soft.a);
#ifdef SMOOTH
    if (soft.a < 0.33) color = smoothed(at, here.rgb);  // what is blurred has no edges
#endif
#elif defined(SMOOTH)
    color = smoothed(at, color);
#endif
#ifdef SHAFTS
    color = without_shafts(color, at, here.a);
#endif
    FRAGMENT_COLOR = vec4(color, 1.0);
}
