// Terrain: texture, data on the ground and warning colours, then shade, sketch, lines of known spacing, then air or haze. The
// defines at the top name the techniques of the style; what no technique asks for is not there. Follows terrain_ground.frag,
// terrain_texture.frag, terrain_shade.frag and terrain_sketch.frag.
#ifdef SURFACE_GRID
uniform vec4 grid_look;          // colour and strength of the lines
uniform vec2 grid_spacing;       // metres east, north
VARYING vec2 v_grid;
#endif
#if defined(SHAFTS) || defined(FOCUS_BLUR)
uniform vec2 left;               // least and most of the distance's code that alpha takes
#endif
uniform vec3 unknown_color;
#ifdef GROUND_DATA
uniform vec3 missing_color;      // of data
#endif
uniform vec3 haze_color;
#ifdef WARNING_BANDS
uniform vec4 band_color[WARNING_BANDS];      // alpha: strength
uniform float band_lower[WARNING_BANDS];     // height above MSL from which the band holds, ascending
#endif

/// Colour and, in alpha, strength; the alert zone wins over all bands.
vec4 warning_band() {
    vec4 band = vec4(0.0);
#ifdef WARNING_BANDS
    // From the lowest band up, so that the highest that holds wins; bands that are not used start at 1e9 m.
    for (int b = 0; b < WARNING_BANDS; ++b) band = v_height >= band_lower[b] ? band_color[b] : band;
#endif
#ifdef ALERT_ZONE
    float alert = alert_at(v_alert, v_height);
    if (alert > 0.5) band = alert > 1.5 ? alert_zone[4] : alert_zone[5];
#endif
    return band;
}

vec3 with_ground_data(vec3 color, Ground ground) {
#ifdef GROUND_DATA
    if (data_look.w > 0.5) {
        vec4 data = data_at(v_data);
        color = with_data(color, data, plain_color, missing_color, v_ground, ground.pixel_m);
#ifdef DATA_OVERLAY
        color = with_overlay(color, data, ground.n, ground.ray, ground.facing, v_ground, ground.pixel_m);
#endif
    }
#endif
    return color;
}

/// Share of the first light that shadows of data take away; no shadow makes a warning darker.
float hidden_at(float is_plain) {
#ifdef SHADOWS
    float hidden = shadow_look.x > 0.0 ? shadow_look.x * shadow_at(v_shadow.xyz, v_shadow.w) : 0.0;
    return hidden * is_plain;
#else
    return 0.0;
#endif
}

vec3 with_grid(vec3 color, Ground ground, float is_plain) {
#ifdef SURFACE_GRID
    vec2 from_line = (fract(v_grid + 0.5) - 0.5) * grid_spacing;
    vec3 n = ground.n, ray = ground.ray;
    float east_m = reach_of(vec3(1.0, 0.0, 0.0), n, ray, ground.facing, ground.pixel_m);
    float north_m = reach_of(vec3(0.0, 1.0, 0.0), n, ray, ground.facing, ground.pixel_m);
    float meridian = grid_line(from_line.x, grid_spacing.x, east_m);
    float parallel = grid_line(from_line.y, grid_spacing.y, north_m);
    color = mix(color, grid_look.rgb, grid_look.a * is_plain * max(meridian, parallel));
#endif
    return color;
}

#ifdef MAGNIFIED
/// `scale_edge`: of leave_other_parts().
vec3 with_scale_edge(vec3 color, Ground ground, vec3 scale_edge) {
    float pixel_m = reach_of(vec3(scale_edge.xy, 0.0), ground.n, ground.ray, ground.facing, ground.pixel_m);
    float from_edge_px = abs(scale_edge.z) / pixel_m;
    color = mix(color, vec3(0.0), 0.5 * clamp(3.0 - from_edge_px, 0.0, 1.0));
    return mix(color, vec3(1.0), clamp(1.5 - from_edge_px, 0.0, 1.0));
}
#endif

/// Unknown ground keeps half of its colour.
vec3 through_distance(vec3 color, Ground ground, float unknown) {
#ifdef AIR
    return mix(through_air(color, v_ray / ground.distance_m, ground.distance_m), color, 0.5 * unknown);
#elif !defined(FINE_DISTANCE)
    return mix(color, haze_color, v_haze * (1.0 - 0.5 * unknown));
#else
    return color;
#endif
}

#ifdef SHAFTS
/// In steps that four pixels of the shafts share out: one is 3.6 % of the distance, which else would be seen as a line.
float shaft_distance_code(float distance_m) {
    vec2 place = mod(floor(gl_FragCoord.xy * 0.5), 2.0);
    return log2(1.0 + distance_m / 50.0) / 13.0 + (mod(place.x + place.y, 2.0) * 0.5 + place.y * 0.25 - 0.375) / 255.0;
}
#endif

#ifdef DEFERRED
void shade_ground() {
#else
void main() {
#endif
#ifdef MAGNIFIED
    vec3 scale_edge = leave_other_parts();
#endif
    Ground ground = ground_here();
    vec3 color = textured(ground);
    vec4 band = warning_band();
    float is_plain = step(band.a, 0.0);  // neither sky light nor lines make a warning darker
#ifdef FOCI
    vec4 rim;
    bool is_marked = band.a > 0.0 || v_class.y > 0.0;
    float focused = focus_degree(ground.n, ground.bare, ground.ray, ground.pixel_m, is_marked, rim);
    color = in_context(color, mix(plain_color, sea_color, ground.sea), focused);
#endif
    color = with_ground_data(color, ground);
#ifdef WARNING_BANDS
    color = mix(color, band.rgb, band.a);
#endif
    Shade shade = shade_of(ground, hidden_at(is_plain), is_plain);
#ifdef FOCUS_SKETCH
    if (focused < 1.0) shade.lit = mix(vec3(1.0), shade.lit, detail_at(focused));
    shade.shine *= detail_at(focused);
#endif
#if defined(SHADED) || (defined(SHADOWS) && !defined(LIGHTS))
    color = color * shade.lit + shade.shine * (1.0 - 0.5 * ground.sea);
#endif
    color = sketched(color, ground, shade.direct);
    color = with_grid(color, ground, is_plain);
#ifdef MAGNIFIED
    color = with_scale_edge(color, ground, scale_edge);
#endif
    float unknown = step(0.001, v_class.y);  // whatever the style
    color = mix(color, unknown_color * hatch_at(gl_FragCoord.xy), unknown);
#ifdef FOCI
    color = color * (1.0 - rim.a) + rim.rgb;
#endif
    color = through_distance(color, ground, unknown);
#if defined(SHAFTS)
    float code = shaft_distance_code(ground.distance_m) * is_plain;  // no shaft of shade before a warning
    FRAGMENT_COLOR = vec4(color, clamp(min(code, 254.0 / 255.0), left.x, left.y));
#elif defined(FOCUS_BLUR)
    FRAGMENT_COLOR = vec4(color, clamp(sharpness_code(max(focused, rim.a)), left.x, left.y));
#elif defined(FINE_DISTANCE)
    FRAGMENT_COLOR = with_fine_distance(color, ground.distance_m, unknown);
#elif defined(DISTANCE_IN_ALPHA)
    FRAGMENT_COLOR = vec4(color, min(log2(1.0 + ground.distance_m / 50.0) / 13.0, 254.0 / 255.0));  // 255 is the sky
#else
    FRAGMENT_COLOR = vec4(color, 1.0);
#endif
}
