#include "render_core/effects/effect_catalogue.hpp"

namespace tedavis::effects {
namespace {

constexpr std::array<EffectEntry, kEffectCount> kCatalogue{{
    {Effect::terrain, "terrain", Contribution::content, Need::nothing, false, "", "the terrain pass"},
    {Effect::warning_colors, "warning_colors", Contribution::content, Need::nothing, false, "",
     "a variant of the terrain's program"},
    {Effect::silhouettes,
     "silhouettes",
     Contribution::content,
     Need::depth24_target,
     true,
     "",
     "a picture off screen, and a pass of five taps",
     {Effect::ridges, Effect::count_}},
    {Effect::ridges, "ridges", Contribution::content, Need::nothing, false, "", "a variant of the terrain's program"},
    {Effect::moving_sun,
     "moving_sun",
     Contribution::content,
     Need::nothing,
     true,
     "",
     "shadows anew at every quarter of a degree",
     {Effect::fixed_light, Effect::count_}},
    {Effect::fixed_light, "fixed_light", Contribution::content, Need::nothing, false, "", "none"},
    {Effect::drape,
     "drape",
     Contribution::content,
     Need::nothing,
     true,
     "",
     "pages of the image, and a tap",
     {Effect::plain_color, Effect::count_}},
    {Effect::plain_color, "plain_color", Contribution::content, Need::nothing, false, "", "none"},
    {Effect::aerial_perspective,
     "aerial_perspective",
     Contribution::color,
     Need::half_float_texture,
     true,
     "1 - what is left of the strongest band over the farthest ground, at the densest air",
     "three taps and a root a pixel; a table of 64 x 64 a step of the eye's height",
     {Effect::haze, Effect::count_}},
    {Effect::haze, "haze", Contribution::color, Need::nothing, true, "1 - exp(-farthest ground / haze distance)",
     "an exponential a vertex, and a blend a pixel"},
    {Effect::surface_grid, "surface_grid", Contribution::content, Need::nothing, true, "",
     "two lines' distances, a pixel of the ground; three, and a place's latitude, longitude and height, a pixel of data"},
    {Effect::ground_data, "ground_data", Contribution::content, Need::nothing, true, "",
     "taps of the slice and of its colours, a pixel of the ground"},
    {Effect::adjacent, "adjacent", Contribution::content, Need::nothing, true, "", "quads of the symbology"},
    {Effect::depth_of_field, "depth_of_field", Contribution::geometry, Need::second_picture, true,
     "the widest blur between the nearest ground and the farthest", "a picture off screen, and a pass of seventeen taps"},
    {Effect::antialiasing, "antialiasing", Contribution::geometry, Need::second_picture, true,
     "one pixel, where anything has an edge", "a picture off screen, and a pass of five taps; four more at edges"},
    {Effect::panel_lighting, "panel_lighting", Contribution::color, Need::nothing, true, "1 - the darkest factor",
     "a blended pass over the display"},
    {Effect::stereo, "stereo", Contribution::geometry, Need::second_picture, true,
     "the greatest parallax between the nearest ground and the farthest",
     "the scene twice, into a picture off screen, and a tap"},
    {Effect::cross_fade, "cross_fade", Contribution::color, Need::second_picture, true, "the share of the scene as it was",
     "the scene as it was, once, into a picture off screen; then a blended tap"},
    {Effect::vertical_lines, "vertical_lines", Contribution::content, Need::nothing, true, "",
     "twelve triangles a line; those that travel are built every frame"},
    {Effect::projections, "projections", Contribution::content, Need::nothing, true, "", "two triangles a stretch of 200 m"},
    {Effect::curtains, "curtains", Contribution::content, Need::nothing, true, "",
     "two triangles a stretch of 200 m, blended on both sides"},
    {Effect::soft_shadows,
     "soft_shadows",
     Contribution::geometry,
     Need::shadow_map,
     true,
     "the widest thing that casts one, in pixels over the nearest ground",
     "a map of up to three levels; 10 taps a pixel of the ground, 32 more in a shadow",
     {Effect::projections, Effect::count_}},
    {Effect::volumetric_light,
     "volumetric_light",
     Contribution::color,
     Need::shadow_map_and_picture,
     true,
     "its strength times that of air, or of haze",
     "the same map; a pass of a tap a step at half the picture's size, and one of four taps",
     {Effect::soft_shadows, Effect::projections}},
    {Effect::focus_ground, "focus_ground", Contribution::content, Need::nothing, true, "",
     "a variant of the terrain's program; six taps and two for each point that is near, a pixel of ground at a rim or between"},
    {Effect::focus_blur,
     "focus_blur",
     Contribution::geometry,
     Need::second_picture,
     true,
     "the blur of the context",
     "a picture off screen, and a pass of seventeen taps",
     {Effect::focus_ground, Effect::count_}},
    {Effect::saliency, "saliency", Contribution::content, Need::picture_copy, true, "",
     "a copy of the picture, and some eighty passes at a quarter of its size, an eighth on ES 2; a blended tap"},
    {Effect::clutter, "clutter", Contribution::content, Need::picture_copy, true, "",
     "for a budget, twice a second (once on ES 2): edges of the picture, and the scene up to six times; as a view edges of "
     "every "
     "picture and a blended tap"},
}};

constexpr bool is_in_order() {
    for (std::size_t n = 0; n < kEffectCount; ++n)
        if (kCatalogue[n].effect != static_cast<Effect>(n)) return false;
    return true;
}
static_assert(is_in_order());

}  // namespace

const EffectEntry& entry_of(Effect effect) noexcept { return kCatalogue[static_cast<std::size_t>(effect)]; }

Effect effect_of(std::string_view name) noexcept {
    for (const EffectEntry& entry : kCatalogue)
        if (entry.name == name) return entry.effect;
    return Effect::count_;
}

bool has(const DeviceCapability& device, Need need) noexcept {
    if (need == Need::depth24_target) return device.depth24_targets;
    if (need == Need::second_picture) return device.gl.calls == CallClass::es3 && device.off_screen_pictures >= 2;
    if (need == Need::shadow_map_and_picture) return has(device, Need::shadow_map) && has(device, Need::second_picture);
    if (need == Need::shadow_map) return device.gl.calls == CallClass::es3 && device.shadow_map_px > 0;
    if (need == Need::picture_copy) return device.gl.calls != CallClass::sc2;
    return need == Need::nothing || device.gl.calls == CallClass::es3;
}

std::string_view lack_of(Need need) noexcept {
    if (need == Need::depth24_target) return "the device has no 24-bit depth off screen";
    if (need == Need::second_picture) return "the device has no second picture off screen that is read by texels";
    if (need == Need::shadow_map_and_picture) return "the device has no map of shadows, or no second picture off screen";
    if (need == Need::shadow_map) return "the device has no map of shadows";
    if (need == Need::picture_copy) return "the device cannot copy what it has drawn";
    return need == Need::half_float_texture ? "the device has no textures of half floats" : "";
}

}  // namespace tedavis::effects
