// Colour on the ground by a field of the scene. A texel of the map is a post of the field: value in 16 bits, uncertainty, state.
// Followed by ground_overlay.frag where there is an overlay, then terrain.frag.
#ifdef GROUND_DATA
uniform sampler2D data_map;
uniform sampler2D data_colors;   // first row: colour by level in the palette's range; second row: colour by class
uniform vec4 data_size;          // 1 / size of the map; last column and row of the field
uniform vec4 data_scale;         // level in the palette = value * x + y; 1: classes, 1: values of the nearest post
uniform float data_breaks[15];   // limits of classes as values, those that are not used beyond all
uniform float data_lowest;       // values below it have no colour
uniform vec4 data_look;          // opacity; what the least sure loses; levels of uncertainty, 0 for continuous; 1: data are shown
VARYING vec2 v_data;             // posts east and south of the field's first

vec4 data_texel(vec2 post) { return TEXTURE2D(data_map, (clamp(post, vec2(0.0), data_size.zw) + 0.5) * data_size.xy); }

// Value 0..1; uncertainty 0..1, 2 where unknown; 1 where there is a value, -1 where one is missing, 0 beside the field; 1 where it
// was interpolated. Linear between posts, and what one post with weight lacks, the place lacks.
vec4 data_at(vec2 place) {
    vec2 cell = floor(place);
    vec2 part = mix(place - cell, floor(place - cell + 0.5), data_scale.w);
    vec4 weight = vec4((1.0 - part.x) * (1.0 - part.y), part.x * (1.0 - part.y), (1.0 - part.x) * part.y, part.x * part.y);
    vec4 nw = data_texel(cell);
    vec4 ne = data_texel(cell + vec2(1.0, 0.0));
    vec4 sw = data_texel(cell + vec2(0.0, 1.0));
    vec4 se = data_texel(cell + vec2(1.0, 1.0));
    vec4 used = step(1e-4, weight);
    vec4 state = vec4(nw.a, ne.a, sw.a, se.a);
    vec4 unsure = vec4(nw.b, ne.b, sw.b, se.b) * (255.0 / 254.0);
    float value = dot(weight, vec4(nw.r, ne.r, sw.r, se.r) * (65280.0 / 65535.0) + vec4(nw.g, ne.g, sw.g, se.g) * (255.0 / 65535.0));
    float missing = dot(used, 1.0 - step(0.25, state));
    float unknown = dot(used, step(1.002, unsure));
    float filled = dot(used, 1.0 - step(0.75, state));
    vec2 beside = step(place, vec2(-1e-4)) + step(data_size.zw + 1e-4, place);
    float there = beside.x + beside.y > 0.5 ? 0.0 : missing > 0.5 ? -1.0 : 1.0;
    return vec4(value, unknown > 0.5 ? 2.0 : dot(weight, unsure), there, step(0.5, filled));
}

// Alpha 0: a class that the palette does not name.
vec4 data_color(float value) {
    float along = clamp(value * data_scale.x + data_scale.y, 0.0, 1.0) * 1023.0;
    if (data_scale.z > 0.5) {
        along = 0.0;
        for (int n = 0; n < 15; ++n) along += step(data_breaks[n], value);
    }
    return TEXTURE2D(data_colors, vec2((along + 0.5) / 1024.0, data_scale.z > 0.5 ? 0.75 : 0.25));
}

// Whether the ground's colour says a value.
bool data_speaks() {
    vec4 data = data_at(v_data);
    return data_look.w > 0.5 && data.z > 0.5 && data.x >= data_lowest;
}

// Grains and strokes lie on the ground; their size there doubles with the distance, so that they stay a few pixels wide.
float data_grain(vec2 cell) { return fract(sin(dot(cell, vec2(12.9898, 78.233))) * 43758.547); }

// Level of uncertainty in `levels` gradations; as it is where they are 0.
float data_gradation(float level, float levels) {
    return levels > 0.5 ? floor(min(level, 0.9999) * levels) / (levels - 1.0) : level;
}

#if defined(DATA_BUMP) || defined(DATA_FOG)
// Smooth noise 0..1, and how it rises along both axes.
vec3 data_relief(vec2 place) {
    vec2 cell = floor(place);
    vec2 part = place - cell;
    float a = data_grain(cell);
    float b = data_grain(cell + vec2(1.0, 0.0)) - a;
    float c = data_grain(cell + vec2(0.0, 1.0)) - a;
    float d = data_grain(cell + vec2(1.0, 1.0)) - a - b - c;
    vec2 w = part * part * (3.0 - 2.0 * part);
    return vec3(a + b * w.x + c * w.y + d * w.x * w.y, 6.0 * part * (1.0 - part) * (vec2(b, c) + d * w.yx));
}
#endif
#ifdef DATA_BUMP
// What a rough relief makes of a light from the north-west that stands 45 degrees high.
float data_bumps(vec2 ground, float size, float loss) {
    vec2 rise = loss * data_relief(ground / (2.0 * size)).yz;
    return clamp((1.0 + 0.70710678 * (rise.x + rise.y)) / length(vec3(rise, 1.0)), 0.4, 1.4);
}
#endif
#ifdef DATA_BLUR
// The mean colour over a disc of posts: its middle and eight places on two rings. What is missing has no weight.
vec3 data_washed(vec3 middle, vec2 place, float radius) {
    vec4 sum = 2.0 * vec4(middle, 1.0);
    for (int n = 0; n < 8; ++n) {
        float turn = 0.78539816 * float(n);
        vec4 tap = data_at(place + vec2(cos(turn), sin(turn)) * (mod(float(n), 2.0) < 0.5 ? radius : 0.6 * radius));
        if (tap.z > 0.0) sum += data_color(tap.x);
    }
    return sum.rgb / sum.a;
}
#endif

// `data`: as data_at() gives it; `ground`: metres east and south; `pixel_m`: a pixel there.
vec3 with_data(vec3 color, vec4 data, vec3 plain, vec3 unknown, vec2 ground, float pixel_m) {
    vec4 named = data_color(data.x);
    vec3 shown = named.rgb;
    float there = min(data.z, step(0.5, named.a) * 2.0 - 1.0);
    // Unknown is no grade of it: stripes alone say so, below.
    float loss = data.y > 1.5 ? 0.0 : data_gradation(min(data.y, 1.0), data_look.z) * data_look.y;
    float cover = data_look.x * step(data_lowest, data.x);
    float size = exp2(floor(log2(max(pixel_m, 0.01)) + 2.0));
#if defined(DATA_TRANSPARENCY)
    cover *= 1.0 - loss;
#elif defined(DATA_SATURATION)
    shown = mix(shown, vec3(dot(shown, vec3(0.2126, 0.7152, 0.0722))), loss);
#elif defined(DATA_NOISE)
    cover *= step(loss, data_grain(floor(ground / size)));
#elif defined(DATA_STROKES)
    cover *= step(loss * 0.9, fract((ground.x + ground.y) / (4.0 * size)));
#elif defined(DATA_BIVARIATE)
    shown = mix(shown, plain, loss);
#elif defined(DATA_BUMP)
    shown = min(shown * data_bumps(ground, size, loss), vec3(1.0));
#elif defined(DATA_BLUR)
    shown = data_washed(shown, v_data, 2.0 * loss);
#endif
    // Signs on the screen, whatever the technique: unknown uncertainty is cut by stripes, what was interpolated by a fine grid, and
    // dots stand where a value is missing.
    vec2 screen = gl_FragCoord.xy;
    float stripes = step(3.0, mod(screen.x - screen.y, 9.0));
    float grid = step(1.0, mod(screen.x, 5.0)) * step(1.0, mod(screen.y, 5.0));
    cover *= mix(1.0, stripes, step(1.5, data.y)) * mix(1.0, grid, data.w);
    vec2 from_dot = mod(screen, 12.0) - 6.0;
    float dots = step(dot(from_dot, from_dot), 2.6);
    return there > 0.0 ? mix(color, shown, cover) : mix(color, unknown, there < 0.0 && data.z != 0.0 ? dots : 0.0);
}
#endif
