#include "render_core/design/view_effects.hpp"

#include "render_core/design/config_values.hpp"

namespace tedavis::design {
namespace {

enum class BlurredLayers : std::uint8_t { terrain, data, all };
constexpr std::string_view kBlurredLayerNames[] = {"terrain", "data", "all"};
/// As files name them; no surface here can show the last one.
enum class StereoDevice : std::uint8_t { side_by_side, anaglyph, quad_buffer };
constexpr std::string_view kStereoDeviceNames[] = {"side_by_side", "anaglyph", "quad_buffer"};

void read_depth_of_field(base::ConfigSection section, DepthOfField& field) {
    if (!section.present()) return;
    field.blur_px = section.number("blur_px", 0.5, kMaxBlur_px, 4);
    field.taps = static_cast<std::uint32_t>(section.integer("taps", kMinBlurTaps, kMaxBlurTaps, field.taps));
    field.focus_near_m = section.number("focus_near_m", 0, 1e6, field.focus_near_m);
    field.focus_far_m = section.number("focus_far_m", 1, 1e6, field.focus_far_m);
    if (field.focus_near_m >= field.focus_far_m) fault_of(section, "focus_far_m", "must be farther than focus_near_m");
    section.choose("focus_role", scene::kLayerRoleNames, field.focus_role);
    BlurredLayers layers = BlurredLayers::all;
    section.choose("layers", kBlurredLayerNames, layers);
    field.on_terrain = layers != BlurredLayers::data;
    field.on_data = layers != BlurredLayers::terrain;
}

void read_stereo(base::ConfigSection section, Stereo& stereo) {
    if (!section.present()) return;
    StereoDevice device = StereoDevice::side_by_side;
    section.choose("mode", kStereoDeviceNames, device);
    if (device == StereoDevice::quad_buffer)
        fault_of(section, "mode", "no surface here has a buffer for each eye; choose side_by_side or anaglyph");
    stereo.mode = device == StereoDevice::anaglyph ? StereoMode::anaglyph : StereoMode::side_by_side;
    stereo.base_m = section.number("base_m", 0.01, 1000, stereo.base_m);
    stereo.screen_m = section.number("screen_m", 1, 1e6, stereo.screen_m);
}

void read_saliency(base::ConfigSection section, Saliency& saliency) {
    constexpr std::string_view kScales[] = {"picture", "fixed"};
    if (!section.present()) return;
    saliency.view = SaliencyView::heat;
    section.choose("view", kSaliencyViewNames, saliency.view, SaliencyView::heat);
    section.choose("scale", kScales, saliency.scale);
}

void read_clutter(base::ConfigSection section, ViewEffects& effects) {
    if (!section.present()) return;
    effects.clutter = ClutterView::edges;
    section.choose("view", kClutterViewNames, effects.clutter, ClutterView::edges);
    if (effects.saliency.view != SaliencyView::none)
        fault_of(section, "view", "would lie over the saliency map; leave out [effects.saliency] or this table");
}

void read_instead(base::ConfigSection section, base::FixedVector<InsteadOf, kMaxInsteadOf>& all) {
    if (!section.present()) return;
    all.clear();
    for (std::size_t n = 0; n < section.key_count(); ++n) {
        InsteadOf one;
        one.effect = base::FixedString<31>(section.key_at(n));
        std::array<std::string_view, 2> names;
        const std::size_t count = section.texts(section.key_at(n), names);
        for (std::size_t k = 0; k < count && k < names.size(); ++k)
            static_cast<void>(one.instead.try_push_back(base::FixedString<31>(names[k])));
        if (!all.try_push_back(one)) fault_of(section, section.key_at(n), "more effects than can be stated; leave one out");
    }
}

}  // namespace

void read_view_effects(base::ConfigSection section, ViewEffects& effects) {
    section.boolean_or("antialiasing", kAntialiasingByDevice, effects.antialiasing);
    effects.fade_s = section.number("fade_s", 0, kLongestFade_s, effects.fade_s);
    section.choose("lighting", kPanelLightingNames, effects.lighting);
    read_color(section, "dusk_color", effects.dusk);
    read_color(section, "night_color", effects.night);
    read_depth_of_field(section.section("depth_of_field"), effects.depth_of_field);
    read_stereo(section.section("stereo"), effects.stereo);
    read_saliency(section.section("saliency"), effects.saliency);
    read_clutter(section.section("clutter"), effects);
    read_instead(section.section("instead"), effects.instead);
    read_shadows(section.section("shadows"), effects.shadows);
    const DepthOfField& field = effects.depth_of_field;
    if (effects.shadows.in_air > 0 && field.blur_px > 0 && !(field.on_terrain && field.on_data))
        fault_of(section, "shadows", "with 'in_air' needs all distances; set layers = \"all\" in depth_of_field");
}

}  // namespace tedavis::design
