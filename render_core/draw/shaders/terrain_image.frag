// What terrain.frag reads of atlases: numbers, places in them, and the image over the terrain.
const float kSigned = 255.0 / 127.0;
const float kZero = 128.0 / 127.0;

float signed_root(float code) {
    float root = code * kSigned - kZero;
    return root * abs(root);
}

vec3 normal_of(vec2 code) {
    vec2 level = code * kSigned - kZero;
    return vec3(level, sqrt(max(1.0 - dot(level, level), 0.0)));
}

#if defined(BAKED) || defined(MAP_DRAPE)
// Whole fractions of a texel: with atlases of 2^n texels every sum is exact, so a page looks the same wherever it lies.
vec2 whole(vec2 texels) { return floor(texels * 256.0 + 0.5) / 256.0; }
#endif
#ifdef MAP_DRAPE
uniform sampler2D drape_map;
uniform vec4 drape_origin;       // first texel of the page; width of a texel in parts of its height; 1 / size of the atlas

// RGB times coverage, and coverage; between the middles of the page's outermost texels, so nothing else is read.
vec4 drape_at(vec2 texels) {
    return TEXTURE2D(drape_map, (whole(clamp(texels, 0.0, 128.0)) + drape_origin.xy) * drape_origin.w);
}

// On a slope a texel is stretched down the fall line by 1 / n.z. Read as it is, the image would show streaks there. So it is read
// over as much ground along the contour line: a texel's variance, 1/6, grows by tan^2 / 6, which five places a step of
// tan / sqrt(12) apart give it. The image gets coarser on steep ground, and has the same grain in every direction.
vec4 drape_of(vec2 texels, vec3 n) {
    float level = length(n.xy);
    float steep = min(level / max(n.z, 0.01), 6.0);
    if (steep < 0.25) return drape_at(texels);
    vec2 along = vec2(n.y / drape_origin.z, n.x) / level * (steep * 0.28867513);
    return 0.2 * (drape_at(texels) + drape_at(texels + along) + drape_at(texels - along) + drape_at(texels + 2.0 * along) +
                  drape_at(texels - 2.0 * along));
}
#endif
