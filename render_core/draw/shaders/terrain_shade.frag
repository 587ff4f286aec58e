// The light on the ground: of the style's lights, of a baked map or of the aperture, less what sky and shadows take away.
#ifdef MAP_APERTURE
uniform sampler2D aperture_map;  // aperture east, north, cosine of its radius, negative openness
#endif
#ifdef MAP_HORIZON
uniform sampler2D horizon_map;   // root of the horizon's sine towards the light
#endif
#ifdef LIGHTS
uniform vec4 lights[LIGHTS];     // towards each: east, north, up; its weight
uniform vec4 light;              // ambient, 1 - ambient, highlight, its exponent
#ifdef LIGHT_COLORS
uniform vec3 light_color[LIGHTS];
uniform vec3 ambient_color;
#endif
#endif
#ifdef OCCLUSION
uniform vec2 occlusion;          // strength of sky view and of openness
#endif

struct Shade {
    vec3 lit;      // factor of the colour
    vec3 shine;    // highlight, to be added
    float direct;  // light of all lights, before ambient light
};

#ifdef LIGHTS
#ifdef LIGHT_COLORS
vec3 first_color() { return light_color[0]; }
vec3 ambient_light() { return vec3(light.x) * ambient_color; }
#else
vec3 first_color() { return vec3(1.0); }
vec3 ambient_light() { return vec3(light.x); }
#endif

/// Share of the first light that no land hides.
float first_light_seen() {
#ifdef MAP_HORIZON
    float root = TEXTURE2D(horizon_map, (whole(v_page) * 0.5 + page_origin.zw) * page_scale.y).r;
    // The sun's disc is half a degree wide.
    return clamp((lights[0].z - root * root) * 115.0 + 0.5, 0.0, 1.0);
#else
    return 1.0;
#endif
}

/// Colour of the lights' sum, and in alpha the sum without colours.
vec4 direct_light(vec3 n, float first_seen) {
    float direct = 0.0;
    vec3 glow = vec3(0.0);
    for (int k = 0; k < LIGHTS; ++k) {
        float share = lights[k].w * max(dot(n, lights[k].xyz), 0.0) * (k == 0 ? first_seen : 1.0);
        direct += share;
#ifdef LIGHT_COLORS
        glow += share * light_color[k];
#endif
    }
#ifndef LIGHT_COLORS
    glow = vec3(direct);
#endif
    return vec4(glow, direct);
}

#if defined(SHADE_APERTURE) && defined(MAP_APERTURE)
vec3 aperture_light(vec3 n, float hidden) {
    vec4 aperture = TEXTURE2D(aperture_map, map_place(v_page));
    vec3 opening = normal_of(aperture.xy);
    float radius = acos(clamp(aperture.z, 0.0, 1.0));
    float apart = acos(clamp(dot(opening, lights[0].xyz), -1.0, 1.0));
    // Share of a soft light of 17 degrees that stands in the opening; the sky light falls with the opening's cap.
    float seen = 1.0 - smoothstep(radius - 0.3, radius + 0.3, apart);
    seen *= 1.0 - hidden;
    return ambient_light() * (1.0 - aperture.z) + light.y * seen * max(dot(n, lights[0].xyz), 0.0) * first_color();
}
#endif

/// `hidden`: share of the first light that shadows of data take away.
Shade light_on(Ground ground, float hidden) {
    vec4 direct = direct_light(ground.n, first_light_seen() * (1.0 - hidden));
    Shade shade = Shade(vec3(1.0), vec3(0.0), direct.a);
#if defined(SHADE_LIGHT_MAP) && defined(MAP_LIGHT)
    shade.lit = vec3(ground.baked.r * 1.25);
    shade.lit *= 1.0 - 0.6 * hidden;
#elif defined(SHADE_APERTURE) && defined(MAP_APERTURE)
    shade.lit = aperture_light(ground.n, hidden);
#else
    shade.lit = ambient_light() + light.y * direct.rgb;
#endif
#ifdef SHADE_PHONG
    float mirrored = max(dot(reflect(ground.ray, ground.n), lights[0].xyz), 0.0);
    shade.shine = light.z * pow(mirrored, light.w) * step(0.0001, direct.a) * first_color();
#endif
    return shade;
}
#endif

/// `is_plain`: 0 where a warning colour must not become darker, else 1.
Shade shade_of(Ground ground, float hidden, float is_plain) {
#ifdef LIGHTS
    Shade shade = light_on(ground, hidden);
#else
    Shade shade = Shade(vec3(1.0), vec3(0.0), 0.0);
#endif
#if defined(OCCLUSION) && defined(MAP_FORM)
    float sky = ground.form.z;
    shade.lit *= mix(1.0, sky * sky * sky * sky, occlusion.x * is_plain);
#endif
#if defined(OCCLUSION) && defined(MAP_LIGHT)
    shade.lit *= mix(1.0, smoothstep(0.65, 1.0, 1.0 + signed_root(ground.baked.g)), occlusion.y * is_plain);
#endif
#ifndef LIGHTS
    shade.lit *= 1.0 - 0.6 * hidden;  // a style without a light: as under a sky that keeps two fifths
#endif
    return shade;
}
