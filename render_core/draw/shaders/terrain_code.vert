// Terrain as codes that picture.frag turns into colours, once a pixel instead of once a triangle and pixel: small triangles
// cost a rasterizer many fragments that are never seen. Follows terrain_place.vert and alert_place.vert.
uniform vec2 height_range;     // lowest height, 1 / (highest - lowest)
#ifdef LIGHTS
uniform vec4 lights[LIGHTS];   // towards each: east, north, up; its weight
uniform vec4 light;            // ambient, 1 - ambient
#endif

#ifdef COAST
uniform vec4 page_window;      // texels of the page = place * xy + zw
VARYING vec2 v_page;
#endif

VARYING vec3 v_code;           // height in steps of 1/254 of the range, light, distance
#ifdef CLASSES
VARYING vec2 v_class;          // sea, void
#endif
#ifdef ALERT_ZONE
VARYING float v_height;
#endif

const float kHighest = 1.0 - 1.0 / 65536.0;  // step 254 is the sea
const float kFarthest = 254.0 / 255.0;  // 255 is the sky

void main() {
    vec3 eye_relative = eye_relative_place();
    gl_Position = view_projection * vec4(eye_relative, 1.0);
    float lit = 1.0;
#ifdef LIGHTS
    vec3 n = to_local * normal;
    float direct = 0.0;
    for (int k = 0; k < LIGHTS; ++k) direct += lights[k].w * max(dot(n, lights[k].xyz), 0.0);
    lit = light.x + light.y * direct;
#endif
    v_code.x = clamp((height - height_range.x) * height_range.y, 0.0, kHighest) * 254.0;
    v_code.y = max(lit, 1.0 / 255.0);
    v_code.z = min(log2(1.0 + length(eye_relative) / 50.0) / 13.0, kFarthest);
#ifdef COAST
    v_page = place * page_window.xy + page_window.zw;
#endif
#ifdef CLASSES
    v_class = class_of_vertex();
#endif
#ifdef ALERT_ZONE
    v_alert = alert_place(position + chunk_offset);
    v_height = height;
#endif
}
