/// Effects on the finished picture of the scene, before symbology is laid over it: table [effects] of a design file.
///
///     [effects]
///     antialiasing = "device"     # edges are smoothed where the device can afford it; or true, false: on every device
///     fade_s = 0.5                # the scene fades into what another design or new data make of it; 0: at once
///     lighting = "auto"           # the panel's: "day", "dusk", "night", or by the sun of place and date
///     dusk_color = "#b8aa98"      # what white becomes at dusk
///     night_color = "#584c40"
///     [effects.depth_of_field]
///     blur_px = 5                 # radius of the blur of what is infinitely far
///     taps = 16                   # places that the blur of a square of pixels reads: more of them are smoother and slower
///     focus_near_m = 2000         # sharp from here
///     focus_far_m = 15000         # to here, from the eye
///     focus_role = "storm_cell"   # instead: as far as the shown layers of this role reach
///     layers = "all"              # or "terrain", "data": what is blurred; the others stay sharp
///     [effects.stereo]
///     mode = "side_by_side"       # each eye's picture in a half of the screen, squeezed; or "anaglyph": red and cyan glasses
///     base_m = 2                  # between the eyes; at most a 30th of screen_m, and a sixth of what is nearest
///     screen_m = 300              # what is so far away lies in the screen's plane, with the symbology
///
///     [effects.saliency]          # what draws the eye (perception/saliency_model.hpp) in all that is shown, symbology too
///     view = "heat"               # over the picture; or "map": alone
///     scale = "picture"           # the most salient place of every picture is 1; or "fixed": pictures can be compared
///     [effects.clutter]           # edges (perception/edge_detector.hpp) of all that is shown
///     view = "edges"              # alone; or "regions": how dense they are, over the picture
///
///     [effects.instead]
///     silhouettes = []            # nothing takes their place; else names of effects, the first that is possible
///
/// [effects.shadows] is described in shadow_settings.hpp.
///
/// Plain data; pixels of the picture, metres. Reading: start-up only, faults go to the section.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "render_core/base/config_reader.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/design/color.hpp"
#include "render_core/design/shadow_settings.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::design {

inline constexpr double kMaxBlur_px = 8;
inline constexpr std::int64_t kMinBlurTaps = 4, kMaxBlurTaps = 64;
inline constexpr double kLongestFade_s = 2;  ///< a longer fade would show outdated content

/// Whether edges are smoothed; `by_device`: where the device can afford it, which effects::design_on() decides.
enum class Antialiasing : std::uint8_t { off, on, by_device };
inline constexpr std::string_view kAntialiasingByDevice = "device";

struct DepthOfField {
    double blur_px = 0;       ///< 0: everything is sharp
    std::uint32_t taps = 16;  ///< places that the blur of a square of pixels reads
    double focus_near_m = 0, focus_far_m = 10'000;
    scene::LayerRole focus_role = scene::LayerRole::count;  ///< not `count`: the focus is on data of this role
    bool on_terrain = true, on_data = true;
};

/// The brightness of the whole display. Every colour is multiplied, those of symbols and warnings too, so that contrasts are
/// the same by day and at night.
enum class PanelLighting : std::uint8_t { day, dusk, night, automatic };
inline constexpr std::array<std::string_view, 4> kPanelLightingNames{"day", "dusk", "night", "auto"};

/// Stereo: a picture for each eye. Colours of an anaglyph are not reliable, since each eye sees only a part of them.
enum class StereoMode : std::uint8_t { none, side_by_side, anaglyph };

struct Stereo {
    StereoMode mode = StereoMode::none;
    double base_m = 2, screen_m = 300;
};

/// How the saliency map of the picture is shown; a tool to evaluate designs, not for flight.
enum class SaliencyView : std::uint8_t { none, heat, map };
inline constexpr std::array<std::string_view, 2> kSaliencyViewNames{"heat", "map"};  ///< starting with `heat`
enum class SaliencyScale : std::uint8_t { picture, fixed };

struct Saliency {
    SaliencyView view = SaliencyView::none;  ///< none: saliency is not measured
    SaliencyScale scale = SaliencyScale::picture;
};

/// How clutter of the picture is shown; also a tool to evaluate designs. The clutter budget is in priority.hpp.
enum class ClutterView : std::uint8_t { none, edges, regions };
inline constexpr std::array<std::string_view, 2> kClutterViewNames{"edges", "regions"};  ///< starting with `edges`

/// An effect and its replacements where a device cannot do it or the deadline does not allow it: the first possible one is
/// used. Names are those of render_core/effects; an empty list means no replacement.
struct InsteadOf {
    base::FixedString<31> effect;
    base::FixedVector<base::FixedString<31>, 2> instead;
};
inline constexpr std::size_t kMaxInsteadOf = 8;

struct ViewEffects {
    Antialiasing antialiasing = Antialiasing::off;
    double fade_s = 0;
    PanelLighting lighting = PanelLighting::day;
    Color dusk{0xB8, 0xAA, 0x98}, night{0x58, 0x4C, 0x40};  ///< what white becomes
    DepthOfField depth_of_field;
    Stereo stereo;
    Saliency saliency;
    ClutterView clutter = ClutterView::none;
    base::FixedVector<InsteadOf, kMaxInsteadOf> instead;  ///< replacements that differ from the effects' defaults
    ShadowSettings shadows;
};

void read_view_effects(base::ConfigSection section, ViewEffects& effects);

}  // namespace tedavis::design
