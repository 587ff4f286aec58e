// Ground that is not known, for want of data or beyond the database, has fine dark stripes on the screen, whatever the style. Before
// sky_color.frag and terrain.frag.

// What a pixel keeps of its color.
float hatch_at(vec2 pixel) {
    float from_middle = abs(fract((pixel.x + pixel.y) * 0.125) - 0.5);  // of a stripe of eight pixels
    return mix(0.5, 1.0, smoothstep(0.15, 0.35, from_middle));
}
