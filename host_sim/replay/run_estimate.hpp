/// Estimates the time and disk space of a replay before it begins, so that nobody fills a disk by mistake.
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
    double bytes = 0;    ///< for pictures and records, without a film and layer masks
};

/// Runs of up to this many frames begin without a message.
inline constexpr std::uint64_t kFramesWithoutAWord = 200;
/// Runs with more frames or bytes need a confirmation or --yes. The limits do not depend on the machine, so that a script behaves
/// equally on all.
inline constexpr std::uint64_t kFramesWithoutAsking = 20'000;
inline constexpr double kBytesWithoutAsking = 4e9;

/// Draws three frames along the run, which are not kept and do not change the pictures and records of the run. Throws UserError
/// as drawing does.
[[nodiscard]] RunEstimate estimate_run(const ReplayOptions& options, const FrameInstants& times, FlightPlayer& player,
                                       DisplaySession& session);

/// "585300 frames, about 5.0 h and 80 GB".
[[nodiscard]] std::string words_of(const RunEstimate& estimate);

/// Prints the estimate if the run has more than kFramesWithoutAWord frames, and asks for a confirmation above the limits unless
/// `options.yes`. Throws UserError where the answer is no or there is nobody to answer, and Interrupted.
void require_consent(const RunEstimate& estimate, const ReplayOptions& options, Console& console);

}  // namespace tedavis::host_sim
