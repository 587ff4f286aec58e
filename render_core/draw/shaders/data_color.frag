// Colour of spatial data behind haze, or with AIR behind air.frag, which it follows.
uniform vec3 haze_color;
uniform float haze_per_m;  // 1 / distance, 0 for none
uniform vec3 left;         // least and most of the distance's code that alpha takes; 1: of an opaque thing, which is not mixed
#ifdef SOLIDS
uniform vec2 near_fade;    // m from the eye where it begins to be seen; share a metre from there on
VARYING float v_unknown;   // above 0: of what fades, and nobody knows how unsure it is
#endif
VARYING vec4 v_color;
VARYING vec3 v_eye;

void main() {
#ifdef MAGNIFIED
    leave_other_parts();
#endif
    float distance_m = length(v_eye), shown = 1.0;
#ifdef SOLIDS
    shown = clamp((distance_m - near_fade.x) * near_fade.y, 0.0, 1.0);
    shown *= max(step(v_unknown, 0.004), step(3.0, mod(gl_FragCoord.x - gl_FragCoord.y, 9.0)));  // cut as on the ground
    if (shown <= 0.0) discard;  // what is not seen hides nothing
#endif
    vec3 own = v_color.rgb;
    float alpha = v_color.a * shown;
#ifdef GRID
    float line = grid_at(v_eye / distance_m, distance_m * grid_size.w);
    own = mix(own, grid_look.rgb, line);
    alpha *= 1.0 + line * (1.0 - alpha);  // lines on what is nearly clear are seen, on what is not there they are not
#endif
#ifdef AIR
    vec3 color = through_air(own, v_eye / distance_m, distance_m);
#else
    vec3 color = mix(own, haze_color, 1.0 - exp(-distance_m * haze_per_m));
#endif
    if (left.z > 0.5) alpha = clamp(log2(1.0 + distance_m / 50.0) / 13.0, left.x, left.y);
    FRAGMENT_COLOR = vec4(color, alpha);
}
