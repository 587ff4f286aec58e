#include "platform/runtime/bench_frames.hpp"

#include <algorithm>
#include <utility>

#include "render_core/display/preroll.hpp"
#include "render_core/gl/readback.hpp"

namespace tedavis::platform {
namespace {

constexpr std::uint32_t kWarmUp = 2;  // frames of each side that are not counted
constexpr const char* kLost = "the drawing surface was lost; start the command again";
constexpr const char* kStopped = "interrupted; nothing was written";

}  // namespace

bool BenchFrames::fail(const char* message) {
    if (!fault_) fault_ = base::make_error(message);
    return false;
}

base::Error BenchFrames::open(const BenchPicture& picture, const std::optional<effects::QualityLevel>& level) {
    TEDAVIS_CHECK(host_count_ < kMaxDisplays && side_count_ < kMaxSides);
    if (fault_) return fault_;
    std::unique_ptr<DisplayHost>& host = hosts_[host_count_];
    opened_ = picture;
    if (opened_.design.terrain.renderer == design::TerrainRenderer::automatic)
        opened_.design.terrain.renderer = design::TerrainRenderer::raster;
    if (base::Error error = displays_.open(opened_, host)) {
        host.reset();
        return error;
    }
    ++host_count_;
    Side& side = sides_[side_count_++];
    side = {host.get(), {}, level};
    if (!take_turn(side)) return fault_;
    display::Display& display = host->display();
    if (const auto* const terrain = display.planner().terrain_database(); terrain != nullptr) {
        undulation_ = terrain->undulation(place_.pose.latitude_rad, place_.pose.longitude_rad);
        display::settle(display, {aircraft(display, place_.time), {}, place_.time});
    }
    host->release_current();
    return {};
}

void BenchFrames::share(const effects::EffectSet& given_up, const std::optional<effects::QualityLevel>& level) {
    TEDAVIS_CHECK(side_count_ > 0 && side_count_ < kMaxSides);
    sides_[side_count_] = {sides_[side_count_ - 1].host, given_up, level};
    ++side_count_;
}

void BenchFrames::close() {
    for (std::size_t n = 0; n < host_count_; ++n) hosts_[n].reset();
    host_count_ = side_count_ = 0;
}

bool BenchFrames::take_turn(Side& side) {
    if (!side.host->make_current()) return fail(kLost);
    effects::FrameBudget& budget = side.host->display().memory().budget;
    budget.give_up(side.given_up);
    if (side.level) budget.pin(*side.level);
    return true;
}

flight::AircraftState BenchFrames::aircraft(display::Display& display, base::Time time) const {
    flight::AircraftState state = flight::posed_state(place_.pose, undulation_, time);
    state[flight::Signal::height_above_terrain] = display.planner().height_above_terrain(state.own_ship, time);
    return state;
}

bool BenchFrames::draw(std::size_t n_side, std::uint32_t n, double& ms, base::Span<std::uint8_t> pixels) {
    if (fault_) return false;
    if (displays_.is_stopped()) return fail(kStopped);
    Side& side = sides_[n_side];
    if (!take_turn(side)) return false;
    display::Display& display = side.host->display();
    const double rate_hz = display.planner().settings().device.frame_rate_hz;
    const base::Time time = place_.time + base::Duration::from_seconds(n / rate_hz);
    const flight::AircraftState state = aircraft(display, time);
    const base::Time start = displays_.now();
    display.plan({state, {}, time});
    const bool is_drawn = displays_.draw(*side.host);
    ms = (displays_.now() - start).to_seconds() * 1000;
    const base::Surface& surface = side.host->surface();
    const bool is_read = pixels.empty() || gl::read_pixels(display.gl(), surface.width(), surface.height(), pixels);
    side.host->release_current();
    return (is_drawn && is_read) || fail(kLost);
}

bool BenchFrames::take_times(std::uint32_t rounds) {
    rounds_ = std::min(rounds, kMaxRounds);
    for (std::uint32_t n = 0; n < rounds_ + kWarmUp; ++n)
        for (std::size_t k = 0; k < side_count_; ++k) {
            const std::size_t side = n % 2 == 0 ? k : side_count_ - 1 - k;
            double ms = 0;
            if (!draw(side, n, ms)) return false;
            if (n >= kWarmUp) times_[side][n - kWarmUp] = ms;
        }
    return true;
}

effects::PairedCost BenchFrames::cost_between(std::size_t with, std::size_t without) {
    return effects::paired_cost(ms(with), ms(without), {room_.data(), room_.size()});
}

double BenchFrames::median_ms(std::size_t side) { return effects::median_of(ms(side), {room_.data(), room_.size()}); }

}  // namespace tedavis::platform
