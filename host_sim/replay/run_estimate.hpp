/// What a replay will take, said before it begins, so that nobody fills a disk by mistake.
#pragma once

#include <cstdint>
#include <string>

#include "host_sim/console.hpp"
#include "host_sim/options/replay_options.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/flight_player.hpp"
#include "host_sim/replay/frame_instants.hpp"

namespace tedavis::host_sim {

struct RunEstimate {
    std::uint64_t frames = 0;
    double seconds = 0;  ///< on this machine, as busy as it is now
    double bytes = 0;    ///< of pictures and records, without a film and layer masks
};

/// Fewer frames are flown without a word.
inline constexpr std::uint64_t kFramesWithoutAWord = 200;
/// More frames or bytes need an answer or --yes. Numbers that do not depend on the machine, so that a script that runs on one
/// runs on all.
inline constexpr std::uint64_t kFramesWithoutAsking = 20'000;
inline constexpr double kBytesWithoutAsking = 4e9;

/// By three frames along the run, which are drawn for this and belong to no run: pictures and records of the run stay as they
/// are without it. Throws UserError as drawing does.
[[nodiscard]] RunEstimate estimate_run(const ReplayOptions& options, const FrameInstants& times, FlightPlayer& player,
                                       DisplaySession& session);

/// "585300 frames, about 5.0 h and 80 GB".
[[nodiscard]] std::string words_of(const RunEstimate& estimate);

/// Says what the run will take where it is longer than kFramesWithoutAWord. Beyond the limits it asks, unless `options.yes`.
/// Throws UserError where the answer is no or nobody can answer.
void require_consent(const RunEstimate& estimate, const ReplayOptions& options, Console& console);

}  // namespace tedavis::host_sim
