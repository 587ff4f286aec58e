// The saliency map over the picture it is of: in grey, or as heat (HEAT) through which the picture is seen.
uniform sampler2D first;

VARYING vec2 v_at;

void main() {
    float value = TEXTURE2D(first, vec2(v_at.x, 1.0 - v_at.y)).b;
#ifdef HEAT
    // Dark violet, red, orange, pale yellow: lighter all the way, so that it says the same to whoever confuses colours.
    vec3 color = mix(vec3(0.16, 0.04, 0.36), vec3(0.73, 0.15, 0.33), clamp(value * 3.0, 0.0, 1.0));
    color = mix(color, vec3(0.98, 0.55, 0.04), clamp(value * 3.0 - 1.0, 0.0, 1.0));
    color = mix(color, vec3(0.99, 1.0, 0.64), clamp(value * 3.0 - 2.0, 0.0, 1.0));
    FRAGMENT_COLOR = vec4(color, 0.45 + 0.35 * smoothstep(0.0, 0.5, value));
#else
    FRAGMENT_COLOR = vec4(vec3(value), 1.0);
#endif
}
