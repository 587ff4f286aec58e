#include "host_sim/commands/replay.hpp"

#include "host_sim/commands/replay_config.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/flight_player.hpp"
#include "host_sim/replay/frame_approach.hpp"
#include "host_sim/replay/frame_instants.hpp"
#include "host_sim/replay/generated_flight.hpp"
#include "host_sim/replay/run_recorder.hpp"
#include "host_sim/user_error.hpp"
#include "host_sim/window/live_window.hpp"

namespace tedavis::host_sim {
namespace {

int run_batch(const ReplayOptions& options, Console& console) {
    DisplaySession session(options.picture, is_generated_flight(options.log));
    FlightPlayer player({options.log, options.picture.bus, options.switches, options.switch_config}, session.display(), &console);
    const FrameInstants times(options, player.first(), player.last(), session.device().frame_rate_hz);
    const InterruptGuard interrupt;  // before anything is written
    RunRecorder recorder(options, session, player);
    if (!options.save_config.empty()) save_replay_config(options, options.save_config);
    FrameApproach approach(player, session.display(), session.device().frame_rate_hz);
    for (std::uint64_t n = 0; n < times.count() && !interrupt.requested(); ++n) {
        approach.approach(times.at(n));
        static_cast<void>(recorder.draw(times.at(n)));
        recorder.keep();
        console.progress("replay", n + 1, times.count());
    }
    console.progress_done();
    return recorder.finish(interrupt.requested(), console);
}

}  // namespace

int run_replay(const ReplayOptions& options, Console& console) {
    return options.window ? run_live_window(options, console) : run_batch(options, console);
}

}  // namespace tedavis::host_sim
