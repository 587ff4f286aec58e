/// A short flight over made terrain, as the files that replay reads: a log, a database, a switch log.
#pragma once

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "host_sim/flight_log/flight_log_writer.hpp"
#include "host_sim/options/replay_options.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/terrain/synthetic_raster.hpp"
#include "tests/support/terrain/terrain_image.hpp"

namespace tedavis::test_support {

/// Eight seconds of a climbing left turn over rough terrain near 47 N 9.7 E.
class FlownCircle : public host_sim::FlightSource {
public:
    static constexpr std::int64_t kBegin_s = 1'700'000'000;
    base::Time begin() const override { return base::Time{kBegin_s * 1'000'000'000}; }
    base::Time end() const override { return begin() + base::Duration::seconds(8); }
    std::optional<host_sim::SignalSample> at(base::Time time) const override {
        using flight::Signal;
        const double s = (time - FlownCircle::begin()).to_seconds(), turned = -0.05 * s, speed = 60;
        host_sim::SignalSample sample;
        sample[Signal::latitude] = base::radians(47.04) + speed / 0.05 * std::sin(-turned) / 6.37e6;
        sample[Signal::longitude] = base::radians(9.68) - speed / 0.05 * (1 - std::cos(turned)) / 4.34e6;
        sample[Signal::ellipsoid_height] = 2400 + 4 * s;
        sample[Signal::ground_speed] = speed;
        sample[Signal::true_track] = sample[Signal::true_heading] = std::fmod(turned + 2 * base::kPi, 2 * base::kPi);
        sample[Signal::vertical_speed] = 4;
        sample[Signal::pitch] = base::radians(-8);
        sample[Signal::roll] = base::radians(-15);
        sample[Signal::indicated_airspeed] = speed;
        sample[Signal::baro_altitude] = 2350 + 4 * s;
        sample[Signal::baro_setting] = 101325;
        return sample;
    }
};

/// The same, so many seconds later, by its clock and its bus.
class FlownLater final : public FlownCircle {
public:
    explicit FlownLater(std::int64_t seconds) : by_(base::Duration::seconds(seconds)) {}
    base::Time begin() const override { return FlownCircle::begin() + by_; }
    std::optional<host_sim::SignalSample> at(base::Time time) const override { return FlownCircle::at(time - by_); }

private:
    base::Duration by_;
};

/// The log of a flight.
inline std::string log_of(const host_sim::FlightSource& flight) {
    std::ostringstream log;
    host_sim::write_flight_log(flight, {}, log, [](double) { return true; });
    return log.str();
}

/// The same, five degrees farther south.
class FlownAway final : public FlownCircle {
public:
    std::optional<host_sim::SignalSample> at(base::Time time) const override {
        auto sample = FlownCircle::at(time);
        if (sample) (*sample)[flight::Signal::latitude] -= base::radians(5);
        return sample;
    }
};

/// The files in a folder of their own, and options that replay them in small.
struct FlownFiles {
    TemporaryFolder folder;
    std::string log = folder.file("flight.log");
    std::string terrain = folder.file("terrain.tdb");

    explicit FlownFiles(const host_sim::FlightSource& flight = FlownCircle()) {
        std::ofstream stream(log, std::ios::binary);
        host_sim::write_flight_log(flight, {}, stream, [](double) { return true; });
        const host_sim::Raster raster = make_rough_raster(193, 193);
        host_sim::build_terrain(posts_of(raster), terrain, {});
    }

    /// 320 x 240, frames at 0, 0.5 .. of the flight, hashes only.
    [[nodiscard]] host_sim::ReplayOptions options(const std::string& output) const {
        host_sim::ReplayOptions o;
        o.log = log;
        o.output = folder.file(output);
        o.picture.terrain = terrain;
        o.picture.size = host_sim::PictureSize{320, 240};
        o.step_s = 0.5;
        o.frames = host_sim::FrameOutput::hash;
        return o;
    }
};

}  // namespace tedavis::test_support
