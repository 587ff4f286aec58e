// Hypsometric tint, Lambert light, haze; with WARNING_BANDS the colours of terrain near the own ship's height.
uniform sampler2D palette;       // colour by height
uniform vec2 palette_range;      // lowest height, 1 / (highest - lowest)
uniform vec4 sea_color;
uniform vec4 haze_color;
uniform vec2 last_place;         // the raster ends here
#ifdef WARNING_BANDS
uniform vec4 band_color[8];      // alpha: strength
uniform float band_lower[8];     // height above MSL from which the band holds, ascending
#endif

VARYING float v_height;
VARYING float v_light;
VARYING float v_sea;
VARYING float v_haze;
VARYING vec2 v_place;

void main() {
    if (v_place.x > last_place.x || v_place.y > last_place.y) discard;
    float level = clamp((v_height - palette_range.x) * palette_range.y, 0.0, 1.0);
    vec3 color = TEXTURE2D(palette, vec2(level * (255.0 / 256.0) + 0.5 / 256.0, 0.5)).rgb;
    color = mix(color, sea_color.rgb, step(0.999, v_sea));
#ifdef WARNING_BANDS
    // From the lowest band up, so that the highest that holds wins; bands that are not used start at 1e9 m.
    vec4 band = vec4(0.0);
    for (int n = 0; n < 8; ++n) band = v_height >= band_lower[n] ? band_color[n] : band;
    color = mix(color, band.rgb, band.a);
#endif
    color = mix(color * v_light, haze_color.rgb, v_haze);
    FRAGMENT_COLOR = vec4(color, 1.0);
}
