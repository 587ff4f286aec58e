// Where a place of the ground lies to the predicted track, for alert_zone.frag. Behind it in deferred shading (DEFERRED).
#ifdef ALERT_ZONE
uniform vec4 alert_axes[2];    // metres ahead of the own ship, to its right = dot(xyz, place) + w
#ifndef DEFERRED
VARYING vec2 v_alert;
#endif

// Of the ground as it is, neither raised nor flattened.
vec2 alert_place(vec3 ground) { return vec2(dot(alert_axes[0], vec4(ground, 1.0)), dot(alert_axes[1], vec4(ground, 1.0))); }
#endif
