// Where a magnifier shows a place (earth/magnifier.hpp), in a draw of one part of its plane in which the map is affine. Before
// the program's own text.
uniform vec3 lens[5];  // east; north; its middle, from where places are measured, m; what a place moves east, and north:
                       // dot((east, north, 1), vector)
VARYING vec2 v_lens;   // east and north of the middle before, m

vec3 magnified(vec3 place) {
    vec3 from = place - lens[2];
    vec3 at = vec3(dot(lens[0], from), dot(lens[1], from), 1.0);
    v_lens = at.xy;
    return place + lens[0] * dot(lens[3], at) + lens[1] * dot(lens[4], at);
}
