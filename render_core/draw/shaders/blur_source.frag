// The scene in squares of TEXEL x TEXEL pixels, each with the color and the blur of those of its pixels that are least out of
// focus, so that the edge of what is sharp does not spread: draw/drawers/scene_blur.hpp. Follows blur_radius.frag.
uniform sampler2D scene;       // alpha codes the logarithm of the distance as in terrain.frag; 1 is infinitely far

vec4 scene_at(ivec2 at) { return texelFetch(scene, min(at, textureSize(scene, 0) - 1), 0); }

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * TEXEL;
    vec3 colors[TEXEL * TEXEL];
    float blurs[TEXEL * TEXEL];
    float least = 2.0 * focus.z;
    for (int n = 0; n < TEXEL * TEXEL; ++n) {
        vec4 pixel = scene_at(first + ivec2(n % TEXEL, n / TEXEL));
        colors[n] = pixel.rgb;
        blurs[n] = blur_of(pixel.a);
        if (abs(blurs[n]) < abs(least)) least = blurs[n];
    }
    vec4 sum = vec4(0.0);
    for (int n = 0; n < TEXEL * TEXEL; ++n) sum += vec4(colors[n], 1.0) * clamp(1.5 - abs(blurs[n] - least), 0.0, 1.0);
    FRAGMENT_COLOR = vec4(sum.rgb / sum.a, blur_code(least));
}
