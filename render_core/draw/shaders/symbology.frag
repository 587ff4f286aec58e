// Coverage of a box or of a glyph by its distance to the edge (quad_batch.hpp).
#ifdef GLYPHS
uniform sampler2D atlas;
#endif
#ifdef AMONG_TERRAIN
uniform float is_nearer;  // 1 in the nearer range of depth
VARYING float v_parting;
#endif

VARYING vec2 v_uv;
VARYING vec2 v_extent;
VARYING vec4 v_color;

void main() {
    vec2 room = v_extent - abs(v_uv);
    float coverage = min(room.x, room.y) + 0.5;
#ifdef GLYPHS
    float glyph = (TEXTURE2D(atlas, v_uv).r - 0.5) * v_extent.y - v_extent.x - 0.5;
    coverage = v_extent.x < 0.0 ? glyph : coverage;
#endif
#ifdef AMONG_TERRAIN
    coverage *= abs(is_nearer - step(v_parting, 1.0));  // each pixel in one range
#endif
    FRAGMENT_COLOR = vec4(v_color.rgb, v_color.a * clamp(coverage, 0.0, 1.0));
}
