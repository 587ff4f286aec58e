// Red and green: the height in steps of 1/254 of its range and of 1/255 of such a step; red 254/255 is the sea. Blue: light,
// 0 only where nothing is known. Alpha: the logarithm of the distance.
VARYING vec3 v_code;
#ifdef CLASSES
VARYING vec2 v_class;
#endif

void main() {
    float steps = floor(v_code.x);
    vec4 code = vec4(steps / 255.0, v_code.x - steps, v_code.y, v_code.z);
#ifdef CLASSES
    code.rg = mix(code.rg, vec2(254.0 / 255.0, 0.0), step(0.999, v_class.x));
    code.b *= step(v_class.y, 0.001);
#endif
    FRAGMENT_COLOR = code;
}
