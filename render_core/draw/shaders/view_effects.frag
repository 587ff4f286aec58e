// Effects on the finished picture of the scene: what is out of focus is blurred (BLUR), edges are smoothed (SMOOTH).
uniform sampler2D scene;       // alpha codes the logarithm of the distance as in terrain.frag; 1 is infinitely far
uniform vec2 scene_size;       // texels
#ifdef BLUR
uniform vec3 focus;            // what is sharp begins and ends, m; radius of the blur infinitely far, pixels
uniform int taps;              // places that a pixel's blur reads
#endif

#ifdef SHAFTS
uniform sampler2D shafts;      // half as large: light that shadows take from the air, as its root with AIR; alpha: of what distance
#endif

VARYING vec2 v_at;

vec4 scene_at(ivec2 at) { return texelFetch(scene, clamp(at, ivec2(0), ivec2(scene_size) - 1), 0); }

#ifdef BLUR
// Radius in pixels. A lens blurs by the difference of reciprocal distances; nearer than the focus no more than far beyond it.
float blur_of(float code) {
    float distance_m = 50.0 * (exp2(13.0 * code) - 1.0);
    float far = max(1.0 - focus.y / max(distance_m, 1.0), 0.0);
    float near = clamp(focus.x / max(distance_m, 1.0) - 1.0, 0.0, 1.0);
    if (code < 0.5 / 255.0) return 0.0;  // a warning, which is kept out of all this
    return focus.z * (code > 254.5 / 255.0 ? 1.0 : max(far, near));
}

// Places on a spiral of equal areas. What lies farther than this pixel blurs into it only as far as itself is blurred:
// else edges of what is sharp would glow. Alpha: how much of it is other pixels'.
vec4 blurred(ivec2 at, vec4 here) {
    float own = blur_of(here.a);
    vec4 sum = vec4(here.rgb, 1.0);
    vec2 way = vec2(1.0, 0.0);
    for (int n = 0; n < taps; ++n) {
        float radius = sqrt((float(n) + 0.5) / float(taps)) * focus.z;
        vec4 tap = scene_at(at + ivec2(floor(way * radius + 0.5)));
        float other = blur_of(tap.a);
        float weight = clamp((tap.a > here.a ? min(other, own) : other) - radius + 0.5, 0.0, 1.0);
        sum += vec4(tap.rgb, 1.0) * weight;
        way = mat2(-0.73736888, 0.67549029, -0.67549029, -0.73736888) * way;  // by the golden angle
    }
    return vec4(sum.rgb / sum.a, sum.a - 1.0);
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
    vec4 soft = blurred(at, here);
    color = soft.rgb;
#ifdef SMOOTH
    if (soft.a < 0.5) color = smoothed(at, here.rgb);  // what is blurred has no edges
#endif
#elif defined(SMOOTH)
    color = smoothed(at, color);
#endif
#ifdef SHAFTS
    color = without_shafts(color, at, here.a);
#endif
    FRAGMENT_COLOR = vec4(color, 1.0);
}
