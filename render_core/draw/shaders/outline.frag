// Silhouettes: where the next pixel lies much farther away than the slope of the surface explains, the near one is inked,
// and the far one half.
uniform sampler2D scene;     // colour; alpha codes the logarithm of the distance
uniform vec2 texel;
uniform vec4 line_color;     // alpha: strength
uniform vec2 jump;           // code steps at which a line begins and is full

VARYING vec2 v_at;

float jump_along(float here, vec2 step_to_next) {
    float next = TEXTURE2D(scene, v_at + step_to_next).a - here;
    float last = TEXTURE2D(scene, v_at - step_to_next).a - here;
    float nearer = max(next - 2.0 * abs(last), last - 2.0 * abs(next));
    float farther = max(-next - 2.0 * abs(last), -last - 2.0 * abs(next));
    return max(nearer, jump.x + 0.5 * (farther - jump.x));
}

void main() {
    vec4 here = TEXTURE2D(scene, v_at);
    float most = max(jump_along(here.a, vec2(texel.x, 0.0)), jump_along(here.a, vec2(0.0, texel.y)));
    FRAGMENT_COLOR = vec4(mix(here.rgb, line_color.rgb, smoothstep(jump.x, jump.y, most) * line_color.a), 1.0);
}
