// Red and green: the height in steps of 1/254 of its range and of 1/255 of such a step; red 254/255 is the sea. Blue: light,
// 0 only where nothing is known. Alpha: the logarithm of the distance. With an alert (ALERT_ZONE) green has 85 steps, each three
// times: as it is, of caution, of warning. Follows alert_zone.frag.
#ifdef COAST
uniform sampler2D light_map;   // alpha: class
uniform vec4 page_origin;      // first texel of the page in the atlas
uniform vec2 page_scale;       // 1 / its size
uniform float coast_sharp;     // 1: the class of the nearest texel, 0: filtered
VARYING vec2 v_page;
#endif

VARYING vec3 v_code;
#ifdef CLASSES
VARYING vec2 v_class;
#endif
#ifdef ALERT_ZONE
VARYING float v_height;
#endif

void main() {
    float steps = floor(v_code.x);
    vec4 code = vec4(steps / 255.0, v_code.x - steps, v_code.y, v_code.z);
#ifdef CLASSES
#ifdef COAST
    // Triangles are larger than bays; classes have codes 0, 1/3 (sea), 2/3 and 1. Whole fractions of a texel: see terrain_image.frag.
    vec2 texel = floor(mix(v_page, floor(v_page + 0.5), coast_sharp) * 256.0 + 0.5) / 256.0;
    float class_here = TEXTURE2D(light_map, (texel + page_origin.xy) * page_scale.x).a;
    float sea = step(0.16667, class_here) * step(class_here, 0.5);
#else
    float sea = step(0.999, v_class.x);
#endif
    code.rg = mix(code.rg, vec2(254.0 / 255.0, 0.0), sea);
    code.b *= step(v_class.y, 0.001);
#endif
#ifdef ALERT_ZONE
    code.g = (3.0 * min(floor(code.g * 85.0), 84.0) + alert_at(v_alert, v_height)) / 255.0;
#endif
    FRAGMENT_COLOR = code;
}
