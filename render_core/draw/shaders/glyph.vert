// Glyphs. Follows data_light.vert. INSTANCED: a corner of a shape and an instance of it (glyph_batch.hpp, glyph_drawer.hpp);
// else corners that were put together before.
VERTEX_IN vec3 place;      // m, relative to the eye
VERTEX_IN vec4 color;
#ifdef INSTANCED
VERTEX_IN vec3 corner;     // shares of length, width, height
VERTEX_IN vec3 normal;
VERTEX_IN vec2 look;       // tone, opacity
VERTEX_IN vec3 size;       // m
VERTEX_IN vec4 direction;  // 127ths
uniform vec3 earth_to_eye; // m, from the Earth's centre
uniform float facing;      // 0: up; 1: the eye; 2: the eye, along the vertical

void main() {
    vec3 to_eye = -normalize(place);
    vec3 up = normalize((earth_to_eye + place) * vec3(1.0, 1.0, 1.0067394967));  // as earth::up_at()
    vec4 given = direction / 127.0;
    bool is_upright = given.w > 0.5;
    vec3 z = is_upright || facing > 0.5 ? to_eye : up;
    vec3 x = facing > 1.5 ? up : is_upright ? cross(up, to_eye) : normalize(given.xyz);
    vec3 y = cross(z, x);
    if (dot(y, y) < 1e-4) y = cross(z, abs(z.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0));
    y = normalize(y);
    if (is_upright)
        x = cross(y, z);
    else
        z = cross(x, y);
    vec3 reach = corner * size;
    vec3 across = normal / size;
    vec3 turned = x * across.x + y * across.y + z * across.z;
    float steep = length(turned);
    show(place + x * reach.x + y * reach.y + z * reach.z, steep > 0.0 ? turned / steep : vec3(0.0),
         vec4(color.rgb * look.x, color.a * look.y));
}
#else
VERTEX_IN vec3 normal;     // 127ths

void main() {
    show(place, normal / 127.0, color);
}
#endif
