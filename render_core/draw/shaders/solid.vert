// Surfaces of spatial data. Follows data_light.vert.
VERTEX_IN vec3 place;            // ECEF from the piece's anchor, m
VERTEX_IN vec4 normal_unsure;    // normal -1..1 as 0..254; uncertainty 0..254, 255 unknown
VERTEX_IN vec4 color;

uniform vec3 anchor;             // from the eye, ECEF, m
uniform vec4 fading;             // lost transparency and saturation of the least sure; levels, 0 for continuous; grown since
uniform vec4 cover;              // opacity; metres to swell, and to raise, a metre of distance; metres nearer, in depth

VARYING float v_unknown;
#ifdef GRID
VARYING vec3 v_place;
VARYING vec3 v_normal;
#endif

void main() {
    vec3 normal = normal_unsure.xyz * (255.0 / 127.0) - 1.0;
    vec3 eye_relative = anchor + place;
#ifdef MAGNIFIED
    eye_relative = magnified(eye_relative);
#endif
#ifdef GRID
    v_place = place;
    v_normal = normal;
#endif
    eye_relative += normal * (cover.y + cover.z) * length(eye_relative);
    eye_relative *= 1.0 - min(cover.w / max(length(eye_relative), 1.0), 0.06);  // along the line of sight
    bool is_unknown = normal_unsure.w > 254.5 / 255.0;
    float unsure = is_unknown ? 0.0 : min(normal_unsure.w * (255.0 / 254.0) + fading.w, 1.0);
    v_unknown = is_unknown && fading.x + fading.y > 0.0 ? 1.0 : 0.0;
    if (fading.z > 0.5) unsure = floor(min(unsure, 0.9999) * fading.z) / (fading.z - 1.0);
    vec3 grey = vec3(dot(color.rgb, vec3(0.2126, 0.7152, 0.0722)));
    vec4 shown = vec4(mix(color.rgb, grey, unsure * fading.y), color.a * cover.x * (1.0 - unsure * fading.x));
    show(eye_relative, cover.y > 0.0 ? vec3(0.0) : normal, shown);
}
