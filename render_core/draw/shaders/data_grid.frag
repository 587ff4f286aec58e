// The surface grid on data: lines of longitude and latitude over those of the ground, and lines of equal height. Follows
// surface_line.frag. Latitude, longitude and height are series about the piece's anchor: draw/drawers/data/data_grid.hpp.
uniform vec4 grid_turn;   // cosine and sine of the anchor's longitude, and of its latitude
uniform vec3 grid_radii;  // of the anchor's parallel and along its meridian, m; half of what the latter grows by, a share a radian
uniform vec3 grid_first;  // lines to the anchor from the last before it: east, south, up
uniform vec3 grid_rate;   // lines a radian east, a radian north, a metre up
uniform vec2 grid_climb;  // of the sea's level, m a radian east and north
uniform vec4 grid_look;   // colour; strength, 0 for none
uniform vec4 grid_size;   // m from line to line there: east, north, up; metres a pixel per metre of distance
VARYING vec3 v_place;     // ECEF from the anchor, m
VARYING vec3 v_normal;    // ECEF, of any length; of none there are no lines

/// Of a place, counted in lines.
vec3 grid_lines() {
    float outward_m = dot(v_place.xy, grid_turn.xy), east_m = dot(v_place.xy, vec2(-grid_turn.y, grid_turn.x));
    float x = east_m / (grid_radii.x + outward_m);
    float east = x * (1.0 - x * x * (1.0 / 3.0 - 0.2 * x * x));
    outward_m += east_m * x * (0.5 - 0.125 * x * x);
    float north_m = grid_turn.z * v_place.z - grid_turn.w * outward_m;
    float up_m = grid_turn.w * v_place.z + grid_turn.z * outward_m;
    float y = north_m / (grid_radii.y + up_m);
    float north = y * (1.0 - y * (grid_radii.z + y / 3.0));
    float height_m = up_m + north_m * y * (0.5 - 0.125 * y * y) - dot(grid_climb, vec2(east, north));
    return grid_first + grid_rate * vec3(east, north, height_m);
}

/// None where the surface lies along the planes of an axis, for they would fill it: up to that square of the angle's sine.
float data_line(vec3 axis, float from_line_m, float spacing_m, vec3 n, vec3 ray, float pixel_m, float least) {
    float along = dot(axis, n);
    float reach_m = max(reach_of(axis, n, ray, max(-dot(n, ray), 0.03), pixel_m), 0.01 * pixel_m);
    return grid_line(from_line_m, spacing_m, reach_m) * smoothstep(least, 6.0 * least, 1.0 - along * along);
}

/// What lines take of a pixel.
float grid_at(vec3 ray, float pixel_m) {
    float square = dot(v_normal, v_normal);
    if (grid_look.a <= 0.0 || square < 0.01) return 0.0;
    vec3 n = v_normal * inversesqrt(square);
    if (dot(n, ray) > 0.0) n = -n;
    vec3 east = vec3(-grid_turn.y, grid_turn.x, 0.0);
    vec3 north = vec3(-grid_turn.w * grid_turn.xy, grid_turn.z), up = vec3(grid_turn.z * grid_turn.xy, grid_turn.w);
    vec3 from_line_m = (fract(grid_lines() + 0.5) - 0.5) * grid_size.xyz;
    float meridian = data_line(east, from_line_m.x, grid_size.x, n, ray, pixel_m, 0.001);
    float parallel = data_line(north, from_line_m.y, grid_size.y, n, ray, pixel_m, 0.001);
    float level = data_line(up, from_line_m.z, grid_size.z, n, ray, pixel_m, 0.00015);  // layers of air are flat
    return grid_look.a * max(max(meridian, parallel), level);
}
