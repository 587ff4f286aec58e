// Terrain in colour. Follows terrain_place.vert and terrain_varyings.vert.
void main() {
    vec3 eye_relative = eye_relative_place();
    vec3 shown = eye_relative;
#ifdef MAGNIFIED
    shown = magnified(eye_relative);
#endif
    gl_Position = view_projection * vec4(shown, 1.0);
    leave_varyings(eye_relative, shown, to_local * shown, to_local * normal, height, class_of_vertex(), place);
#ifdef ALERT_ZONE
    v_alert = alert_place(position + chunk_offset);
#endif
}
