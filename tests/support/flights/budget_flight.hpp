/// A flight over a database on disk as a small device shows it: slow legs, fast turns, and jumps of many kilometres between them.
#pragma once

#include <ctime>
#include <random>
#include <string>
#include <vector>

#include "host_sim/heap_trap/heap_trap.hpp"
#include "platform/files/file_byte_source.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/flights/flown_ground.hpp"
#include "tests/support/terrain/terrain_picture.hpp"

namespace tedavis::test_support {

struct FlownBudget {
    int over_triangles = 0;  ///< frames that drew more than the device's budget
    int frames = 0, over_budget = 0, changed_bytes = 0, failing = 0;
    int without_terrain = 0;   ///< frames that neither show terrain nor say that it is taken away
    int taken_away = 0;        ///< because it would be too coarse: two frames after every jump wait for what is read
    int taken_away_later = 0;  ///< of them, beyond these two on legs without a turn
    int raised = 0;            ///< frames that say that their error is above tau
    int unstated = 0;          ///< frames with terrain that do not state their error, or that it is above tau and why
    int proved_whole = 0;      ///< pictures of ground with data alone, searched for holes
    int holes = 0;             ///< background pixels in them where there is nothing but ground
    std::uint64_t heap_calls = 0, cpu_bytes = 0, gpu_bytes = 0;
    double mean_triangles = 0;
    std::vector<double> milliseconds;  ///< of processor time, planned, drawn and finished; sorted

    [[nodiscard]] double quantile_ms(double share) const {
        return milliseconds[static_cast<std::size_t>(share * static_cast<double>(milliseconds.size() - 1))];
    }
};

/// What holds on every ground; where it is too coarse is told apart by the legs.
inline void expect_within_device(const FlownBudget& flown, int legs) {
    EXPECT_EQ(flown.changed_bytes, 0) << "of " << flown.cpu_bytes << " and " << flown.gpu_bytes;
    EXPECT_EQ(flown.over_budget, 0);
    EXPECT_EQ(flown.over_triangles, 0);
    EXPECT_LE(flown.cpu_bytes + flown.gpu_bytes, 64u << 20);
    EXPECT_EQ(flown.heap_calls, 0u);
    EXPECT_EQ(flown.without_terrain, 0);
    EXPECT_EQ(flown.taken_away_later, 0);
    EXPECT_LE(flown.taken_away, 4 * legs) << "two after every jump, and some in fast turns";
    EXPECT_EQ(flown.failing, 0);
    EXPECT_EQ(flown.unstated, 0);
    EXPECT_EQ(flown.holes, 0);
}

class BudgetFlight {
public:
    static constexpr int kFramesOfALeg = 50, kArrivalFrames = 2;

    struct Stop {
        terrain::View view;
        earth::Geodetic ship;
        int first_ground_row = 0;  ///< from which on no sky can be in the picture
    };

    BudgetFlight(const std::string& database, const std::string& device, const FlownGround& ground, int legs)
        : file_(std::move(platform::open_file(database.c_str()).value())),
          headless_("egl", device, kWidth, kHeight, &file_, garish_design()),
          triangles_(shipped_device(device).triangle_budget),
          ground_(ground) {
        for (int n = 0; n < legs * kFramesOfALeg; ++n) route_.push_back(stop(n));
    }
    [[nodiscard]] HeadlessDisplay& headless() { return headless_; }
    [[nodiscard]] const std::vector<Stop>& route() const { return route_; }

    FlownBudget fly() {
        FlownBudget flown;
        flown.milliseconds.reserve(route_.size());
        host_sim::HeapTrap trap;
        for (const Stop& stop : route_) show(stop, flown);
        trap.close();
        flown.heap_calls = trap.counts().ours;
        flown.mean_triangles /= flown.frames;
        std::sort(flown.milliseconds.begin(), flown.milliseconds.end());
        return flown;
    }
    /// Frames from the jump to a leg's beginning until the picture stays as it is; the most of all legs.
    [[nodiscard]] int slowest_refinement() {
        constexpr int kWatched = 8;
        int slowest = 0;
        for (std::size_t n = 0; n < route_.size(); n += kFramesOfALeg) {
            std::vector<std::vector<std::uint8_t>> pictures;
            headless_.display().planner().set_free_view(route_[n].view);
            const flight::AircraftState state = aircraft_at(route_[n].ship);
            for (int frame = 0; frame < kWatched; ++frame) {
                headless_.display().plan({state, {}, host_sim::kPosedTime});
                pictures.push_back(drawn_pixels(headless_));
            }
            const std::vector<std::uint8_t> last = settled_pixels(headless_, state, host_sim::kPosedTime);
            int frame = kWatched;
            while (frame > 0 && pictures[static_cast<std::size_t>(frame - 1)] == last) --frame;
            slowest = std::max(slowest, frame);
        }
        return slowest;
    }
    [[nodiscard]] static bool has_flag(const display::FrameRecord& record, std::string_view name) {
        return std::any_of(record.flags.begin(), record.flags.end(),
                           [&](const display::Name& flag) { return flag.view() == name; });
    }

private:
    static constexpr std::uint32_t kWidth = 640, kHeight = 480;
    static constexpr double kMargin_s = 260;

    [[nodiscard]] Stop stop(int n) const {
        const int leg = n / kFramesOfALeg, k = n % kFramesOfALeg;
        const double span_s = ground_.side_s - 2 * kMargin_s - 2.0 * kFramesOfALeg;
        const auto part = [](double x) { return x - std::floor(x); };
        const double heading_deg = 77.0 * leg + (leg % 2 == 1 ? 4.0 * k : 0), along_s = 1.5 * k * (leg % 2 == 0 ? 1 : 0.3);
        const double east_s = kMargin_s + span_s * part(leg * 0.6180339) + kFramesOfALeg +
                              along_s * std::sin(base::radians(77.0 * leg)),
                     south_s = kMargin_s + span_s * part(leg * 0.4142135) + kFramesOfALeg -
                               along_s * std::cos(base::radians(77.0 * leg));
        const bool level = leg % 3 == 2;
        Stop stop = at(ground_.north_deg - south_s / 3600, ground_.west_deg + east_s / 3600,
                       level ? ground_.looking_ahead_m : ground_.looking_down_m, heading_deg, level ? -4 : -60);
        if (level) stop.first_ground_row = int{kHeight} * 7 / 8;
        return stop;
    }
    [[nodiscard]] Stop at(double latitude_deg, double longitude_deg, double above_m, double heading_deg, double pitch_deg) const {
        const double latitude = base::radians(latitude_deg), longitude = base::radians(longitude_deg);
        Stop stop;
        stop.ship = {latitude, longitude, {ground_.ellipsoid_m(latitude_deg, longitude_deg) + above_m}};
        const glm::dmat3 body = earth::body_axes(latitude, longitude, base::radians(heading_deg), base::radians(pitch_deg), 0);
        stop.view = free_view(earth::to_ecef(stop.ship), body, kWidth, kHeight, 15);
        return stop;
    }

    void show(const Stop& stop, FlownBudget& flown) {
        display::Display& display = headless_.display();
        const double begin_ms = processor_ms();
        display.planner().set_free_view(stop.view);
        display.plan({aircraft_at(stop.ship), {}, host_sim::kPosedTime});
        display.draw(headless_.surface());
        display.gl()->Finish();
        flown.milliseconds.push_back(processor_ms() - begin_ms);
        EXPECT_TRUE(gl::read_pixels(display.gl(), kWidth, kHeight, {pixels_.data(), pixels_.size()}));
        note(display.record(), flown);
        if (display.record().terrain.triangles == 0 || has_flag(display.record(), "terrain.void")) return;
        ++flown.proved_whole;
        const std::size_t ground = std::size_t{kWidth} * (kHeight - static_cast<std::size_t>(stop.first_ground_row));
        for (std::size_t n = 0; n < ground; ++n) flown.holes += pixels_[4 * n] == 0 ? 1 : 0;  // bottom row first
    }
    void note(const display::FrameRecord& record, FlownBudget& flown) const {
        if (flown.frames++ == 0) {
            flown.cpu_bytes = record.bytes.cpu;
            flown.gpu_bytes = record.bytes.gpu;
        }
        flown.changed_bytes += record.bytes.cpu != flown.cpu_bytes || record.bytes.gpu != flown.gpu_bytes ? 1 : 0;
        flown.over_budget += record.bytes.cpu > record.bytes.cpu_budget || record.bytes.gpu > record.bytes.gpu_budget ? 1 : 0;
        const bool taken_away = has_flag(record, "terrain.too_coarse");
        const int frame = flown.frames - 1, leg = frame / kFramesOfALeg;
        flown.without_terrain += record.terrain.triangles == 0 && !taken_away ? 1 : 0;
        flown.taken_away += taken_away ? 1 : 0;
        flown.taken_away_later += taken_away && leg % 2 == 0 && frame % kFramesOfALeg >= kArrivalFrames ? 1 : 0;
        flown.raised += has_flag(record, "terrain.tau_raised") ? 1 : 0;
        flown.unstated += record.terrain.triangles != 0 && !states_error(record) ? 1 : 0;
        flown.over_triangles += record.terrain.triangles > triangles_ ? 1 : 0;
        flown.failing += has_flag(record, "terrain.failing") ? 1 : 0;
        flown.mean_triangles += record.terrain.triangles;
    }
    [[nodiscard]] static bool states_error(const display::FrameRecord& record) {
        const display::TerrainRecord& terrain = record.terrain;
        if (!(std::isfinite(terrain.worst_error_px) && terrain.worst_error_px <= terrain.tau_reached_px)) return false;
        const bool raised = terrain.tau_reached_px > terrain.tau_px;
        return raised == has_flag(record, "terrain.tau_raised") && raised == (terrain.limit.view() != "met");
    }
    [[nodiscard]] static double processor_ms() {
        timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
    }

    platform::FileByteSource file_;
    HeadlessDisplay headless_;
    std::uint32_t triangles_;
    FlownGround ground_;
    std::vector<Stop> route_;
    std::vector<std::uint8_t> pixels_ = std::vector<std::uint8_t>(std::size_t{kWidth} * kHeight * 4);
};

}  // namespace tedavis::test_support
