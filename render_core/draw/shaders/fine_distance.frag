// Colour and distance in the same four bytes, for air that is drawn once a pixel: picture.frag. Alpha has steps of 3.6 %, which
// would be seen as bands; the lowest bits of red and of blue say in which quarter of such a step the distance lies, and that of
// green that the air has half of its effect. Colours are right to 1/255, distances to 0.5 %.
vec4 with_fine_distance(vec3 color, float distance_m, float half_air) {
    float steps = 255.0 * min(log2(1.0 + distance_m / 50.0) / 13.0, 254.0 / 255.0);  // as in terrain.frag; 255 is the sky
    float whole = floor(steps + 0.5);
    float quarter = floor(4.0 * (steps + 0.5 - whole));
    float upper = step(2.0, quarter);
    vec3 bits = vec3(upper, half_air, quarter - 2.0 * upper);
    return vec4(2.0 * floor(127.5 * clamp(color, 0.0, 1.0) + 0.25) + bits, whole) / 255.0;
}

// Colour; metres.
vec4 color_and_distance(vec4 texel, out float half_air) {
    vec3 bytes = floor(texel.rgb * 255.0 + 0.5), halves = floor(0.5 * bytes), bits = bytes - 2.0 * halves;
    float steps = texel.a * 255.0 + 0.25 * (2.0 * bits.r + bits.b) - 0.375;
    half_air = bits.g;
    return vec4((2.0 * halves + 0.5) / 255.0, 50.0 * max(exp2(steps * (13.0 / 255.0)) - 1.0, 0.0));
}
