// Terrain in colour. Follows terrain_place.vert.
uniform float haze_per_m;      // 1 / distance, 0 for none
#ifdef BAKED
uniform vec4 page_window;      // texels of the page = place * xy + zw
VARYING vec2 v_page;
#endif
#ifdef MAP_DRAPE
uniform vec3 drape_window;     // texels of the page = place * x + yz
VARYING vec2 v_drape;
#endif
#ifdef GROUND_DATA
uniform vec4 data_window;      // posts of the field = place * xy + zw
VARYING vec2 v_data;
#endif
#ifdef STROKES
uniform vec4 stroke_window;    // metres east and south, modulo a whole number of strokes = place * xy + zw
VARYING vec2 v_ground;
#endif

#ifdef SURFACE_GRID
uniform vec4 grid_window;      // lines east and south of the first one = place * xy + zw
VARYING vec2 v_grid;
#endif

VARYING float v_height;
VARYING vec2 v_class;          // sea, void
VARYING vec3 v_normal;         // east, north, up
VARYING vec3 v_eye;            // from the eye, east, north, up, m
#ifdef AIR
VARYING vec3 v_ray;            // from the eye, ECEF, m
#elif !defined(FINE_DISTANCE)
VARYING float v_haze;
#endif

#ifdef FOCI
uniform vec4 focus_axes[2 * FOCI];  // east, north of each focus: metres from its anchor = dot(xyz, place) + w
VARYING vec2 v_focus[FOCI];
#endif

#ifdef SHADOWS
uniform vec4 shadow_axes[3];   // places in the light's frame, m = dot(xyz, place) + w
VARYING vec4 v_shadow;         // there; height over the sea
#endif

void main() {
    vec3 eye_relative = eye_relative_place();
    vec3 shown = eye_relative;
#ifdef MAGNIFIED
    shown = magnified(eye_relative);
#endif
    gl_Position = view_projection * vec4(shown, 1.0);
    v_height = height;
#ifdef ALERT_ZONE
    v_alert = alert_place();
#endif
    v_class = class_of_vertex();
    v_normal = to_local * normal;
    v_eye = to_local * shown;
#ifdef AIR
    v_ray = shown;
#elif !defined(FINE_DISTANCE)
    v_haze = 1.0 - exp(-length(shown) * haze_per_m);
#endif
#ifdef SHADOWS
    vec4 in_space = vec4(eye_relative, 1.0);  // shadows fall on the ground as it is
    v_shadow.xyz = vec3(dot(shadow_axes[0], in_space), dot(shadow_axes[1], in_space), dot(shadow_axes[2], in_space));
#ifdef FLAT
    v_shadow.w = flat_height;
#else
    v_shadow.w = height;
#endif
#endif
#ifdef FOCI
    for (int k = 0; k < FOCI; ++k)  // of the ground as it is, wherever it is shown
        v_focus[k] = vec2(dot(focus_axes[2 * k], vec4(eye_relative, 1.0)), dot(focus_axes[2 * k + 1], vec4(eye_relative, 1.0)));
#endif
#ifdef BAKED
    v_page = place * page_window.xy + page_window.zw;
#endif
#ifdef MAP_DRAPE
    v_drape = place * drape_window.x + drape_window.yz;
#endif
#ifdef GROUND_DATA
    v_data = place * data_window.xy + data_window.zw;
#endif
#ifdef SURFACE_GRID
    v_grid = place * grid_window.xy + grid_window.zw;
#endif
#ifdef STROKES
    v_ground = place * stroke_window.xy + stroke_window.zw;
#endif
}
