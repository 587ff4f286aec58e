/// A flight over a database on disk as a small device shows it: slow legs, fast turns, and jumps of many kilometres between them.
#pragma once

#include <ctime>
#include <random>
#include <string>
#include <vector>

#include "host_sim/geoid_egm96.hpp"
#include "host_sim/heap_trap/heap_trap.hpp"
#include "platform/files/file_byte_source.hpp"
#include "tests/support/fractal_posts.hpp"
#include "tests/support/free_view.hpp"
#include "tests/support/terrain_picture.hpp"

namespace tedavis::test_support {

struct FlownBudget {
    int over_triangles = 0;  ///< frames that drew more than the device's budget
    int frames = 0, over_budget = 0, changed_bytes = 0, failing = 0;
    int without_terrain = 0;   ///< frames that neither show terrain nor say that it is taken away
    int taken_away = 0;        ///< because it would be too coarse: two frames after every jump wait for what is read
    int taken_away_later = 0;  ///< of them, beyond these two on legs without a turn
    int holes = 0;             ///< background pixels where there is nothing but ground
    std::uint64_t heap_calls = 0, cpu_bytes = 0, gpu_bytes = 0;
    double mean_triangles = 0;
    std::vector<double> milliseconds;  ///< of processor time, planned, drawn and finished; sorted

    [[nodiscard]] double quantile_ms(double share) const {
        return milliseconds[static_cast<std::size_t>(share * static_cast<double>(milliseconds.size() - 1))];
    }
};

class BudgetFlight {
public:
    static constexpr int kFramesOfALeg = 50, kArrivalFrames = 2;

    /// Over the north-western `region` posts a side of FractalPosts' terrain, of which the database must hold more.
    BudgetFlight(const std::string& database, const std::string& device, std::uint32_t region, int legs)
        : file_(std::move(platform::open_file(database.c_str()).value())),
          headless_("egl", device, kWidth, kHeight, &file_, garish_design()),
          triangles_(shipped_device(device).triangle_budget),
          region_(region),
          legs_(legs) {}

    FlownBudget fly() {
        FlownBudget flown;
        flown.milliseconds.reserve(static_cast<std::size_t>(legs_ * kFramesOfALeg));
        std::vector<Stop> route;
        for (int n = 0; n < legs_ * kFramesOfALeg; ++n) route.push_back(stop(n));
        host_sim::HeapTrap trap;
        for (const Stop& stop : route) show(stop, flown);
        trap.close();
        flown.heap_calls = trap.counts().ours;
        flown.mean_triangles /= flown.frames;
        std::sort(flown.milliseconds.begin(), flown.milliseconds.end());
        return flown;
    }

private:
    static constexpr std::uint32_t kWidth = 640, kHeight = 480;
    static constexpr double kMargin_posts = 260;

    struct Stop {
        terrain::View view;
        earth::Geodetic ship;
        int first_ground_row = 0;  ///< from which on no sky can be in the picture
    };

    [[nodiscard]] Stop stop(int n) const {
        const int leg = n / kFramesOfALeg, k = n % kFramesOfALeg;
        const double span = region_ - 2 * kMargin_posts - 2.0 * kFramesOfALeg;
        const auto part = [](double x) { return x - std::floor(x); };
        const double heading_deg = 77.0 * leg + (leg % 2 == 1 ? 4.0 * k : 0), along = 1.5 * k * (leg % 2 == 0 ? 1 : 0.3);
        const double i = kMargin_posts + span * part(leg * 0.6180339) + kFramesOfALeg +
                         along * std::sin(base::radians(77.0 * leg)),
                     j = kMargin_posts + span * part(leg * 0.4142135) + kFramesOfALeg -
                         along * std::cos(base::radians(77.0 * leg));
        const bool level = leg % 3 == 2;
        return at(i, j, level ? 900 : 1800, heading_deg, level ? -4 : -60, level ? int(kHeight) * 7 / 8 : 0);
    }
    [[nodiscard]] Stop at(double i, double j, double above_m, double heading_deg, double pitch_deg, int first_ground_row) const {
        Stop stop;
        stop.first_ground_row = first_ground_row;
        float ground_m = 0;
        ground_.read(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), 1, 1, {&ground_m, 1});
        const double latitude = base::radians(host_sim::kFractalNorth_deg - j * host_sim::kFractalStep_deg),
                     longitude = base::radians(host_sim::kFractalWest_deg + i * host_sim::kFractalStep_deg);
        stop.ship = {latitude, longitude, {double{ground_m} + geoid_.undulation(latitude, longitude).m + above_m}};
        const glm::dmat3 body = earth::body_axes(latitude, longitude, base::radians(heading_deg), base::radians(pitch_deg), 0);
        stop.view = free_view(earth::to_ecef(stop.ship), body, kWidth, kHeight, 15);
        return stop;
    }

    void show(const Stop& stop, FlownBudget& flown) {
        display::Display& display = headless_.display();
        const double begin_ms = processor_ms();
        display.set_free_view(stop.view);
        display.update(aircraft_at(stop.ship), {}, host_sim::kPosedTime);
        display.draw(headless_.surface());
        display.gl()->Finish();
        flown.milliseconds.push_back(processor_ms() - begin_ms);
        EXPECT_TRUE(gl::read_pixels(display.gl(), kWidth, kHeight, {pixels_.data(), pixels_.size()}));
        note(display.record(), flown);
        if (display.record().terrain.triangles == 0) return;
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
        flown.over_triangles += record.terrain.triangles > triangles_ ? 1 : 0;
        flown.failing += has_flag(record, "terrain.failing") ? 1 : 0;
        flown.mean_triangles += record.terrain.triangles;
    }
    [[nodiscard]] static bool has_flag(const display::FrameRecord& record, std::string_view name) {
        return std::any_of(record.flags.begin(), record.flags.end(),
                           [&](const display::Name& flag) { return flag.view() == name; });
    }
    [[nodiscard]] static double processor_ms() {
        timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
    }

    platform::FileByteSource file_;
    HeadlessDisplay headless_;
    std::uint32_t triangles_, region_;
    int legs_;
    host_sim::FractalTerrain ground_{1};
    host_sim::GeoidEgm96 geoid_ = host_sim::GeoidEgm96::installed();
    std::vector<std::uint8_t> pixels_ = std::vector<std::uint8_t>(std::size_t{kWidth} * kHeight * 4);
};

}  // namespace tedavis::test_support
