// What terrain.frag reads of a place of the ground, from what vertices state of it. In the vertex shader of the terrain, before
// terrain.vert; in deferred shading (DEFERRED) in the fragment shader, behind terrain.frag, whose varyings are plain variables
// there. Follows alert_place.vert.
uniform float haze_per_m;      // 1 / distance, 0 for none
#ifdef BAKED
uniform vec4 page_window;      // texels of the page = place * xy + zw
#endif
#ifdef MAP_DRAPE
uniform vec3 drape_window;     // texels of the page = place * x + yz
#endif
// In deferred shading ground_overlay.frag, which reads these two for contours and halos, has declared them.
#if !(defined(DEFERRED) && (defined(DATA_CONTOUR) || defined(DATA_HALO)))
#ifdef GROUND_DATA
uniform vec4 data_window;      // posts of the field = place * xy + zw
#endif
#ifdef STROKES
uniform vec4 stroke_window;    // metres east and south, modulo a whole number of strokes = place * xy + zw
#endif
#endif
#ifdef SURFACE_GRID
uniform vec4 grid_window;      // lines east and south of the first one = place * xy + zw
#endif
#ifdef FOCI
uniform vec4 focus_axes[2 * FOCI];  // east, north of each focus: metres from its anchor = dot(xyz, place) + w
#endif
#ifdef SHADOWS
uniform vec4 shadow_axes[3];   // places in the light's frame, m = dot(xyz, place) + w
#endif

#ifndef DEFERRED
VARYING float v_height;
VARYING vec2 v_class;          // sea, void
VARYING vec3 v_normal;         // east, north, up
VARYING vec3 v_eye;            // from the eye, east, north, up, m
#ifdef AIR
VARYING vec3 v_ray;            // from the eye, ECEF, m
#elif !defined(FINE_DISTANCE)
VARYING float v_haze;
#endif
#ifdef BAKED
VARYING vec2 v_page;
#endif
#ifdef MAP_DRAPE
VARYING vec2 v_drape;
#endif
#ifdef GROUND_DATA
VARYING vec2 v_data;
#endif
#ifdef STROKES
VARYING vec2 v_ground;
#endif
#ifdef SURFACE_GRID
VARYING vec2 v_grid;
#endif
#ifdef FOCI
VARYING vec2 v_focus[FOCI];
#endif
#ifdef SHADOWS
VARYING vec4 v_shadow;         // there; height over the sea
#endif
#endif

// `ground`: from the eye's whole metres, ECEF, as it is; `shown`: where it is shown; `local`: that in east, north, up.
void leave_varyings(vec3 ground, vec3 shown, vec3 local, vec3 local_normal, float msl_m, vec2 post_class, vec2 at) {
    v_height = msl_m;
    v_class = post_class;
    v_normal = local_normal;
    v_eye = local;
#ifdef AIR
    v_ray = shown;
#elif !defined(FINE_DISTANCE)
    v_haze = 1.0 - exp(-length(shown) * haze_per_m);
#endif
#ifdef SHADOWS
    vec4 in_space = vec4(ground, 1.0);  // shadows fall on the ground as it is
    v_shadow.xyz = vec3(dot(shadow_axes[0], in_space), dot(shadow_axes[1], in_space), dot(shadow_axes[2], in_space));
#ifdef FLAT
    v_shadow.w = flat_height;
#else
    v_shadow.w = msl_m;
#endif
#endif
#ifdef FOCI
    for (int k = 0; k < FOCI; ++k)  // of the ground as it is, wherever it is shown
        v_focus[k] = vec2(dot(focus_axes[2 * k], vec4(ground, 1.0)), dot(focus_axes[2 * k + 1], vec4(ground, 1.0)));
#endif
#if defined(ALERT_ZONE) && defined(DEFERRED)
    v_alert = alert_place(ground);
#endif
#ifdef BAKED
    v_page = at * page_window.xy + page_window.zw;
#endif
#ifdef MAP_DRAPE
    v_drape = at * drape_window.x + drape_window.yz;
#endif
#ifdef GROUND_DATA
    v_data = at * data_window.xy + data_window.zw;
#endif
#ifdef SURFACE_GRID
    v_grid = at * grid_window.xy + grid_window.zw;
#endif
#ifdef STROKES
    v_ground = at * stroke_window.xy + stroke_window.zw;
#endif
}
