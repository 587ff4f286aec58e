// Edges: planes under a Gaussian of 256ths, across and down; sums are whole numbers below 2^24, rounded once.
uniform sampler2D first;
uniform vec2 first_size;
uniform vec2 picture;
uniform float band;
uniform vec2 rows;  // of the picture: the first one that is read, and that is written
uniform vec4 bell;  // weights, the middle one first

float start;  // the texel whose pixels are blurred
float y;

vec4 across(float k) {
    float row = clamp(y + k, 0.0, picture.y - 1.0) - rows.x;
    vec4 left = bytes_of(TEXEL(first, vec2(start - 1.0, row), first_size));
    vec4 here = bytes_of(TEXEL(first, vec2(start, row), first_size));
    vec4 right = bytes_of(TEXEL(first, vec2(start + 1.0, row), first_size));
    return bell.x * here + bell.y * (vec4(left.w, here.xyz) + vec4(here.yzw, right.x)) +
           bell.z * (vec4(left.zw, here.xy) + vec4(here.zw, right.xy)) +
           bell.w * (vec4(left.yzw, here.x) + vec4(here.w, right.xyz));
}

void main() {
    vec2 place = in_band(floor(gl_FragCoord.x), band);
    float column = clamp(place.y, 1.0, band - 2.0);
    start = place.x * band + column;
    y = floor(gl_FragCoord.y) + rows.y;
    vec4 sum = bell.x * across(0.0) + bell.y * (across(-1.0) + across(1.0)) + bell.z * (across(-2.0) + across(2.0)) +
               bell.w * (across(-3.0) + across(3.0));
    vec4 level = floor((sum + 32768.0) / 65536.0);
    // Beyond the picture its outermost pixel.
    vec4 from = clamp(4.0 * (place.y - 1.0) + kSteps, 0.0, picture.x - 1.0) - 4.0 * (column - 1.0);
    FRAGMENT_COLOR = (level.x * vec4(equal(from, kSteps.xxxx)) + level.y * vec4(equal(from, kSteps.yyyy)) +
                      level.z * vec4(equal(from, kSteps.zzzz)) + level.w * vec4(equal(from, kSteps.wwww))) /
                     255.0;
}
