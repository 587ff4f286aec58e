// Terrain: texture, then shade, then sketch, then haze. The defines at the top name the techniques of the style; what no
// technique asks for is not there. BAKED: the chunk's attribute pages are bound, else the vertex normal must do. DEFERRED: its
// varyings are variables that terrain_deferred.frag fills in.
#ifdef MAP_FORM
uniform sampler2D form_map;      // normal east, normal north, sky view, curvature
#endif
#ifdef MAP_LIGHT
uniform sampler2D light_map;     // light, openness, local relief, class
#endif
#ifdef MAP_APERTURE
uniform sampler2D aperture_map;  // aperture east, north, cosine of its radius, negative openness
#endif
#ifdef MAP_HORIZON
uniform sampler2D horizon_map;   // root of the horizon's sine towards the light
#endif
#ifdef PALETTE
#ifndef FOCI
uniform sampler2D palette;       // colour by the texture's quantity
#endif
uniform vec2 palette_range;      // lowest value, 1 / (highest - lowest)
#endif
#ifdef SURFACE_GRID
uniform vec4 grid_look;          // colour and strength of the lines
uniform vec2 grid_spacing;       // metres east, north
VARYING vec2 v_grid;
#endif
#if defined(SHAFTS) || defined(FOCUS_BLUR)
uniform vec2 left;               // least and most of the distance's code that alpha takes
#endif
uniform vec3 plain_color;
uniform vec3 sea_color;
uniform vec3 unknown_color;
#ifdef GROUND_DATA
uniform vec3 missing_color;      // of data
#endif
uniform vec3 haze_color;
uniform vec2 pixel;              // metres a pixel per metre of distance; strokes apart on the screen, pixels
#ifdef LIGHTS
uniform vec4 lights[LIGHTS];     // towards each: east, north, up; its weight
uniform vec4 light;              // ambient, 1 - ambient, highlight, its exponent
#ifdef LIGHT_COLORS
uniform vec3 light_color[LIGHTS];
uniform vec3 ambient_color;
#endif
#endif
#ifdef OCCLUSION
uniform vec2 occlusion;          // strength of sky view and of openness
#endif
#ifdef SKETCH
uniform vec3 line_color;
uniform vec4 form_lines;         // strength of ridges, valleys, suggestive contours, contours
uniform vec2 contour;            // 1 / interval, lines per index line
uniform vec2 strokes;            // strength of hatching, stippling
#endif
#ifdef BAKED
uniform vec4 page_origin;        // first texel of the page in the atlas of maps and in that of horizons
uniform vec2 page_scale;         // 1 / size of each
uniform vec2 page_texel;         // metres east and south of a texel
#endif
#ifdef COAST
uniform float coast_sharp;       // 1: the class of the nearest texel, 0: filtered
#endif
#ifdef WARNING_BANDS
uniform vec4 band_color[WARNING_BANDS];      // alpha: strength
uniform float band_lower[WARNING_BANDS];     // height above MSL from which the band holds, ascending
#endif

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

#ifdef BAKED
vec2 map_place(vec2 texels) { return (whole(texels) + page_origin.xy) * page_scale.x; }
#endif

#ifdef STROKES
float hash(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.547); }
#endif

#ifdef PALETTE
vec3 palette_color(float value) {
    float level = clamp((value - palette_range.x) * palette_range.y, 0.0, 1.0);
    return TEXTURE2D(palette, vec2(level * (1023.0 / 1024.0) + 0.5 / 1024.0, 0.25)).rgb;
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
    float distance_m = length(v_eye);
    vec3 ray = v_eye / distance_m;
    float pixel_m = distance_m * pixel.x;  // at right angles to the ray
#ifdef MAP_FORM
    vec4 form = TEXTURE2D(form_map, map_place(v_page));
    vec3 n = normal_of(form.xy);
#else
    vec3 n = normalize(v_normal);
#endif
    float facing = max(-dot(n, ray), 0.03);
#ifdef MAP_LIGHT
    vec4 baked = TEXTURE2D(light_map, map_place(v_page));
#endif

    // -- texture
    vec3 color = plain_color;
#if defined(TEXTURE_HYPSOMETRIC)
    color = palette_color(v_height);
#elif defined(TEXTURE_SLOPE)
    color = palette_color(atan(length(n.xy), max(n.z, 0.0)));
#elif defined(TEXTURE_RELIEF) && defined(MAP_LIGHT)
    color = palette_color(1000.0 * signed_root(baked.b));
#elif defined(TEXTURE_OPENNESS) && defined(MAP_LIGHT)
    color = palette_color((1.0 + signed_root(baked.g)) * 1.5707963);
#elif defined(TEXTURE_IMAGE) && defined(MAP_DRAPE)
    vec4 image = drape_of(v_drape, n);
    color = color * (1.0 - image.a) + image.rgb;
#elif defined(TEXTURE_MATERIAL)
    color = natural_ground(palette_color(v_height), v_height, n, v_ground, pixel_m * inversesqrt(facing));
#endif
#ifdef COAST
    // Triangles are larger than bays; classes have codes 0, 1/3 (sea), 2/3 and 1.
    float class_here = TEXTURE2D(light_map, map_place(mix(v_page, floor(v_page + 0.5), coast_sharp))).a;
    float sea = step(0.16667, class_here) * step(class_here, 0.5);
    // Up to half a texel off the coast water is lighter.
    float shore = sea * clamp(2.0 - 6.0 * class_here, 0.0, 1.0) * (1.0 - coast_sharp);
#else
    float sea = step(0.999, v_class.x), shore = 0.0;
#endif
    color = mix(color, mix(sea_color, vec3(1.0), 0.25 * shore), sea);
    vec4 band = vec4(0.0);
#ifdef WARNING_BANDS
    // From the lowest band up, so that the highest that holds wins; bands that are not used start at 1e9 m.
    for (int b = 0; b < WARNING_BANDS; ++b) band = v_height >= band_lower[b] ? band_color[b] : band;
#endif
#ifdef ALERT_ZONE
    float alert = alert_at(v_alert, v_height);  // wins over all bands
    if (alert > 0.5) band = alert > 1.5 ? alert_zone[4] : alert_zone[5];
#endif
#ifdef FOCI
    vec4 rim;
    float focused = focus_degree(n, normalize(v_normal), ray, pixel_m, band.a > 0.0 || v_class.y > 0.0, rim);
    color = in_context(color, mix(plain_color, sea_color, sea), focused);
#endif
#ifdef GROUND_DATA
    if (data_look.w > 0.5) {
        vec4 data = data_at(v_data);
        color = with_data(color, data, plain_color, missing_color, v_ground, pixel_m);
#ifdef DATA_OVERLAY
        color = with_overlay(color, data, n, ray, facing, v_ground, pixel_m);
#endif
    }
#endif
#ifdef WARNING_BANDS
    color = mix(color, band.rgb, band.a);
#endif

    // -- shade
    vec3 lit = vec3(1.0);
    vec3 shine = vec3(0.0);
#ifdef SHADOWS
    float hidden = shadow_look.x > 0.0 ? shadow_look.x * shadow_at(v_shadow.xyz, v_shadow.w) : 0.0;
#ifdef WARNING_BANDS
    hidden *= step(band.a, 0.0);  // no shadow makes a warning darker
#endif
#endif
#ifdef LIGHTS
    float first_seen = 1.0;  // share of the first light that no land hides
#ifdef MAP_HORIZON
    float root = TEXTURE2D(horizon_map, (whole(v_page) * 0.5 + page_origin.zw) * page_scale.y).r;
    // The sun's disc is half a degree wide.
    first_seen = clamp((lights[0].z - root * root) * 115.0 + 0.5, 0.0, 1.0);
#endif
#ifdef SHADOWS
    first_seen *= 1.0 - hidden;
#endif
    float direct = 0.0;
    vec3 first_color = vec3(1.0), ambient = vec3(light.x), glow = vec3(0.0);
    for (int k = 0; k < LIGHTS; ++k) {
        float share = lights[k].w * max(dot(n, lights[k].xyz), 0.0) * (k == 0 ? first_seen : 1.0);
        direct += share;
#ifdef LIGHT_COLORS
        glow += share * light_color[k];
#endif
    }
#ifdef LIGHT_COLORS
    first_color = light_color[0];
    ambient *= ambient_color;
#else
    glow = vec3(direct);
#endif
#if defined(SHADE_LIGHT_MAP) && defined(MAP_LIGHT)
    lit = vec3(baked.r * 1.25);
#ifdef SHADOWS
    lit *= 1.0 - 0.6 * hidden;
#endif
#elif defined(SHADE_APERTURE) && defined(MAP_APERTURE)
    vec4 aperture = TEXTURE2D(aperture_map, map_place(v_page));
    vec3 opening = normal_of(aperture.xy);
    float radius = acos(clamp(aperture.z, 0.0, 1.0));
    float apart = acos(clamp(dot(opening, lights[0].xyz), -1.0, 1.0));
    // Share of a soft light of 17 degrees that stands in the opening; the sky light falls with the opening's cap.
    float seen = 1.0 - smoothstep(radius - 0.3, radius + 0.3, apart);
#ifdef SHADOWS
    seen *= 1.0 - hidden;
#endif
    lit = ambient * (1.0 - aperture.z) + light.y * seen * max(dot(n, lights[0].xyz), 0.0) * first_color;
#else
    lit = ambient + light.y * glow;
#endif
#ifdef SHADE_PHONG
    float mirrored = max(dot(reflect(ray, n), lights[0].xyz), 0.0);
    shine = light.z * pow(mirrored, light.w) * step(0.0001, direct) * first_color;
#endif
#endif
    float is_plain = step(band.a, 0.0);  // neither sky light nor lines make a warning darker
#if defined(OCCLUSION) && defined(MAP_FORM)
    lit *= mix(1.0, form.z * form.z * form.z * form.z, occlusion.x * is_plain);
#endif
#if defined(OCCLUSION) && defined(MAP_LIGHT)
    lit *= mix(1.0, smoothstep(0.65, 1.0, 1.0 + signed_root(baked.g)), occlusion.y * is_plain);
#endif
#if defined(SHADOWS) && !defined(LIGHTS)
    lit *= 1.0 - 0.6 * hidden;  // a style without a light: as under a sky that keeps two fifths
#endif
#ifdef FOCUS_SKETCH
    if (focused < 1.0) lit = mix(vec3(1.0), lit, detail_at(focused));
    shine *= detail_at(focused);
#endif
#if defined(SHADED) || (defined(SHADOWS) && !defined(LIGHTS))
    color = color * lit + shine * (1.0 - 0.5 * sea);
#endif

    // -- sketch
#ifdef SKETCH
    float ink = 0.0;
    vec3 bare = normalize(v_normal);
#ifdef CONTOURS
    float rise = shorter_reach(vec3(0.0, 0.0, 1.0), n, bare, ray, pixel_m);
    float per_pixel = max(rise, 1e-3) * contour.x;
    float phase = v_height * contour.x;
    float line = floor(phase + 0.5);
    float strong = step(abs(line - contour.y * floor(line / contour.y + 0.5)), 0.25);
    float width = 0.6 + 0.6 * strong;
#ifdef ILLUMINATED
    float bright = clamp(dot(normalize(n.xy + vec2(1e-6)), normalize(lights[0].xy + vec2(1e-6))), -1.0, 1.0);
    width *= 0.5 + abs(bright);
#endif
    float stroke = clamp(width + 0.5 - abs(phase - line) / per_pixel, 0.0, 1.0) * clamp(1.5 - 3.0 * per_pixel, 0.0, 1.0);
    stroke *= form_lines.w * (0.55 + 0.45 * strong) * (1.0 - sea) * smoothstep(0.02, 0.06, length(n.xy));
#ifdef ILLUMINATED
    color = mix(color, bright > 0.0 ? vec3(1.0) : line_color, stroke);
#else
    ink = max(ink, stroke);
#endif
#endif
#if defined(FORM_LINES) && defined(MAP_FORM)
    // Ridges and valleys of heights (Eberly 1996, section 4.2): lines where the ground does not fall along the direction in
    // which it bends most. The bend, per metre, comes from four normals round the point.
    float reach_texels = 1.5;
    vec2 inner = clamp(v_page, reach_texels, 64.0 - reach_texels);
    vec2 west = TEXTURE2D(form_map, map_place(inner - vec2(reach_texels, 0.0))).xy;
    vec2 east = TEXTURE2D(form_map, map_place(inner + vec2(reach_texels, 0.0))).xy;
    vec2 north = TEXTURE2D(form_map, map_place(inner - vec2(0.0, reach_texels))).xy;
    vec2 south = TEXTURE2D(form_map, map_place(inner + vec2(0.0, reach_texels))).xy;
    vec2 bend_east = (east - west) * (kSigned / 3.0) / page_texel.x;
    vec2 bend_north = (north - south) * (kSigned / 3.0) / page_texel.y;
    float twist = 0.5 * (bend_east.y + bend_north.x);
    float mean = 0.5 * (bend_east.x + bend_north.y), half_gap = 0.5 * (bend_east.x - bend_north.y);
    float most = mean + (mean < 0.0 ? -1.0 : 1.0) * sqrt(half_gap * half_gap + twist * twist);
    vec2 way = abs(most - bend_north.y) > abs(most - bend_east.x) ? vec2(most - bend_north.y, twist)
                                                                  : vec2(twist, most - bend_east.x);
    way /= max(length(way), 1e-9);
    float away_m = dot(n.xy, way) / (most + (most < 0.0 ? -1e-6 : 1e-6));
    float fold = line_at(away_m, shorter_reach(vec3(way, 0.0), n, bare, ray, pixel_m), 0.8);
    float sharp = abs(most) * sqrt(page_texel.x * page_texel.y);
    ink = max(ink, fold * (most > 0.0 ? form_lines.x : form_lines.y) * smoothstep(0.06, 0.14, sharp));
#endif
#if defined(SUGGESTIVE) && defined(MAP_FORM)
    // Where radial curvature, the bend of the ground along the view, falls through zero away from the eye (DeCarlo et al. 2003,
    // section 3). The bend, over six texels, is taken at two places half a texel or a pixel before and beyond the point: their
    // difference says how steeply it falls, and where it is zero. Lines fade where it falls slowly or the ground faces the eye:
    // there they would be blots of noise.
    vec2 along = normalize(ray.xy + vec2(1e-6));
    float texel_m = min(page_texel.x, page_texel.y);
    float reach_m = shorter_reach(vec3(along, 0.0), n, bare, ray, pixel_m);
    float apart = clamp(reach_m / texel_m, 0.5, 2.0);
    vec2 texel_on = vec2(along.x, -along.y) / page_texel * texel_m;
    vec2 far_off = texel_on * (3.0 + apart), near_off = texel_on * (3.0 - apart);
    vec2 centre = clamp(v_page, abs(far_off), 64.0 - abs(far_off));
    float far_before = dot(TEXTURE2D(form_map, map_place(centre - far_off)).xy * kSigned - kZero, along);
    float before = dot(TEXTURE2D(form_map, map_place(centre - near_off)).xy * kSigned - kZero, along);
    float after = dot(TEXTURE2D(form_map, map_place(centre + near_off)).xy * kSigned - kZero, along);
    float far_after = dot(TEXTURE2D(form_map, map_place(centre + far_off)).xy * kSigned - kZero, along);
    float nearer = after - far_before, farther = far_after - before;
    float fall = (nearer - farther) / (2.0 * apart);  // a texel
    float off_centre = dot((v_page - centre) * page_texel, vec2(along.x, -along.y)) / texel_m;
    float zero = (0.5 * (nearer + farther) - fall * off_centre) / max(fall, 1e-5);  // texels on
    float turned_away = smoothstep(0.5, 0.3, facing);
    ink = max(ink, form_lines.z * turned_away * smoothstep(0.03, 0.07, fall) * line_at(zero * texel_m, reach_m, 0.8));
#endif
#if defined(HATCHING) || defined(STIPPLING)
    // Level ground stays light, slopes turned away from the light become dark.
    float level = 0.0;
    for (int k = 0; k < LIGHTS; ++k) level += lights[k].w * max(lights[k].z, 0.0);
    float dark = clamp(0.1 + 1.2 * (level - direct) / max(level, 0.1), 0.0, 1.0) * (1.0 - sea);
    // Strokes lie on the ground; their distance there doubles with the distance from the eye, two sizes cross-fade.
    float octave = log2(max(pixel_m * pixel.y, 1.0));
    float size = exp2(floor(octave));
    float fade = fract(octave);
#ifdef HATCHING
    vec2 down = normalize(n.xy + vec2(1e-6));
    float sector = floor(atan(down.y, down.x) * 2.5464791 + 0.5) * 0.39269908;  // eight directions are enough to follow slopes
    vec2 across = vec2(-sin(sector), -cos(sector));
    float at = dot(v_ground, across);
    float fine = abs(fract(at / size) - 0.5) * 2.0;
    float coarse = abs(fract(at / (2.0 * size)) - 0.5) * 2.0;
    float edge = 0.35;
    float tone = dark * smoothstep(0.03, 0.3, length(n.xy));  // from hardly sloping to 17 degrees
    ink = max(ink, strokes.x * smoothstep(1.0 - tone, 1.0 - tone + edge, mix(fine, coarse, fade)) * step(0.04, tone));
#endif
#ifdef STIPPLING
    // Two sizes of cells, turned against the compass and each other; the dots of one grow while the others' vanish.
    for (int o = 0; o < 2; ++o) {
        vec2 place = (o == 0 ? mat2(0.8, 0.6, -0.6, 0.8) * v_ground : mat2(0.6, -0.8, 0.8, 0.6) * v_ground / 2.0) / size;
        vec2 cell = floor(place);
        vec2 dot_at = vec2(hash(cell), hash(cell + 37.0)) * 0.6 + 0.2;
        float radius = 0.42 * sqrt(dark * (o == 0 ? 1.0 - fade : fade));
        float away = length(place - cell - dot_at);
        ink = max(ink, strokes.y * (1.0 - smoothstep(0.75, 1.15, away / max(radius, 1e-3))) * smoothstep(0.04, 0.1, radius));
    }
#endif
#endif
    color = mix(color, line_color, ink);
#endif

    // -- lines of known spacing
#ifdef SURFACE_GRID
    vec2 from_line = (fract(v_grid + 0.5) - 0.5) * grid_spacing;
    float meridian = grid_line(from_line.x, grid_spacing.x, reach_of(vec3(1.0, 0.0, 0.0), n, ray, facing, pixel_m));
    float parallel = grid_line(from_line.y, grid_spacing.y, reach_of(vec3(0.0, 1.0, 0.0), n, ray, facing, pixel_m));
    color = mix(color, grid_look.rgb, grid_look.a * is_plain * max(meridian, parallel));
#endif

    // -- where the scale changes
#ifdef MAGNIFIED
    float from_edge_px = abs(scale_edge.z) / reach_of(vec3(scale_edge.xy, 0.0), n, ray, facing, pixel_m);
    color = mix(color, vec3(0.0), 0.5 * clamp(3.0 - from_edge_px, 0.0, 1.0));
    color = mix(color, vec3(1.0), clamp(1.5 - from_edge_px, 0.0, 1.0));
#endif

    // -- what is not known, whatever the style
    float unknown = step(0.001, v_class.y);
    color = mix(color, unknown_color * hatch_at(gl_FragCoord.xy), unknown);
#ifdef FOCI
    color = color * (1.0 - rim.a) + rim.rgb;
#endif
#ifdef AIR
    color = mix(through_air(color, v_ray / distance_m, distance_m), color, 0.5 * unknown);
#elif !defined(FINE_DISTANCE)
    color = mix(color, haze_color, v_haze * (1.0 - 0.5 * unknown));
#endif
#ifdef SHAFTS
    // In steps that four pixels of the shafts share out: one is 3.6 % of the distance, which else would be seen as a line.
    vec2 place = mod(floor(gl_FragCoord.xy * 0.5), 2.0);
    float code = log2(1.0 + distance_m / 50.0) / 13.0 + (mod(place.x + place.y, 2.0) * 0.5 + place.y * 0.25 - 0.375) / 255.0;
#ifdef WARNING_BANDS
    code *= step(band.a, 0.0);  // no shaft of shade before a warning
#endif
    FRAGMENT_COLOR = vec4(color, clamp(min(code, 254.0 / 255.0), left.x, left.y));
#elif defined(FOCUS_BLUR)
    FRAGMENT_COLOR = vec4(color, clamp(sharpness_code(max(focused, rim.a)), left.x, left.y));
#elif defined(FINE_DISTANCE)
    FRAGMENT_COLOR = with_fine_distance(color, distance_m, unknown);
#elif defined(DISTANCE_IN_ALPHA)
    FRAGMENT_COLOR = vec4(color, min(log2(1.0 + distance_m / 50.0) / 13.0, 254.0 / 255.0));  // 255 is the sky
#else
    FRAGMENT_COLOR = vec4(color, 1.0);
#endif
}
