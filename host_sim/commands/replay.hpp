/// `tedavis replay X.log`: a recorded bus through the core into frames, records and a report.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/console.hpp"
#include "host_sim/replay/asked_weights.hpp"
#include "render_core/design/view_effects.hpp"
#include "render_core/effects/effect_planner.hpp"

namespace tedavis::host_sim {

enum class FrameOutput : std::uint8_t { png, hash, none };
enum class GlChoice : std::uint8_t { egl, osmesa };

/// Of a picture, for measures of one aspect: data on the ground over a plain one, or the plain ground alone.
enum class ShownAspects : std::uint8_t { all, terrain, ground_data, nothing };

struct PictureSize {
    std::uint32_t width = 0, height = 0;
};

/// What replay and shot share. Names of shipped files may be short ("cruise"); the command resolves them.
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

struct ReplayOptions {
    std::string log;
    std::string output;    ///< folder
    std::string switches;  ///< switch log; empty: none
    std::string switch_config = "one_hot";
    PictureOptions picture;
    std::optional<double> from_s, to_s;  ///< seconds since the log's first frame
    std::optional<double> step_s;        ///< nothing: one frame of the device's rate; negative: backwards
    std::optional<FrameOutput> frames;   ///< nothing: pictures, in the window hashes
    bool window = false;
    bool strict = false;      ///< findings end it with kCheckFailedExitCode
    bool layers = false;      ///< beside every picture which layer each of its pixels is of; not with window
    bool ledger = false;      ///< adds the price of every effect that was replaced or left out; not with window
    std::string tour;         ///< path file for the camera (host_sim/window/camera_tour.hpp); with window only
    std::string save_config;  ///< writes data, design and parameters to this file

    [[nodiscard]] FrameOutput frame_output() const { return frames.value_or(window ? FrameOutput::hash : FrameOutput::png); }
};

/// Returns the exit code; throws UserError.
[[nodiscard]] int run_replay(const ReplayOptions& options, Console& console);

}  // namespace tedavis::host_sim
