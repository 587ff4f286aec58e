#include "host_sim/window/live_window.hpp"

#include <chrono>
#include <filesystem>
#include <optional>
#include <thread>

#include "host_sim/interrupt.hpp"
#include "host_sim/replay/generated_flight.hpp"
#include "host_sim/replay/started_pack.hpp"
#include "host_sim/window/live_run.hpp"
#include "host_sim/window/start_screen.hpp"
#include "platform/clock/monotonic_clock.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::chrono::milliseconds kRest(2);

int run_until_closed(LiveRun& run, const InterruptGuard& interrupt, Console& console) {
    console.note("press h in the window for its keys");
    base::Time before = platform::monotonic_now();
    while (!run.closed() && !interrupt.requested()) {
        const base::Time now = platform::monotonic_now();
        if (!run.turn(now - before)) std::this_thread::sleep_for(kRest);
        before = now;
    }
    return run.finish(interrupt.requested());
}

}  // namespace

int run_live_window(const ReplayOptions& options, Console& console, const WindowMaker& make_window) {
    const InterruptGuard interrupt;
    platform::Window* window = nullptr;
    const SurfaceMaker make_surface =
        [&](const platform::SurfaceSettings& settings) -> base::Result<std::unique_ptr<base::Surface>, base::Error> {
        auto made = make_window(settings, "TEDAVIS");
        if (!made.ok()) return base::fail(made.error());
        window = made.value().get();
        return std::unique_ptr<base::Surface>(std::move(made.value()));
    };
    const std::optional<DisplayFiles> files = IntervalStore::files_before_start(options);
    DisplaySession session(options.picture, is_generated_flight(options.log), make_surface);
    require_uninterrupted(options.output);
    StartScreen screen(*window, session, std::filesystem::path(options.log).filename().string());
    IndexPolicy policy = index_policy(options);
    policy.told = [&screen](std::uint64_t done, std::uint64_t total) { screen.show(done, total, platform::monotonic_now()); };
    FlightPlayer player(player_files(options), session.display(), &console, policy);
    if (const std::string age = words_of_started(options.pack, player.first()); !age.empty()) console.note("note: " + age);
    require_uninterrupted(options.output);
    LiveRun run(options, files, session, player, *window, console);
    run.handle(screen.events());
    return run_until_closed(run, interrupt, console);
}

}  // namespace tedavis::host_sim
