// Edges: of 4 x 4 pixels of a colour, which are largest across the edge and longer than the lower threshold (first two bytes), and
// than the higher one (last two). As perception/edge_rows.cpp, in whole numbers.
uniform sampler2D first;
uniform vec2 first_size;
uniform vec2 picture;
uniform float band;  // of what is read
uniform vec2 rows;   // of the picture: the first one that is read
uniform vec2 thresholds;  // squared

void main() {
    vec2 block = floor(gl_FragCoord.xy);
    vec2 place = in_band(block.x, band - 2.0);
    float start = place.x * band + place.y + 1.0, x = 4.0 * place.y, y = 4.0 * block.y;
    vec4 inside = vec4(lessThan(x + kSteps, picture.xxxx));
    vec2 ends_inside = vec2(x > 0.5 ? 1.0 : 0.0, x + 4.0 < picture.x ? 1.0 : 0.0);
    // Of three rows the levels, and of three the squared lengths and of one the gradient; ends: two and one pixel beside the four.
    vec4 level_0 = vec4(0.0), level_1 = vec4(0.0), ends_0 = vec4(0.0), ends_1 = vec4(0.0);
    vec4 above = vec4(0.0), here = vec4(0.0), here_across = vec4(0.0), here_down = vec4(0.0), code = vec4(0.0);
    vec2 above_ends = vec2(0.0), here_ends = vec2(0.0);
    for (int n = 0; n < 8; ++n) {
        float row = y + float(n) - 2.0, row_read = clamp(row, 0.0, picture.y - 1.0) - rows.x;
        vec4 level_2 = bytes_of(TEXEL(first, vec2(start, row_read), first_size));
        vec4 ends_2 = vec4(bytes_of(TEXEL(first, vec2(start - 1.0, row_read), first_size)).zw,
                           bytes_of(TEXEL(first, vec2(start + 1.0, row_read), first_size)).xy);
        vec4 smooth_4 = level_0 + 2.0 * level_1 + level_2, smooth_ends = ends_0 + 2.0 * ends_1 + ends_2;
        vec4 steep = level_2 - level_0, steep_ends = ends_2 - ends_0;
        vec4 across = vec4(smooth_4.yzw, smooth_ends.z) - vec4(smooth_ends.y, smooth_4.xyz);
        vec4 down = vec4(steep_ends.y, steep.xyz) + 2.0 * steep + vec4(steep.yzw, steep_ends.z);
        vec2 across_ends = vec2(smooth_4.x, smooth_ends.w) - vec2(smooth_ends.x, smooth_4.w);
        vec2 down_ends = vec2(steep_ends.x, steep.w) + 2.0 * steep_ends.yz + vec2(steep.x, steep_ends.w);
        float row_inside = row > 0.5 && row < picture.y + 0.5 ? 1.0 : 0.0;
        vec4 below = row_inside * inside * (across * across + down * down);
        vec2 below_ends = row_inside * ends_inside * (across_ends * across_ends + down_ends * down_ends);
        if (n > 3) {
            vec4 x_length = abs(here_across), y_length = abs(here_down), slope = x_length * (27146.0 / 65536.0);
            vec4 is_across = vec4(lessThanEqual(y_length, slope)), is_down = vec4(greaterThan(y_length - 2.0 * x_length, slope));
            vec4 falls = vec4(lessThan(here_across * here_down, vec4(0.0)));
            vec4 upper = mix(vec4(above_ends.x, above.xyz), vec4(above.yzw, above_ends.y), falls);
            vec4 lower = mix(vec4(below.yzw, below_ends.y), vec4(below_ends.x, below.xyz), falls);
            vec4 before = mix(mix(upper, above, is_down), vec4(here_ends.x, here.xyz), is_across);
            vec4 after = mix(mix(lower, below, is_down), vec4(here.yzw, here_ends.y), is_across);
            vec4 is_crest = vec4(greaterThan(here, before)) * vec4(greaterThan(here + is_across + is_down, after));
            vec2 found = vec2(row_of(is_crest * vec4(greaterThan(here, thresholds.xxxx))),
                              row_of(is_crest * vec4(greaterThan(here, thresholds.yyyy))));
            float place_in_byte = n == 4 || n == 6 ? 1.0 : 16.0;
            code += n < 6 ? vec4(found.x, 0.0, found.y, 0.0) * place_in_byte : vec4(0.0, found.x, 0.0, found.y) * place_in_byte;
        }
        level_0 = level_1;
        level_1 = level_2;
        ends_0 = ends_1;
        ends_1 = ends_2;
        above = here;
        above_ends = here_ends;
        here = below;
        here_ends = below_ends;
        here_across = across;
        here_down = down;
    }
    FRAGMENT_COLOR = code / 255.0;
}
