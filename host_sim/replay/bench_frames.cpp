#include "host_sim/replay/bench_frames.hpp"

#include "platform/clock/monotonic_clock.hpp"
#include "render_core/display/preroll.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint32_t kWarmUp = 2;  // frames of each side that are not counted

void take_turn(BenchSide& side) {
    side.session->make_current();
    effects::FrameBudget& budget = side.session->display().memory().budget;
    budget.give_up(side.given_up);
    if (side.level) budget.pin(*side.level);
}

}  // namespace

BenchSide open_bench_side(const BenchPlace& place, const PictureOptions& options,
                          const std::optional<effects::QualityLevel>& level) {
    BenchSide side{std::make_shared<DisplaySession>(options, false), {}, level};
    take_turn(side);
    display::Display& display = side.session->display();
    if (!options.terrain.empty()) display::settle(display, {posed_aircraft(place.pose, display), {}, place.pose.time});
    side.session->rest();
    return side;
}

double bench_frame_ms(const BenchPlace& place, BenchSide& side, std::uint32_t n) {
    DisplaySession& session = *side.session;
    take_turn(side);
    AircraftPose pose = place.pose;
    pose.time = pose.time + base::Duration::from_seconds(n / session.device().frame_rate_hz);
    const flight::AircraftState state = posed_aircraft(pose, session.display());
    const base::Time start = platform::monotonic_now();
    session.display().plan({state, {}, pose.time});
    session.draw();
    const double ms = (platform::monotonic_now() - start).to_seconds() * 1000;
    session.rest();
    return ms;
}

std::vector<std::vector<double>> bench_frames_ms(const BenchPlace& place, std::vector<BenchSide>& sides, std::uint32_t rounds) {
    std::vector<std::vector<double>> ms(sides.size());
    for (std::uint32_t n = 0; n < rounds + kWarmUp; ++n)
        for (std::size_t k = 0; k < sides.size(); ++k) {
            const std::size_t side = n % 2 == 0 ? k : sides.size() - 1 - k;
            const double frame = bench_frame_ms(place, sides[side], n);
            if (n >= kWarmUp) ms[side].push_back(frame);
        }
    return ms;
}

}  // namespace tedavis::host_sim
