// Saliency: what maps weigh. `figures` holds maxima (row 0) and numbers of places that show a feature (row 1) of the three groups of
// feature maps, of conspicuities, and of the sum.
uniform sampler2D figures;
uniform vec2 figures_size;
uniform vec4 scale;  // logarithm of the map's pixels and two; 1: on a fixed scale; what may be noticed there, and by what the sum is multiplied

vec4 most_of(float column) { return squared(TEXEL(figures, vec2(column, 0.0), figures_size)); }

vec4 information_of(float column) {
    vec4 bits = max(scale.x - logarithm_of_count(TEXEL(figures, vec2(column, 1.0), figures_size)), 0.0);
    return scale.y > 0.5 ? bits / scale.x : bits;
}

// Of a group of feature maps. Below the least amplitude there is rounding alone.
vec4 weights_of(float column) {
    vec4 most = most_of(column), weights = information_of(column);
    return scale.y > 0.5 ? weights * vec4(greaterThan(most, scale.zzzz)) : weights * most * step(LEAST_AMPLITUDE, most);
}

// No conspicuity is greater: lightness, colours, directions.
vec3 bounds() {
    vec4 a = weights_of(0.0) * most_of(0.0), b = weights_of(1.0) * most_of(1.0), c = weights_of(2.0) * most_of(2.0);
    return vec3(a.x + a.y, a.z + a.w + b.x + b.y, dot(c, vec4(1.0)));
}

// What conspicuities weigh, as parts of their bounds.
vec3 parts() {
    vec3 all = bounds();
    return scale.y > 0.5 ? all : information_of(3.0).xyz * all;
}
