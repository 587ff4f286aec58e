/// Options of a picture, shared by all commands that draw with the display.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/options/asked_weights.hpp"
#include "host_sim/options/ghost_options.hpp"
#include "render_core/base/valid_period.hpp"
#include "render_core/design/symbology_palette.hpp"
#include "render_core/design/view_effects.hpp"
#include "render_core/effects/effect_planner.hpp"
#include "render_core/flight/legend_show.hpp"

namespace tedavis::host_sim {

enum class GlChoice : std::uint8_t { egl, osmesa };

/// The parts of a picture to draw, to measure one aspect: everything, the terrain alone, data over a plain ground, or the plain
/// ground alone.
enum class ShownAspects : std::uint8_t { all, terrain, ground_data, nothing };

/// The folders in which the files lie that a design names by short names.
struct DesignFolders {
    /// True: the shipped folders; false: the two below, as a configuration file states them (display_config.hpp).
    bool shipped = true;
    std::string designs;   ///< ends in a slash; empty: the folder of the design that names the file
    std::string palettes;  ///< ends in a slash; empty: the working folder
};

struct PictureSize {
    std::uint32_t width = 0, height = 0;
};

/// Files are paths, or short names of shipped files ("cruise"), which the command resolves.
struct PictureOptions {
    std::string terrain;             ///< .tdb; empty: no terrain
    std::string scene;               ///< .sdb; empty: no spatial data
    ShownGhosts ghosts;              ///< set by a replay alone (replay/ghost_flights.hpp)
    base::ValidPeriod valid_period;  ///< of terrain and scene; open: no dates are stated
    std::string design = "default";
    DesignFolders design_folders;
    std::string device = "es3-mid";
    std::string bus = "canaerospace";
    std::string aircraft;  ///< aircraft file; empty: none
    std::string palette;   ///< of the symbology; empty: the standard one
    design::SymbologyLight light = design::SymbologyLight::day;
    std::optional<PictureSize> size;  ///< pixels; nothing: the device's size
    GlChoice gl = GlChoice::egl;      ///< ignored by the window, which has a surface of its own
    std::optional<double> tau_px;     ///< nothing: the design's
    std::optional<double> detail;     ///< detail of all data, 0..1; nothing: the design's
    AskedWeights weights;             ///< weights of aspects; missing ones are the design's
    ShownAspects shown = ShownAspects::all;
    std::vector<std::string> foci;      ///< foci that come before the design's (design::read_focus)
    std::optional<double> deadline_ms;  ///< of a frame; nothing: there is none
    std::string costs;                  ///< file of costs that `calibrate` wrote; empty: costs are unknown
    bool force_effects = false;         ///< no effect is left out as invisible
    /// Whether and how the saliency map is shown, on the design's scale; nothing: as the design states.
    std::optional<design::SaliencyView> saliency;
    std::optional<design::ClutterView> clutter;           ///< edges, or their density by regions; nothing: as the design states
    effects::EffectSet with, without;                     ///< effects added to the design (effects::with_effect), and removed
    effects::EffectSet forbidden;                         ///< effects treated as if the device file forbade them
    flight::LegendShow legend = flight::LegendShow::key;  ///< shown unless switches or the bus request another one
    [[nodiscard]] const std::string& drawn_scene() const { return ghosts.scene.empty() ? scene : ghosts.scene; }
    bool symbology = true;  ///< false: of the symbology, only the legend and the map's own ship and scale are drawn
};

}  // namespace tedavis::host_sim
