// The ground at a pixel: what its varyings and the attribute pages of its chunk state. BAKED: the chunk's attribute pages are bound,
// else the normal of the vertices serves. DEFERRED: the varyings are variables that terrain_deferred.frag fills in.
#ifdef MAP_FORM
uniform sampler2D form_map;      // normal east, normal north, sky view, curvature
#endif
#ifdef MAP_LIGHT
uniform sampler2D light_map;     // light, openness, local relief, class
#endif
#ifdef BAKED
uniform vec4 page_origin;        // first texel of the page in the atlas of maps and in that of horizons
uniform vec2 page_scale;         // 1 / size of each
uniform vec2 page_texel;         // metres east and south of a texel
#endif
#ifdef COAST
uniform float coast_sharp;       // 1: the class of the nearest texel, 0: filtered
#endif
uniform vec2 pixel;              // metres a pixel per metre of distance; strokes apart on the screen, pixels

VARYING float v_height;
VARYING vec2 v_class;
VARYING vec3 v_normal;
VARYING vec3 v_eye;
#ifdef AIR
VARYING vec3 v_ray;
#elif !defined(FINE_DISTANCE)
VARYING float v_haze;
#endif
#ifdef BAKED
VARYING vec2 v_page;
#endif
#ifdef MAP_DRAPE
VARYING vec2 v_drape;
#endif
#ifdef STROKES
VARYING vec2 v_ground;
#endif
#ifdef SHADOWS
VARYING vec4 v_shadow;
#endif

struct Ground {
    float distance_m;  // from the eye point
    vec3 ray;          // from the eye point, of length 1
    float pixel_m;     // metres from a pixel to the next at this distance, at right angles to the ray
    vec3 bare;         // normal of the mesh
    vec3 n;            // normal of the attribute page, where there is one
    float facing;      // cosine between it and the way to the eye point, at least 0.03
    float sea;         // 1: water
    float shore;       // 1: water at the coast
#ifdef MAP_FORM
    vec4 form;         // texel of form_map
#endif
#ifdef MAP_LIGHT
    vec4 baked;        // texel of light_map
#endif
};

#ifdef BAKED
vec2 map_place(vec2 texels) { return (whole(texels) + page_origin.xy) * page_scale.x; }
#endif

void find_water(inout Ground ground) {
#ifdef COAST
    // Triangles are larger than bays; classes have codes 0, 1/3 (sea), 2/3 and 1.
    float class_here = TEXTURE2D(light_map, map_place(mix(v_page, floor(v_page + 0.5), coast_sharp))).a;
    ground.sea = step(0.16667, class_here) * step(class_here, 0.5);
    // Up to half a texel off the coast water is lighter.
    ground.shore = ground.sea * clamp(2.0 - 6.0 * class_here, 0.0, 1.0) * (1.0 - coast_sharp);
#else
    ground.sea = step(0.999, v_class.x);
    ground.shore = 0.0;
#endif
}

Ground ground_here() {
    Ground ground;
    ground.distance_m = length(v_eye);
    ground.ray = v_eye / ground.distance_m;
    ground.pixel_m = ground.distance_m * pixel.x;
    ground.bare = normalize(v_normal);
    ground.n = ground.bare;
#ifdef MAP_FORM
    ground.form = TEXTURE2D(form_map, map_place(v_page));
    ground.n = normal_of(ground.form.xy);
#endif
    ground.facing = max(-dot(ground.n, ground.ray), 0.03);
#ifdef MAP_LIGHT
    ground.baked = TEXTURE2D(light_map, map_place(v_page));
#endif
    find_water(ground);
    return ground;
}
