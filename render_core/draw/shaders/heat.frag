// 0..1 as dark violet, red, orange, pale yellow: lighter all the way, so that it says the same to whoever confuses colours.
vec3 heat_color(float value) {
    vec3 color = mix(vec3(0.16, 0.04, 0.36), vec3(0.73, 0.15, 0.33), clamp(value * 3.0, 0.0, 1.0));
    color = mix(color, vec3(0.98, 0.55, 0.04), clamp(value * 3.0 - 1.0, 0.0, 1.0));
    return mix(color, vec3(0.99, 1.0, 0.64), clamp(value * 3.0 - 2.0, 0.0, 1.0));
}
