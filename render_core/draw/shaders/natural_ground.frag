// Ground as it looks: tints by height, darker woods where it slopes, rock where it is steep, and a grain. Before terrain.frag.
//
// The grain is noise of values at whole places (Perlin 1985, section "solid texture", in two dimensions) with a period of 256
// cells. Its cells are a few pixels wide at any distance: their size doubles with the footprint of a pixel, and two sizes
// cross-fade. Sizes are powers of two metres, so the grain stands still on the ground.
#ifdef TEXTURE_MATERIAL
uniform vec4 natural_rock;       // color of rock; strength of the grain
uniform vec4 natural_woods;      // shares that they leave of the tint; height of the tree line, m above MSL

const float TREE_LINE_FADE_M = 200.0;  // to either side of it

// A permutation of the numbers below 289 (McEwan et al. 2012) for whole numbers below 578: all products stay below 2^22, and every
// step is exact in float.
vec2 permuted(vec2 x) {
    x -= 289.0 * step(289.0, x);
    x *= x * 34.0 + 1.0;
    return x - 289.0 * floor((x + 0.5) * (1.0 / 289.0));
}

// -0.5..0.5; `place`: in cells.
float grain_at(vec2 place) {
    vec2 cell = floor(place), inside = place - cell;
    inside *= inside * (3.0 - 2.0 * inside);
    vec4 corner = mod(vec4(cell, cell + 1.0), 256.0);
    vec2 column = permuted(corner.xz);
    vec2 row = mix(permuted(column.xx + corner.yw), permuted(column.yy + corner.yw), inside.x);
    return mix(row.x, row.y, inside.y) * (1.0 / 288.0) - 0.5;
}

// Grain of three sizes, each twice the one before, the finest with cells of four to eight pixels. It goes while the next larger
// one comes. No cell is larger than 512 m, of which 256 fit into the period of the coordinates: where cells would have to be,
// the grain has faded out.
float grain_of(vec2 ground, float footprint_m) {
    float octave = log2(max(footprint_m * 4.0, 0.25)), fade = fract(octave);
    float size_m = floor(exp2(floor(octave) + 2.0) + 0.5) * 0.25;  // a whole power of two, whatever exp2 rounds
    float grain = (1.0 - fade) * grain_at(ground / size_m) + grain_at(ground / (2.0 * size_m)) +
                  fade * grain_at(ground / (4.0 * size_m));
    return grain * clamp(7.0 - octave, 0.0, 1.0);
}

// `tint`: by height alone. `height_m`: above MSL. `footprint_m`: of a pixel on the ground.
vec3 natural_ground(vec3 tint, float height_m, vec3 n, vec2 ground, float footprint_m) {
    float grain = grain_of(ground, footprint_m);
    float steep = 1.0 - n.z + 0.008 * grain;
    float above = (height_m - natural_woods.w) * (0.5 / TREE_LINE_FADE_M);
    float woods = smoothstep(0.003, 0.020, steep) * clamp(0.5 - above, 0.0, 1.0);
    vec3 color = mix(tint, tint * natural_woods.rgb, woods);
    color = mix(color, natural_rock.rgb, smoothstep(0.14, 0.32, steep));
    return color * (1.0 + 0.6 * natural_rock.a * grain);
}
#endif
