// Hypsometric tint, Lambert light, haze; with WARNING_BANDS (their number) the colours of terrain near the own ship's height,
// with RASTER_ENDS nothing beyond the last post.
uniform sampler2D palette;       // colour by height
uniform vec2 palette_range;      // lowest height, 1 / (highest - lowest)
uniform vec4 sea_color;
uniform vec4 haze_color;
#ifdef RASTER_ENDS
uniform vec2 last_place;
#endif
#ifdef WARNING_BANDS
uniform vec4 band_color[WARNING_BANDS];      // alpha: strength
uniform float band_lower[WARNING_BANDS];     // height above MSL from which the band holds, ascending
#endif

VARYING float v_height;
VARYING float v_light;
VARYING float v_sea;
VARYING float v_haze;
#ifdef RASTER_ENDS
VARYING vec2 v_place;
#endif

void main() {
#ifdef RASTER_ENDS
    if (v_place.x > last_place.x || v_place.y > last_place.y) discard;
#endif
    float level = clamp((v_height - palette_range.x) * palette_range.y, 0.0, 1.0);
    vec3 color = TEXTURE2D(palette, vec2(level * (1023.0 / 1024.0) + 0.5 / 1024.0, 0.5)).rgb;
    color = mix(color, sea_color.rgb, step(0.999, v_sea));
#ifdef WARNING_BANDS
    // From the lowest band up, so that the highest that holds wins; bands that are not used start at 1e9 m.
    vec4 band = vec4(0.0);
    for (int n = 0; n < WARNING_BANDS; ++n) band = v_height >= band_lower[n] ? band_color[n] : band;
    color = mix(color, band.rgb, band.a);
#endif
    color = mix(color * v_light, haze_color.rgb, v_haze);
    FRAGMENT_COLOR = vec4(color, 1.0);
}
