/// What the user may ask of a picture: options that all commands share which draw with the display.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/options/asked_weights.hpp"
#include "render_core/design/view_effects.hpp"
#include "render_core/effects/effect_planner.hpp"

namespace tedavis::host_sim {

enum class GlChoice : std::uint8_t { egl, osmesa };

/// Of a picture, for measures of one aspect: data on the ground over a plain one, or the plain ground alone.
enum class ShownAspects : std::uint8_t { all, terrain, ground_data, nothing };

struct PictureSize {
    std::uint32_t width = 0, height = 0;
};

/// Names of shipped files may be short ("cruise"); the command resolves them.
struct PictureOptions {
    std::string terrain;  ///< .tdb; empty: no terrain
    std::string scene;    ///< .sdb; empty: no spatial data
    std::string design = "default";
    std::string device = "es3-mid";
    std::string bus = "canaerospace";
    std::optional<PictureSize> size;  ///< nothing: the device's
    GlChoice gl = GlChoice::egl;      ///< the window has a surface of its own
    std::optional<double> tau_px;     ///< nothing: the design's
    std::optional<double> detail;     ///< of all data, 0..1; nothing: the design's
    AskedWeights weights;             ///< of aspects; those that are missing are the design's
    ShownAspects shown = ShownAspects::all;
    std::vector<std::string> foci;      ///< before the design's (design::read_focus)
    std::optional<double> deadline_ms;  ///< of a frame; nothing: none
    std::string costs;                  ///< file of costs that `calibrate` measured; empty: none are known
    bool force_effects = false;         ///< none is left out for being unseen
    /// What draws the eye, over the picture; nothing: as the design says. On the design's scale.
    std::optional<design::SaliencyView> saliency;
    std::optional<design::ClutterView> clutter;  ///< edges, or their density by regions, over the picture; likewise
    effects::EffectSet with, without;            ///< effects added to the design (effects::with_effect), and removed
    effects::EffectSet forbidden;                ///< as if the device's file forbade them
    bool symbology = true;  ///< without it only the legend and the map's own ship and scale are drawn over the terrain
};

}  // namespace tedavis::host_sim
