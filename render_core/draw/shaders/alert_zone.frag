// Which ground comes too close to the predicted track: the formulas of policy/terrain_alert_zone.hpp. Followed by terrain.frag or
// terrain_code.frag.
#ifdef ALERT_ZONE
uniform vec4 alert_zone[6];    // rows: draw/drawers/alert_zone_uniforms.hpp
VARYING vec2 v_alert;          // metres ahead of the own ship, to its right

// Seconds until the track passes a place, and metres from the track there.
vec2 passage_of(vec2 place) {
    vec4 track = alert_zone[0];
    if (track.w > 0.0) {
        float inwards = place.y * track.z, to_middle = track.y - inwards;
        float angle = atan(place.x, to_middle);
        // The distance from a circle without a difference of two large radii.
        float aside = (place.x * place.x + inwards * (inwards - 2.0 * track.y)) / (length(vec2(place.x, to_middle)) + track.y);
        if (angle >= 0.0) return vec2(angle * track.w, abs(aside));
    } else if (place.x > 0.0 && track.x > 0.0) {
        return vec2(place.x / track.x, abs(place.y));
    }
    return vec2(0.0, length(place));
}

// 0: none, 1: caution, 2: warning.
float alert_at(vec2 place, float height) {
    vec2 passage = passage_of(place);
    vec4 width = alert_zone[1], limit = alert_zone[2], runway = alert_zone[3];
    if (passage.x > width.w || passage.y > width.x + (width.y + width.z * passage.x) * passage.x) return 0.0;
    if (!(height > limit.x + limit.y * passage.x)) return 0.0;
    if (distance(place, runway.xy) < runway.z && height <= runway.w) return 0.0;
    return passage.x <= limit.z ? 2.0 : 1.0;
}
#endif
