// The saliency map over the picture it is of: in grey, or as heat (HEAT) through which the picture is seen.
uniform sampler2D first;

VARYING vec2 v_at;

void main() {
    float value = TEXTURE2D(first, vec2(v_at.x, 1.0 - v_at.y)).b;
#ifdef HEAT
    FRAGMENT_COLOR = vec4(heat_color(value), 0.45 + 0.35 * smoothstep(0.0, 0.5, value));
#else
    FRAGMENT_COLOR = vec4(vec3(value), 1.0);
#endif
}
