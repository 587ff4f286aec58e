// The colour of the ground without light: by a quantity and a palette, of an image, as natural ground, or plain.
#ifdef PALETTE
#ifndef FOCI
uniform sampler2D palette;       // colour by the texture's quantity
#endif
uniform vec2 palette_range;      // lowest value, 1 / (highest - lowest)
#endif
uniform vec3 plain_color;
uniform vec3 sea_color;

#ifdef PALETTE
vec3 palette_color(float value) {
    float level = clamp((value - palette_range.x) * palette_range.y, 0.0, 1.0);
    return TEXTURE2D(palette, vec2(level * (1023.0 / 1024.0) + 0.5 / 1024.0, 0.25)).rgb;
}
#endif

vec3 land_color(Ground ground) {
#if defined(TEXTURE_HYPSOMETRIC)
    return palette_color(v_height);
#elif defined(TEXTURE_SLOPE)
    return palette_color(atan(length(ground.n.xy), max(ground.n.z, 0.0)));
#elif defined(TEXTURE_RELIEF) && defined(MAP_LIGHT)
    return palette_color(1000.0 * signed_root(ground.baked.b));
#elif defined(TEXTURE_OPENNESS) && defined(MAP_LIGHT)
    return palette_color((1.0 + signed_root(ground.baked.g)) * 1.5707963);
#elif defined(TEXTURE_IMAGE) && defined(MAP_DRAPE)
    vec4 image = drape_of(v_drape, ground.n);
    return plain_color * (1.0 - image.a) + image.rgb;
#elif defined(TEXTURE_MATERIAL)
    return natural_ground(palette_color(v_height), v_height, ground.n, v_ground, ground.pixel_m * inversesqrt(ground.facing));
#else
    return plain_color;
#endif
}

vec3 textured(Ground ground) { return mix(land_color(ground), mix(sea_color, vec3(1.0), 0.25 * ground.shore), ground.sea); }
