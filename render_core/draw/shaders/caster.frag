// A caster in the map of shadows: draw/drawers/shadow_map.hpp.
VARYING vec2 v_caster;

void main() {
    if (v_caster.y <= 0.0) discard;
    float code = floor(v_caster.x * 16777215.0 + 0.5);
    float high = floor(code / 65536.0), low = code - high * 65536.0, middle = floor(low / 256.0);
    FRAGMENT_COLOR = vec4(high, middle, low - middle * 256.0, 255.0 * v_caster.y) / 255.0;
}
