// Share of the sun's disc that data hide from a place: draw/drawers/shadow_map.hpp.
#ifdef SHADOWS
uniform highp sampler2D shadow_map;  // else drivers may read 24 bits as a half float: levels one above the other: how far towards the sun, and in alpha how much it takes
uniform vec4 shadow_levels[3];    // middle, half an edge, m; 1: something casts there
uniform vec4 shadow_look;         // what a shadow takes; the sun's radius over its elevation's sine; highest caster over the sea, m; texels

const float kShadowReach = 400000.0, kShadowBias = 0.5, kSunRadius = 0.00465;
const int kSearchTaps = 10, kShadeTaps = 16;
// Texels of a level that a disc may span before a coarser one serves: taps in it leave no gaps.
const float kSearchTexels = 2.5, kShadeTexels = 6.0, kLeastTexels = 1.5;

float texel_of(int level) { return 2.0 * shadow_levels[level].z / shadow_look.w; }

vec2 texels_at(vec2 at, int level) { return ((at - shadow_levels[level].xy) / shadow_levels[level].z * 0.5 + 0.5) * shadow_look.w; }

// Distance towards the sun of what stands there, and how much it takes.
vec2 caster_at(vec2 texels, int level) {
    ivec2 texel = ivec2(clamp(texels, vec2(0.0), vec2(shadow_look.w - 1.0)));
    vec4 code = texelFetch(shadow_map, texel + ivec2(0, level * int(shadow_look.w)), 0);
    return vec2((dot(code.rgb, vec3(16711680.0, 65280.0, 255.0)) / 16777215.0 * 2.0 - 1.0) * kShadowReach, code.a);
}

// The finest level that has the place and what its widest disc spans; 3 where none has.
int level_of(vec2 at) {
    for (int n = 0; n < 3; ++n) {
        vec2 away = abs(at - shadow_levels[n].xy);
        if (max(away.x, away.y) < shadow_levels[n].z - (kShadeTexels + 2.0) * texel_of(n)) return n;
    }
    return 3;
}

int coarser(int level, float radius_m, float texels) {
    while (level < 2 && radius_m > texels * texel_of(level)) ++level;
    return level;
}

const mat2 kGoldenTurn = mat2(-0.73736888, 0.67549029, -0.67549029, -0.73736888);

// Mean distance of casters within the widest disc; 0 where there is none.
float blockers(vec3 at, int own, float widest_m) {
    int level = coarser(own, widest_m, kSearchTexels);
    float radius = clamp(widest_m / texel_of(level), kLeastTexels, kSearchTexels);
    vec2 middle = texels_at(at.xy, level), way = vec2(radius, 0.0), sum = vec2(0.0);
    for (int n = 0; n < kSearchTaps; ++n) {
        vec2 caster = caster_at(middle + way * sqrt((float(n) + 0.5) / float(kSearchTaps)), level);
        if (caster.x > at.z + kShadowBias) sum += vec2(caster.x - at.z, 1.0) * caster.y;
        way = kGoldenTurn * way;
    }
    return sum.y > 0.0 ? sum.x / sum.y : 0.0;
}

// `at`: in the light's frame; its height over the sea, m. Equal areas of the disc weigh the same.
float shadow_at(vec3 at, float height_m) {
    float above = shadow_look.z - height_m;
    int own = above > 0.0 ? level_of(at.xy) : 3;
    if (own == 3 || shadow_levels[own].w < 0.5) return 0.0;
    // Ground that stands out of a caster is not shaded by what it stands out of, however steeply that rises towards the sun.
    vec2 here = caster_at(texels_at(at.xy, own), own);
    if (here.y > 0.0 && here.x < at.z) return 0.0;
    float mean_m = blockers(at, own, above * shadow_look.y);
    if (mean_m <= 0.0) return 0.0;
    float radius_m = mean_m * kSunRadius;
    int level = coarser(own, radius_m, kShadeTexels);
    float radius = clamp(radius_m / texel_of(level), kLeastTexels, kShadeTexels);
    vec2 middle = texels_at(at.xy, level), way = vec2(radius, 0.0);
    float sum = 0.0;
    for (int n = 0; n < kShadeTaps; ++n) {
        vec2 texels = middle + way * sqrt((float(n) + 0.5) / float(kShadeTaps));
        vec2 caster = caster_at(texels, level);
        float taken = TEXTURE2D(shadow_map, (texels + vec2(0.0, float(level) * shadow_look.w)) / (shadow_look.w * vec2(1.0, 3.0))).a;
        if (caster.y <= 0.0 || caster.x > at.z + kShadowBias) sum += taken;
        way = kGoldenTurn * way;
    }
    return sum / float(kShadeTaps);
}
#endif
