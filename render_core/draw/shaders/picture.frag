// The picture of what was drawn off-screen: sky where nothing was, colours for codes (CODED), and silhouettes (OUTLINED)
// where the next pixel lies much farther away than the slope of the surface explains: the near one is inked, and the far
// one half. Or nothing but sky (SKY). Follows sky_color.frag; with AIR also fine_distance.frag: what was drawn has none yet.
//
// ES 3 fetches texels by their place, which a processor without texture units does several times as fast.
uniform sampler2D scene;       // alpha codes the logarithm of the distance; 1 where nothing was drawn
uniform vec2 scene_size;       // texels
uniform vec2 left;             // least and most of the distance's code that the picture's alpha keeps
#ifdef OUTLINED
uniform vec3 line_color;
uniform vec3 outline;          // strength; code steps at which a line begins and is full
#endif
#ifdef CODED
uniform sampler2D color_table; // colours by code, and of the sky: color_table.hpp
uniform vec3 haze_color;
#ifdef HATCHED
uniform vec3 unknown_color;
#endif
#endif

const float kSky = 254.5 / 255.0;

#ifdef LANE_ES3
vec4 scene_here() { return texelFetch(scene, ivec2(gl_FragCoord.xy), 0); }
// Left, right, below, above.
vec4 distances_around() {
    ivec2 at = ivec2(gl_FragCoord.xy), before = max(at - 1, ivec2(0)), after = min(at + 1, ivec2(scene_size) - 1);
    return vec4(texelFetch(scene, ivec2(before.x, at.y), 0).a, texelFetch(scene, ivec2(after.x, at.y), 0).a,
                texelFetch(scene, ivec2(at.x, before.y), 0).a, texelFetch(scene, ivec2(at.x, after.y), 0).a);
}
#else
vec4 scene_here() { return TEXTURE2D(scene, v_at); }
vec4 distances_around() {
    vec2 texel = 1.0 / scene_size;
    return vec4(TEXTURE2D(scene, v_at - vec2(texel.x, 0.0)).a, TEXTURE2D(scene, v_at + vec2(texel.x, 0.0)).a,
                TEXTURE2D(scene, v_at - vec2(0.0, texel.y)).a, TEXTURE2D(scene, v_at + vec2(0.0, texel.y)).a);
}
#endif

#ifdef CODED
#ifdef LANE_ES3
vec4 table_at(vec2 code) { return texelFetch(color_table, ivec2(code * 255.0 + 0.5), 0); }
#else
vec4 table_at(vec2 code) { return TEXTURE2D(color_table, (code * 255.0 + 0.5) / 256.0); }
#endif
// Ground and sky by one look into the table.
vec3 color_seen(vec4 code) {
    // Sky is fully lit and known.
    vec3 look = code.a > kSky ? vec3(sky_column(), 1.0, 1.0) : code.grb;
    vec3 color = table_at(look.xy).rgb * look.z;
    float haze = table_at(vec2(code.a, 1.0)).a;
#ifdef HATCHED
    float unknown = step(look.z, 0.002);
    color = mix(color, unknown_color * hatch_at(gl_FragCoord.xy), unknown);
    haze *= 1.0 - 0.5 * unknown;
#endif
    color = mix(color, haze_color, haze);
    return code.a > kSky ? color * ground_hatch_here() : color;
}
#elif defined(AIR)
// One look through the air for ground and sky.
vec3 color_seen(vec4 texel) {
    vec3 ray = view_ray();
    BehindAir seen = sky_behind_air(ray);
    float share = air_look.x, hatch = ground_hatch_here();
    if (texel.a <= kSky) {
        float half_air;
        vec4 ground = color_and_distance(texel, half_air);
        seen = BehindAir(ground.rgb, ground.rgb, air_column(ground.a), 0.0);
        share *= 1.0 - 0.5 * half_air;
        hatch = 1.0;
    }
    return color_behind_air(seen, ray, share) * hatch;
}
#else
vec3 color_seen(vec4 color) { return color.a > kSky ? sky_color() : color.rgb; }
#endif

#ifdef SKY
#ifdef CODED
void main() { FRAGMENT_COLOR = vec4(table_at(vec2(sky_column(), 1.0)).rgb * ground_hatch_here(), left.y); }
#else
void main() { FRAGMENT_COLOR = vec4(sky_color(), left.y); }
#endif
#else
#ifdef OUTLINED
// Beyond the step at which a line begins; to the sides of each of two directions.
float jump(vec2 last, vec2 next) {
    vec2 nearer = max(next - 2.0 * abs(last), last - 2.0 * abs(next)) - outline.y;
    vec2 farther = max(-next - 2.0 * abs(last), -last - 2.0 * abs(next)) - outline.y;
    vec2 most = max(nearer, 0.5 * farther);
    return max(most.x, most.y);
}
#endif

void main() {
    vec4 here = scene_here();
    vec3 color = color_seen(here);
#ifdef OUTLINED
    vec4 around = distances_around() - here.a;
    color = mix(color, line_color, clamp(jump(around.xz, around.yw) * outline.z, 0.0, 1.0) * outline.x);
#endif
    FRAGMENT_COLOR = vec4(color, clamp(here.a, left.x, left.y));
}
#endif
