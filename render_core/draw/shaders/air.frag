// What air does to a colour on its way to the eye: earth/atmosphere.hpp, tabulated by draw/air_table. Colours are taken as roots of
// light.
#ifdef AIR
uniform sampler2D air_map;     // rows 0..63: what is left; 64..127: light by molecules; 128..191: by aerosol
uniform vec4 air_sun;          // unit vector towards it, as the ray's; height of the eye, m
uniform vec4 air_up;           // the eye's vertical; sine of the horizon's dip
uniform vec3 air_look;         // share of its effect, 0: there is none; light of the horizon by molecules and by aerosol, of the most wanted

const float kAirOut = 63.0;    // column of rays that leave the air

float air_column(float distance_m) { return min(log2(1.0 + distance_m / 1000.0) * (62.0 / 9.6456), 62.0); }

// By the angle above the horizon, where rows stand closest.
float air_row(vec3 ray) {
    float above = clamp(dot(ray, air_up.xyz) + air_up.w, -1.0, 1.0);
    return 31.5 + 31.5 * sign(above) * sqrt(abs(above));
}

vec3 air_at(float block, float row, float column) {
    return TEXTURE2D(air_map, vec2((column + 0.5) / 64.0, (64.0 * block + row + 0.5) / 192.0)).rgb;
}

// Rayleigh's and Cornette-Shanks' phase functions. Towards the sun aerosol makes the horizon no brighter than 1.3 of the
// light that is wanted: no glare hides terrain and symbols.
vec2 air_phases(vec3 ray) {
    float cosine = dot(ray, air_sun.xyz);
    float away = 1.5776 - 1.52 * cosine;
    vec2 phases = vec2(0.0596831, 0.0195609 / (away * sqrt(away))) * (1.0 + cosine * cosine);
    phases.y = min(phases.y, max(1.3 - phases.x * air_look.y, 0.0) / max(air_look.z, 1e-6));
    return phases;
}

vec3 air_light(vec3 ray, float column) {
    float row = air_row(ray);
    vec2 phases = air_phases(ray);
    return phases.x * air_at(1.0, row, column) + phases.y * air_at(2.0, row, column);
}

// With all of its effect. `ray`: unit vector from the eye.
vec3 behind_air(vec3 color, vec3 ray, float column) {
    vec3 left = air_at(0.0, air_row(ray), column);
    return min(sqrt(color * color * left + air_light(ray, column)), vec3(1.0));
}

vec3 through_air(vec3 color, vec3 ray, float distance_m) {
    if (air_look.x <= 0.0) return color;
    return mix(color, behind_air(color, ray, air_column(distance_m)), air_look.x);
}
#endif
