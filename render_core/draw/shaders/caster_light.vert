// In the place of data_light.vert where data are drawn as the sun sees them. Followed by the program's own text, which calls
// show() once.
uniform vec4 shadow_axes[3];   // places in the light's frame, m = dot(xyz, place) + w
uniform vec4 caster_level;     // middle, half an edge, m; metres to swell along normals
VARYING vec2 v_caster;         // towards the sun, -400 km..400 km as 0..1; what it takes of the light

void show(vec3 eye_relative, vec3 normal, vec4 color) {
    if (dot(normal, normal) > 0.25) eye_relative += normalize(normal) * caster_level.w;
    vec4 place = vec4(eye_relative, 1.0);
    vec3 at = vec3(dot(shadow_axes[0], place), dot(shadow_axes[1], place), dot(shadow_axes[2], place));
    v_caster = vec2(at.z / 800000.0 + 0.5, color.a);
    gl_Position = vec4((at.xy - caster_level.xy) / caster_level.z, -at.z / 400000.0, 1.0);
}
