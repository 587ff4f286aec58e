// Light that shadows of data take from the air before the eye: draw/drawers/light_shafts.hpp. Follows shadow.frag, with AIR air.frag.
uniform sampler2D scene;        // alpha codes the logarithm of the distance; 1 is infinitely far
uniform vec4 shadow_axes[3];
uniform vec3 rays[3];           // forward; right and up to the picture's edges; ECEF
uniform vec3 caster_box[2];     // lowest and highest place of casters in the light's frame, m
uniform vec3 shaft_look;        // strength; steps; haze a metre
uniform vec3 haze_color;

VARYING vec2 v_at;

const float kFarthest = 200000.0;

// Between these ways along a ray it may lie in shadow; the first beyond the second: nowhere.
vec2 shaded_part(vec3 from, vec3 along, float end) {
    vec2 part = vec2(0.0, end);
    for (int n = 0; n < 2; ++n) {
        float per = 1.0 / (abs(along[n]) < 1e-6 ? 1e-6 : along[n]);
        vec2 ways = (vec2(caster_box[0][n], caster_box[1][n]) - from[n]) * per;
        part = vec2(max(part.x, min(ways.x, ways.y)), min(part.y, max(ways.x, ways.y)));
    }
    // Nothing shades what is nearer to the sun than all casters.
    float way = (caster_box[1].z - from.z) / (abs(along.z) < 1e-6 ? 1e-6 : along.z);
    return along.z > 0.0 ? vec2(part.x, min(part.y, way)) : vec2(max(part.x, way), part.y);
}

// What is taken of the light at a place, by the finest level that has it.
float shade_of(vec3 at) {
    int level = level_of(at.xy);
    if (level == 3 || shadow_levels[level].w < 0.5) return 0.0;
    vec2 caster = caster_at(texels_at(at.xy, level), level);
    return caster.x > at.z + kShadowBias ? caster.y : 0.0;
}

// Light scattered in over a way from the eye, before the picture's root; of haze in parts of its colour.
#ifdef AIR
vec3 light_over(vec3 ray, float way) { return air_light(ray, air_column(way)); }
#else
vec3 light_over(vec3 ray, float way) { return vec3(1.0 - exp(-way * shaft_look.z)); }
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float code = texelFetch(scene, min(pixel * 2, textureSize(scene, 0) - 1), 0).a;
    vec2 side = (vec2(pixel * 2) + 1.0) / vec2(textureSize(scene, 0)) * 2.0 - 1.0;
    vec3 ray = normalize(rays[0] + side.x * rays[1] + side.y * rays[2]);
    float end = code > 254.5 / 255.0 ? kFarthest : min(50.0 * (exp2(13.0 * code) - 1.0), kFarthest);
    vec3 from = vec3(shadow_axes[0].w, shadow_axes[1].w, shadow_axes[2].w);
    vec3 along = vec3(dot(shadow_axes[0].xyz, ray), dot(shadow_axes[1].xyz, ray), dot(shadow_axes[2].xyz, ray));
    vec2 part = shaded_part(from, along, end);
    vec3 lost = vec3(0.0);
    if (part.x < part.y) {
        // Four quarters, over each of which the light grows evenly; each of a quarter of the steps.
        int steps = max(int(shaft_look.y) / 4, 1);
        float step_m = (part.y - part.x) / float(4 * steps);
        float begin = (float((pixel.x & 1) * 2 + ((pixel.x ^ pixel.y) & 1)) + 0.5) / 4.0;
        vec3 before = light_over(ray, part.x);
        for (int quarter = 0; quarter < 4; ++quarter) {
            float shade = 0.0;
            for (int n = 0; n < steps; ++n) {
                float way = part.x + (float(quarter * steps + n) + begin) * step_m;
                shade += shade_of(from + along * way);
            }
            vec3 after = light_over(ray, part.x + float((quarter + 1) * steps) * step_m);
            lost += shade / float(steps) * (after - before);
            before = after;
        }
    }
#ifdef AIR
    FRAGMENT_COLOR = vec4(sqrt(clamp(lost * shaft_look.x * air_look.x, 0.0, 1.0)), code);
#else
    FRAGMENT_COLOR = vec4(clamp(lost * shaft_look.x * haze_color, 0.0, 1.0), code);
#endif
}
