// Edges: what is connected with a strong edge becomes one, FOLLOWED pixels deep into a block of 4 x 4. The loops are left at once
// where nothing is open: their ends are numbers that no compiler knows, as it would unroll them and run all of it.
uniform sampler2D first;
uniform vec2 first_size;
uniform float band;

vec2 place, block;

void find_block() {
    block = floor(gl_FragCoord.xy);
    place = in_band(block.x, band);
}

// Not beyond the picture, where nothing is an edge.
bool is_inside(float x, float y) {
    return place.y + x > -0.5 && place.y + x < band - 0.5 && block.y + y > -0.5 && block.y + y < first_size.y - 0.5;
}

#ifdef LANE_ES3
// Sixteen bits, row by row.
uint bits_in(vec2 bytes) { return uint(bytes.x) | uint(bytes.y) << 8; }
uint beside(float x, float y) {
    return is_inside(x, y) ? bits_in(bytes_of(TEXEL(first, block + vec2(x, y), first_size)).zw) : 0u;
}

uint above_and_below(uint bits) { return bits | bits << 4 | bits >> 4; }
uint left_and_right(uint bits) { return bits | (bits & 0x7777u) << 1 | (bits & 0xEEEEu) >> 1; }

void main() {
    find_block();
    vec4 own = bytes_of(TEXEL(first, block, first_size));
    uint weak = bits_in(own.xy), strong = bits_in(own.zw), near = 0u;  // near: pixels beside a neighbour's strong ones
    int turns = weak == strong ? 0 : 3;
    for (int n = 0; n < 64; ++n) {
        if (n >= turns) break;
        float y = n == 0 ? 0.0 : n == 1 ? -1.0 : 1.0;
        uint before = beside(-1.0, y), middle = n == 0 ? 0u : beside(0.0, y), after = beside(1.0, y);
        if (n == 0) near = above_and_below((before & 0x8888u) >> 3 | (after & 0x1111u) << 3);
        if (n == 1) near |= before >> 15 | left_and_right(middle >> 12) & 15u | (after >> 12 & 1u) << 3;
        if (n == 2) near |= (before >> 3 & 1u | left_and_right(middle & 15u) & 15u | (after & 1u) << 3) << 12;
    }
    turns = (strong | near) == 0u || weak == strong ? 0 : int(FOLLOWED);
    for (int n = 0; n < 64; ++n) {
        if (n >= turns) break;
        uint now = weak & (near | above_and_below(left_and_right(strong)));
        if (now == strong) break;
        strong = now;
    }
    FRAGMENT_COLOR = vec4(own.xy, vec2(float(strong & 255u), float(strong >> 8))) / 255.0;
}
#else
// A neighbour's strong edges by rows.
vec4 beside(float x, float y) {
    return is_inside(x, y) ? rows_of(bytes_of(TEXEL(first, block + vec2(x, y), first_size)).zw) : vec4(0.0);
}

vec4 leftmost(vec4 row) { return row - 2.0 * floor(0.5 * row); }
vec4 rightmost(vec4 row) { return floor(0.125 * row); }

vec4 widened(vec4 row, float left, float right) { return max(row, max(vec4(left, row.xyz), vec4(row.yzw, right))); }

void main() {
    find_block();
    vec4 own = bytes_of(TEXEL(first, block, first_size));
    vec4 weak = rows_of(own.xy), strong = rows_of(own.zw);
    vec4 left = vec4(0.0), right = vec4(0.0), above = vec4(0.0), below = vec4(0.0);
    float turns = own.xy == own.zw ? 0.0 : 3.0;
    for (int n = 0; n < 64; ++n) {
        if (float(n) > turns - 0.5) break;
        float y = n == 0 ? 0.0 : n == 1 ? -1.0 : 1.0;
        vec4 before = rightmost(beside(-1.0, y)), after = leftmost(beside(1.0, y));
        if (n == 0) {
            left = before;
            right = after;
        } else {
            vec4 middle = beside(0.0, y);
            vec4 row = n == 1 ? widened(bits_of(middle.w), before.w, after.w) : widened(bits_of(middle.x), before.x, after.x);
            if (n == 1) above = row;
            if (n == 2) below = row;
        }
    }
    vec4 weak_0 = bits_of(weak.x), weak_1 = bits_of(weak.y), weak_2 = bits_of(weak.z), weak_3 = bits_of(weak.w);
    vec4 row_0 = bits_of(strong.x), row_1 = bits_of(strong.y), row_2 = bits_of(strong.z), row_3 = bits_of(strong.w);
    turns = dot(strong + left + right + above + below, vec4(1.0)) > 0.5 && own.xy != own.zw ? FOLLOWED : 0.0;
    for (int n = 0; n < 64; ++n) {
        if (float(n) > turns - 0.5) break;
        vec4 wide_0 = widened(row_0, left.x, right.x), wide_1 = widened(row_1, left.y, right.y);
        vec4 wide_2 = widened(row_2, left.z, right.z), wide_3 = widened(row_3, left.w, right.w);
        row_0 = weak_0 * max(above, max(wide_0, wide_1));
        row_1 = weak_1 * max(wide_0, max(wide_1, wide_2));
        row_2 = weak_2 * max(wide_1, max(wide_2, wide_3));
        row_3 = weak_3 * max(wide_2, max(wide_3, below));
        vec4 now = vec4(row_of(row_0), row_of(row_1), row_of(row_2), row_of(row_3));
        if (now == strong) break;
        strong = now;
    }
    FRAGMENT_COLOR = vec4(own.xy, strong.x + 16.0 * strong.y, strong.z + 16.0 * strong.w) / 255.0;
}
#endif
