// Where a magnifier shows a place (earth/magnifier.hpp), in a draw of one part of its plane in which the map is linear. Before
// the program's own text.
uniform vec4 lens[6];  // east, 1 / 2N; north, 1 / 2M; up; its middle, from where places are measured, m; what a place moves
                       // east, and north: dot((east, north, 1), xyz)
VARYING vec2 v_lens;   // east and north of the middle before, m

vec3 magnified(vec3 place) {
    vec3 from = place - lens[3].xyz;
    vec3 at = vec3(dot(lens[0].xyz, from), dot(lens[1].xyz, from), 1.0);
    vec2 by = vec2(dot(lens[4].xyz, at), dot(lens[5].xyz, at));
    float drop = dot(vec2(lens[0].w, lens[1].w) * by, by + 2.0 * at.xy);
    v_lens = at.xy;
    return place + lens[0].xyz * by.x + lens[1].xyz * by.y - lens[2].xyz * drop;
}
