// The picture of what was drawn off-screen: sky where nothing was, colours for codes (CODED), and silhouettes (OUTLINED)
// where the next pixel lies much farther away than the slope of the surface explains: the near one is inked, and the far
// one half. Follows sky_color.frag.
//
// ES 3 fetches texels by their place, which a processor without texture units does several times as fast.
uniform sampler2D scene;       // alpha codes the logarithm of the distance; 1 where nothing was drawn
uniform vec2 scene_size;       // texels
#ifdef OUTLINED
uniform vec3 line_color;
uniform vec3 outline;          // strength; code steps at which a line begins and is full
#endif
#ifdef CODED
uniform sampler2D color_table; // colours by code: color_table.hpp
uniform vec3 haze_color;
#ifdef HATCHED
uniform vec3 unknown_color;
#endif
#endif

VARYING vec2 v_at;

#ifdef LANE_ES3
vec4 scene_at(int right, int up) {
    return texelFetch(scene, clamp(ivec2(gl_FragCoord.xy) + ivec2(right, up), ivec2(0), ivec2(scene_size) - 1), 0);
}
#else
vec4 scene_at(int right, int up) { return TEXTURE2D(scene, v_at + vec2(float(right), float(up)) / scene_size); }
#endif

#ifdef CODED
#ifdef LANE_ES3
vec4 table_at(vec2 code) { return texelFetch(color_table, ivec2(code * 255.0 + 0.5), 0); }
#else
vec4 table_at(vec2 code) { return TEXTURE2D(color_table, (code * 255.0 + 0.5) / 256.0); }
#endif
vec3 ground_seen(vec4 code) {
    vec3 color = table_at(code.gr).rgb * code.b;
    float haze = table_at(vec2(code.a, 1.0)).a;
#ifdef HATCHED
    // What is not known: hatched on the screen, whatever the style.
    float unknown = step(code.b, 0.002);
    float stripe = abs(fract((gl_FragCoord.x + gl_FragCoord.y) / 12.0) - 0.5) * 12.0;
    color = mix(color, unknown_color * mix(0.4, 1.0, clamp(stripe - 2.5, 0.0, 1.0)), unknown);
    haze *= 1.0 - 0.5 * unknown;
#endif
    return mix(color, haze_color, haze);
}
#else
vec3 ground_seen(vec4 color) { return color.rgb; }
#endif

#ifdef OUTLINED
float jump_between(float last, float next) {
    float nearer = max(next - 2.0 * abs(last), last - 2.0 * abs(next));
    float farther = max(-next - 2.0 * abs(last), -last - 2.0 * abs(next));
    return max(nearer, outline.y + 0.5 * (farther - outline.y));
}
#endif

void main() {
    vec4 here = scene_at(0, 0);
    vec3 color = here.a > 254.5 / 255.0 ? sky_color() : ground_seen(here);
#ifdef OUTLINED
    float most = max(jump_between(scene_at(-1, 0).a - here.a, scene_at(1, 0).a - here.a),
                     jump_between(scene_at(0, -1).a - here.a, scene_at(0, 1).a - here.a));
    color = mix(color, line_color, clamp((most - outline.y) * outline.z, 0.0, 1.0) * outline.x);
#endif
    FRAGMENT_COLOR = vec4(color, 1.0);
}
