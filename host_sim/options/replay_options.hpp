/// Options of a replay, in batch or in a window.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/options/accuracy_shown.hpp"
#include "host_sim/options/picture_options.hpp"
#include "platform/configuration/display_config.hpp"
#include "platform/configuration/pack_check.hpp"
#include "render_core/flight/motion_phase_settings.hpp"

namespace tedavis::host_sim {

/// Greatest ReplayOptions::spread.
inline constexpr std::uint32_t kMaxSpread = 1'000'000;

enum class FrameOutput : std::uint8_t { png, hash, none };

/// Of ReplayOptions::phase.
inline constexpr const char* kNoPhase = "none";

struct ReplayOptions {
    std::string log;
    std::string output;    ///< folder
    std::string switches;  ///< switch log; empty: none
    std::string switch_config = "one_hot";
    std::string phase;  ///< holds for the whole run as if a switch stated it; kNoPhase: motion states none; empty: as recorded
    std::optional<flight::AircraftClass> aircraft_class;  ///< by which motion tells the phase; nothing: that of the aircraft file
    PictureOptions picture;
    std::vector<std::string> ghosts;  ///< logs of other flights that are shown beside this one; at most kMaxGhosts
    GhostAlign ghost_align = GhostAlign::time;
    AccuracyShown accuracy;               ///< in a window only at its start, and on the screen alone
    std::optional<double> from_s, to_s;   ///< seconds since the log's first frame
    std::optional<double> step_s;         ///< nothing: one frame of the device's rate; negative: backwards
    bool over_terrain = false;            ///< only while the flight is over the terrain; not with window
    std::optional<std::uint64_t> spread;  ///< about so many frames evenly, and at events, instead of a step; at least 2
    std::optional<FrameOutput> frames;    ///< nothing: pictures; in a window, hashes
    bool window = false;
    bool keeps_index = true;     ///< of a large log, beside it
    bool yes = false;            ///< a long run needs no answer (host_sim/replay/run_estimate.hpp)
    bool strict = false;         ///< findings give kCheckFailedExitCode
    bool layers = false;         ///< writes a layer mask beside every picture; not with window
    bool ledger = false;         ///< reports the cost of every effect that was replaced or left out; not with window
    std::string video;           ///< film of the pictures (.mp4); empty: none; not with window
    std::string tour;            ///< path file for the camera (host_sim/window/camera_tour.hpp); with window only
    std::string save_config;     ///< writes data, design and parameters to this file
    platform::CheckedPack pack;  ///< that the options come from; is_pack() is false where they come from none
    std::shared_ptr<const platform::DisplayConfig> config;  ///< that they come from, for what the board alone has; null: none
    std::vector<std::string> notes;                         ///< sentences of earlier steps, for the summary and the report

    [[nodiscard]] FrameOutput frame_output() const { return frames.value_or(window ? FrameOutput::hash : FrameOutput::png); }
};

}  // namespace tedavis::host_sim
