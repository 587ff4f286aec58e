// Lines and strokes that show the form of the ground: contours, ridges and valleys, suggestive contours, hatching, stippling.
// The functions return the coverage by their lines; sketched() returns the colour with all of them.
#ifdef SKETCH
uniform vec3 line_color;
uniform vec4 form_lines;         // strength of ridges, valleys, suggestive contours, contours
uniform vec2 contour;            // 1 / interval, lines per index line
uniform vec2 strokes;            // strength of hatching, stippling
#endif

#ifdef CONTOURS
/// Illuminated contours are drawn into the colour at once: they are light where they face the light.
float contour_lines(Ground ground, inout vec3 color) {
    float rise = shorter_reach(vec3(0.0, 0.0, 1.0), ground.n, ground.bare, ground.ray, ground.pixel_m);
    float per_pixel = max(rise, 1e-3) * contour.x;
    float phase = v_height * contour.x;
    float line = floor(phase + 0.5);
    float strong = step(abs(line - contour.y * floor(line / contour.y + 0.5)), 0.25);
    float width = 0.6 + 0.6 * strong;
#ifdef ILLUMINATED
    float bright =
        clamp(dot(normalize(ground.n.xy + vec2(1e-6)), normalize(lights[0].xy + vec2(1e-6))), -1.0, 1.0);
    width *= 0.5 + abs(bright);
#endif
    float stroke = clamp(width + 0.5 - abs(phase - line) / per_pixel, 0.0, 1.0) * clamp(1.5 - 3.0 * per_pixel, 0.0, 1.0);
    stroke *= form_lines.w * (0.55 + 0.45 * strong) * (1.0 - ground.sea) * smoothstep(0.02, 0.06, length(ground.n.xy));
#ifdef ILLUMINATED
    color = mix(color, bright > 0.0 ? vec3(1.0) : line_color, stroke);
    return 0.0;
#else
    return stroke;
#endif
}
#endif

#if defined(FORM_LINES) && defined(MAP_FORM)
/// Ridges and valleys of heights (Eberly 1996, section 4.2): lines where the ground does not fall along the direction in which it
/// bends most. The bend, per metre, comes from four normals round the point.
float ridges_and_valleys(Ground ground) {
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
    float away_m = dot(ground.n.xy, way) / (most + (most < 0.0 ? -1e-6 : 1e-6));
    float fold =
        line_at(away_m, shorter_reach(vec3(way, 0.0), ground.n, ground.bare, ground.ray, ground.pixel_m), 0.8);
    float sharp = abs(most) * sqrt(page_texel.x * page_texel.y);
    return fold * (most > 0.0 ? form_lines.x : form_lines.y) * smoothstep(0.06, 0.14, sharp);
}
#endif

#if defined(SUGGESTIVE) && defined(MAP_FORM)
/// Lines where radial curvature, the bend of the ground along the view, falls through zero away from the eye (DeCarlo et al. 2003,
/// section 3). The bend, over six texels, is taken at two places half a texel or a pixel before and beyond the point: their
/// difference is how steeply it falls, and gives where it is zero. Lines fade where it falls slowly or the ground faces the eye:
/// there they would be blots of noise.
float suggestive_contours(Ground ground) {
    vec2 along = normalize(ground.ray.xy + vec2(1e-6));
    float texel_m = min(page_texel.x, page_texel.y);
    float reach_m = shorter_reach(vec3(along, 0.0), ground.n, ground.bare, ground.ray, ground.pixel_m);
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
    float turned_away = smoothstep(0.5, 0.3, ground.facing);
    return form_lines.z * turned_away * smoothstep(0.03, 0.07, fall) * line_at(zero * texel_m, reach_m, 0.8);
}
#endif

#if defined(HATCHING) || defined(STIPPLING)
// Strokes lie on the ground; their distance there doubles with the distance from the eye, and two sizes are cross-faded.
struct Strokes {
    float dark;  // of the ground, 0..1
    float size;  // metres between strokes of the finer size
    float fade;  // share of the coarser size
};

/// Level ground stays light, slopes turned away from the light become dark. `direct`: light on the ground.
Strokes strokes_at(Ground ground, float direct) {
    float level = 0.0;
    for (int k = 0; k < LIGHTS; ++k) level += lights[k].w * max(lights[k].z, 0.0);
    float octave = log2(max(ground.pixel_m * pixel.y, 1.0));
    return Strokes(clamp(0.1 + 1.2 * (level - direct) / max(level, 0.1), 0.0, 1.0) * (1.0 - ground.sea), exp2(floor(octave)),
                   fract(octave));
}
#endif

#ifdef HATCHING
float hatching(Ground ground, Strokes by) {
    vec2 down = normalize(ground.n.xy + vec2(1e-6));
    float sector = floor(atan(down.y, down.x) * 2.5464791 + 0.5) * 0.39269908;  // eight directions are enough to follow slopes
    vec2 across = vec2(-sin(sector), -cos(sector));
    float at = dot(v_ground, across);
    float fine = abs(fract(at / by.size) - 0.5) * 2.0;
    float coarse = abs(fract(at / (2.0 * by.size)) - 0.5) * 2.0;
    float edge = 0.35;
    float tone = by.dark * smoothstep(0.03, 0.3, length(ground.n.xy));  // from hardly sloping to 17 degrees
    return strokes.x * smoothstep(1.0 - tone, 1.0 - tone + edge, mix(fine, coarse, by.fade)) * step(0.04, tone);
}
#endif

#ifdef STIPPLING
float hash(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.547); }

/// Two sizes of cells, turned against the compass and each other; the dots of one grow while those of the other vanish.
float stippling(Strokes by) {
    float ink = 0.0;
    for (int o = 0; o < 2; ++o) {
        vec2 place = (o == 0 ? mat2(0.8, 0.6, -0.6, 0.8) * v_ground : mat2(0.6, -0.8, 0.8, 0.6) * v_ground / 2.0) / by.size;
        vec2 cell = floor(place);
        vec2 dot_at = vec2(hash(cell), hash(cell + 37.0)) * 0.6 + 0.2;
        float radius = 0.42 * sqrt(by.dark * (o == 0 ? 1.0 - by.fade : by.fade));
        float away = length(place - cell - dot_at);
        ink = max(ink, strokes.y * (1.0 - smoothstep(0.75, 1.15, away / max(radius, 1e-3))) * smoothstep(0.04, 0.1, radius));
    }
    return ink;
}
#endif

/// `direct`: light on the ground, 0 in a style without lights.
vec3 sketched(vec3 color, Ground ground, float direct) {
#ifdef SKETCH
    float ink = 0.0;
#ifdef CONTOURS
    ink = contour_lines(ground, color);
#endif
#if defined(FORM_LINES) && defined(MAP_FORM)
    ink = max(ink, ridges_and_valleys(ground));
#endif
#if defined(SUGGESTIVE) && defined(MAP_FORM)
    ink = max(ink, suggestive_contours(ground));
#endif
#if defined(HATCHING) || defined(STIPPLING)
    Strokes by = strokes_at(ground, direct);
#endif
#ifdef HATCHING
    ink = max(ink, hatching(ground, by));
#endif
#ifdef STIPPLING
    ink = max(ink, stippling(by));
#endif
    color = mix(color, line_color, ink);
#endif
    return color;
}
