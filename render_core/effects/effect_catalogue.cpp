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
    {Effect::haze, "haze", Contribution::color, Need::nothing, true, "1 - exp(-farthest ground / haze distance)",
     "an exponential a vertex, and a blend a pixel"},
    {Effect::ground_data, "ground_data", Contribution::content, Need::nothing, true, "",
     "taps of the slice and of its colours, a pixel of the ground"},
    {Effect::adjacent, "adjacent", Contribution::content, Need::nothing, true, "", "quads of the symbology"},
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

bool has(const DeviceCapability& device, Need need) noexcept { return need == Need::nothing || device.depth24_targets; }

std::string_view lack_of(Need need) noexcept {
    return need == Need::depth24_target ? "the device has no 24-bit depth off screen" : "";
}

}  // namespace tedavis::effects
