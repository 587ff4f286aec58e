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

/// The value of ReplayOptions::phase by which no phase is stated.
inline constexpr const char* kNoPhase = "none";

struct ReplayOptions {
    std::string log;
    std::string output;    ///< folder
    std::string switches;  ///< switch log; empty: none
    std::string switch_config = "one_hot";
    std::string phase;  ///< stated for the whole run as by a switch; kNoPhase: motion states none; empty: as recorded
    /// For the detection of the phase from motion; nothing: the class of the aircraft file.
    std::optional<flight::AircraftClass> aircraft_class;
    PictureOptions picture;
    std::vector<std::string> ghosts;  ///< logs of other flights that are shown beside this one; at most kMaxGhosts
    GhostAlign ghost_align = GhostAlign::time;
    AccuracyShown accuracy;              ///< in a window: its state at the start; it is drawn on the screen alone
    std::optional<double> from_s, to_s;  ///< seconds since the log's first frame
    std::optional<double> step_s;        ///< nothing: the period of the device's frame rate; negative: backwards
    bool over_terrain = false;           ///< frames only where the flight is over the terrain; not with window
    /// Approximate number of frames, spread evenly and at events, instead of a step; 2 to kMaxSpread.
    std::optional<std::uint64_t> spread;
    std::optional<FrameOutput> frames;  ///< nothing: pictures, or hashes in a window
    bool window = false;
    bool keeps_index = true;     ///< keeps the index of a large log beside it (LOG.tdx)
    bool yes = false;            ///< a long run starts without a question (host_sim/replay/run_estimate.hpp)
    bool strict = false;         ///< the command returns kCheckFailedExitCode where there are findings
    bool layers = false;         ///< writes a layer mask beside every picture; not with window
    bool ledger = false;         ///< reports the cost of every effect that was replaced or left out; not with window
    std::string video;           ///< path of a film of the pictures (.mp4); empty: none; not with window
    std::string tour;            ///< file of camera poses (host_sim/window/camera_tour.hpp); with window only
    std::string save_config;     ///< file to which the configuration is written (replay_config.hpp); empty: none
    platform::CheckedPack pack;  ///< the pack that the options were read from; is_pack() is false where there is none
    /// The configuration that the options were read from, for the keys that only a board reads; null: none.
    std::shared_ptr<const platform::DisplayConfig> config;
    std::vector<std::string> notes;  ///< sentences for the summary and the report, from steps before the replay

    [[nodiscard]] FrameOutput frame_output() const { return frames.value_or(window ? FrameOutput::hash : FrameOutput::png); }
};

}  // namespace tedavis::host_sim
