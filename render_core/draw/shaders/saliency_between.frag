// Saliency: what lies between texels' middles, beyond the border what stands at it. Equal neighbours give their own value, bit by bit.
vec4 texel_at(sampler2D image, vec2 size, vec2 at) { return TEXEL(image, clamp(at, vec2(0.0), size - 1.0), size); }

vec3 triple_between(sampler2D image, vec2 size, vec2 at) {
    vec2 first = floor(at), part = at - first;
    vec3 upper = triple_of(texel_at(image, size, first)), lower = triple_of(texel_at(image, size, first + vec2(0.0, 1.0)));
    upper += (triple_of(texel_at(image, size, first + vec2(1.0, 0.0))) - upper) * part.x;
    lower += (triple_of(texel_at(image, size, first + vec2(1.0, 1.0))) - lower) * part.x;
    return upper + (lower - upper) * part.y;
}

vec4 squares_between(sampler2D image, vec2 size, vec2 at) {
    vec2 first = floor(at), part = at - first;
    vec4 upper = squared(texel_at(image, size, first)), lower = squared(texel_at(image, size, first + vec2(0.0, 1.0)));
    upper += (squared(texel_at(image, size, first + vec2(1.0, 0.0))) - upper) * part.x;
    lower += (squared(texel_at(image, size, first + vec2(1.0, 1.0))) - lower) * part.x;
    return upper + (lower - upper) * part.y;
}
