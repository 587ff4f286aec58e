// What programs of spatial data share: places relative to the eye (ECEF, m) and light. Followed by the program's own text,
// which calls show() once.
uniform mat4 view_projection;
uniform vec4 light;            // unit vector towards it; what a side turned away keeps of its colour
VARYING vec4 v_color;
VARYING vec3 v_eye;            // from the eye, m

// A normal of length 0 is not shaded: its colour is what a scale says.
void show(vec3 eye_relative, vec3 normal, vec4 color) {
    float facing = dot(normal, normal) < 0.25 ? 1.0 : 0.5 + 0.5 * dot(normalize(normal), light.xyz);
    v_color = vec4(color.rgb * mix(light.w, 1.0, facing), color.a);
    v_eye = eye_relative;
    gl_Position = view_projection * vec4(eye_relative, 1.0);
}
