// Saliency: a level against its surroundings three and four levels coarser, added to what the coarser centres say. Of lightness and
// a (COLORS) or b (BLUE), apart what exceeds them and what falls short; of directions (ENERGY) either way.
uniform sampler2D first;   // the level
uniform sampler2D second;  // three levels coarser
uniform sampler2D third;   // four
uniform sampler2D fourth;  // what the next coarser centre says
uniform vec2 first_size;
uniform vec2 second_size;
uniform vec2 third_size;
uniform vec2 fourth_size;
uniform float has_coarser;

void main() {
    vec2 at = floor(gl_FragCoord.xy), middle = at + 0.5;
#ifdef ENERGY
    vec4 here = squared(texel_at(first, first_size, at));
    vec4 near = here - squares_between(second, second_size, middle / 8.0 - 0.5);
    vec4 far = here - squares_between(third, third_size, middle / 16.0 - 0.5);
    vec4 sum = abs(near) + abs(far);
#else
    vec3 here = triple_of(texel_at(first, first_size, at));
    vec3 near = here - triple_between(second, second_size, middle / 8.0 - 0.5);
    vec3 far = here - triple_between(third, third_size, middle / 16.0 - 0.5);
    vec3 above = max(near, 0.0) + max(far, 0.0), below = max(-near, 0.0) + max(-far, 0.0);
#ifdef COLORS
    vec4 sum = vec4(above.x, below.x, above.y, below.y);
#else
    vec4 sum = vec4(above.z, below.z, 0.0, 0.0);
#endif
#endif
    vec4 coarser = squares_between(fourth, fourth_size, middle / 2.0 - 0.5);
    FRAGMENT_COLOR = rooted(sum / 6.0 + has_coarser * coarser);
}
