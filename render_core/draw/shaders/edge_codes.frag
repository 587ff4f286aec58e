// Edges: how texels of four bytes are read, as whole numbers. First rows are the picture's top ones. What belongs to one colour lies
// in one band of columns, side by side with those of the others.
#ifdef LANE_ES3
#define TEXEL(image, at, size) texelFetch(image, ivec2(at), 0)
#else
#define TEXEL(image, at, size) TEXTURE2D(image, ((at) + 0.5) / (size))
#endif
const vec4 kSteps = vec4(0.0, 1.0, 2.0, 3.0);

vec4 bytes_of(vec4 texel) { return floor(texel * 255.0 + 0.5); }

// The number of a column's band, and of the column in it.
vec2 in_band(float column, float columns) {
    float number = floor((column + 0.5) / columns);
    return vec2(number, column - number * columns);
}

// Sixteen bits, a row of four in each component.
vec4 rows_of(vec2 bytes) {
    vec2 high = floor(bytes / 16.0), low = bytes - 16.0 * high;
    return vec4(low.x, high.x, low.y, high.y);
}

// Of a row, the leftmost pixel first.
vec4 bits_of(float row) {
    vec4 shifted = floor(row * vec4(1.0, 0.5, 0.25, 0.125));
    return shifted - 2.0 * floor(0.5 * shifted);
}
float row_of(vec4 bits) { return dot(bits, vec4(1.0, 2.0, 4.0, 8.0)); }
