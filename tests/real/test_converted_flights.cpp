// `convert` on flights that somebody recorded: what a listener on the bus then knows is what the recording says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "bus/candump/candump_log_source.hpp"
#include "bus/state/state_assembler.hpp"
#include "host_sim/commands/convert.hpp"
#include "host_sim/importers/fix_cleaner.hpp"
#include "host_sim/importers/flight_importer.hpp"
#include "host_sim/importers/resampled_flight.hpp"
#include "host_sim/input_file.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_converted_flights {
namespace {

using flight::Signal;
using test_support::CommandRun;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kFlights = test_support::real_data_dir() + "/flights/";

class ConvertedFlight : public ::testing::Test {
protected:
    CommandRun convert(const std::string& name, ConvertOptions options = {}) {
        options.flight = kFlights + name;
        options.output = place_.file("f.log");
        return test_support::run_command([&](Console& console) { return run_convert(options, console); }, true);
    }
    test_support::TemporaryFolder place_;
};

/// What the bus knows, at rising instants.
class Listener {
public:
    explicit Listener(std::string log) : text_(std::move(log)), source_({text_.data(), text_.size()}) {}

    flight::AircraftState at(base::Time time) {
        std::vector<bus::CanFrame> frames(4096);
        while (const std::size_t count = source_.read(time, {frames.data(), frames.size()})) {
            assembler_->feed({frames.data(), count});
            newest_ = frames[count - 1].time;
        }
        return assembler_->snapshot(time).state;
    }
    [[nodiscard]] base::Time newest() const { return newest_; }

private:
    std::string text_;
    bus::CandumpLogSource source_;
    std::unique_ptr<bus::StateAssembler> assembler_ = std::make_unique<bus::StateAssembler>();
    base::Time newest_;
};

double distance_m(const flight::AircraftState& state, double latitude_rad, double longitude_rad) {
    return earth::surface_distance_m(state.own_ship.position, {latitude_rad, longitude_rad, state.own_ship.position.height});
}

/// Oracle: the recording read by nothing but a JSON parser.
TEST_F(ConvertedFlight, AHelicopterIsWhereItSaidItWas) {
    const CommandRun run = convert("adsb_rega_sg.json.gz");
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.json()["derived"]["height_is_geometric"], true);
    EXPECT_EQ(run.json()["gnss_datum"], "wgs84_ellipsoid");
    EXPECT_THAT(run.json()["derived"]["heading"].get<std::string>(), HasSubstr("derived: the track"));
    EXPECT_THAT(run.json()["derived"]["roll"].get<std::string>(), HasSubstr("derived: bank"));
    EXPECT_THAT(run.notes, Not(HasSubstr("degraded")));
    Listener listener(place_.read("f.log"));
    std::vector<double> off_m, height_m;
    const nlohmann::json rows = nlohmann::json::parse(read_file_unpacked(kFlights + "adsb_rega_sg.json.gz"));
    std::int64_t last_ms = 0;
    for (const auto& row : rows) {
        if (!row.contains("latitude") || !row["latitude"].is_number() || !row["geoaltitude"].is_number()) continue;
        const std::int64_t ms = row["last_position"].get<std::int64_t>();
        if (ms == last_ms) continue;
        last_ms = ms;
        const flight::AircraftState state = listener.at({ms * 1'000'000});
        if (state.own_ship.state != base::SignalState::valid) continue;  // the first second, and after a gap
        off_m.push_back(
            distance_m(state, base::radians(row["latitude"].get<double>()), base::radians(row["longitude"].get<double>())));
        height_m.push_back(std::abs(state.own_ship.position.height.m - row["geoaltitude"].get<double>() * 0.3048));
    }
    ASSERT_GT(off_m.size(), 500u);
    std::sort(off_m.begin(), off_m.end());
    std::sort(height_m.begin(), height_m.end());
    EXPECT_LT(off_m[off_m.size() / 2], 5);
    EXPECT_LT(off_m[off_m.size() * 95 / 100], 30) << "ADS-B positions of one second jitter by that";
    EXPECT_LT(height_m[height_m.size() / 2], 5);
    EXPECT_LT(height_m[height_m.size() * 95 / 100], 25) << "heights come in steps of 25 ft";
}

TEST_F(ConvertedFlight, NothingIsSentInAGap) {
    const CommandRun run = convert("igcxc_discontinuity.igc");
    EXPECT_EQ(run.code, 0);
    EXPECT_NEAR(run.json()["derived"]["longest_gap_s"].get<double>(), 2207, 1);
    EXPECT_GT(run.json()["silent_s"].get<double>(), 2200);
    EXPECT_THAT(run.notes, HasSubstr("no HFALG record"));
    const std::string log = place_.read("f.log");
    bus::CandumpLogSource source({log.data(), log.size()});
    std::vector<bus::CanFrame> frames(4096);
    base::Time before;
    double longest_s = 0;
    while (const std::size_t count = source.read({INT64_MAX}, {frames.data(), frames.size()})) {
        for (std::size_t i = 0; i < count; ++i) {
            if (before.ns != 0) longest_s = std::max(longest_s, (frames[i].time - before).to_seconds());
            before = frames[i].time;
        }
    }
    EXPECT_NEAR(longest_s, 2207, 0.1);
}

/// Oracle: the columns of the B records, cut out by hand.
TEST_F(ConvertedFlight, AGlidersFixesLieOnTheCurve) {
    const std::string path = kFlights + "igcxc_trifai-xcontest-362.70.igc";
    const std::string text = read_file(path);
    RecordedFlight flight = choose_aircraft(import_flight_file(path), "", path);
    EXPECT_EQ(flight.fixes.size(), 32315u);
    (void)clean_fixes(flight);
    const GeoidEgm96 geoid = GeoidEgm96::installed();
    const ResampledFlight resampled(flight, {}, geoid, path);
    std::size_t compared = 0;
    for (std::size_t at = text.find("\nB"); at != std::string::npos; at = text.find("\nB", at + 1)) {
        const auto number = [&](std::size_t first, std::size_t count) { return std::stod(text.substr(at + 1 + first, count)); };
        const auto second = static_cast<std::int64_t>(number(1, 2) * 3600 + number(3, 2) * 60 + number(5, 2));
        const base::Time time{(1567123200 + second) * 1'000'000'000};  // 2019-08-30
        const auto sample = resampled.at(time);
        if (!sample || text[at + 1 + 24] != 'A') continue;
        // 38 LAD digits follow the record's own thousandths of a minute: less than two metres.
        const double latitude = number(7, 2) + number(9, 5) / 60000, longitude = number(15, 3) + number(18, 5) / 60000;
        ASSERT_NEAR(base::degrees((*sample)[Signal::latitude]), latitude, 2e-5) << text.substr(at + 1, 35);
        ASSERT_NEAR(base::degrees((*sample)[Signal::longitude]), longitude, 3e-5);
        ASSERT_NEAR((*sample)[Signal::standard_altitude], number(25, 5), 8);
        ASSERT_NEAR((*sample)[Signal::ellipsoid_height], number(30, 5), 8);
        ++compared;
    }
    EXPECT_GT(compared, 32000u);
}

TEST_F(ConvertedFlight, SeveralAircraftAreListedAndOneIsChosen) {
    test_support::expect_user_error([&] { (void)convert("adsb_switzerland_map.json.gz"); },
                                    "holds 2 aircraft; choose one with --aircraft: 4b1c22 (HBKRA), 4b088c (HBDGE)");
    EXPECT_EQ(place_.entries(), 0u);
}

TEST_F(ConvertedFlight, WithoutAGnssHeightTheUserIsToldAndAsked) {
    const std::string path = kFlights + "adsb_switzerland_map.json.gz";
    RecordedFlight flight = choose_aircraft(import_flight_file(path), "hbkra", path);
    (void)clean_fixes(flight);
    const GeoidEgm96 geoid = GeoidEgm96::installed();
    const ResampledFlight plain(flight, {}, geoid, path);
    EXPECT_FALSE(plain.derivation().height_is_geometric);
    const base::Time over_davos{1586695720'000'000'000};
    const SignalSample sample = plain.at(over_davos).value();
    EXPECT_NEAR(sample[Signal::standard_altitude], 13000 * 0.3048, 10);
    EXPECT_FALSE(sample.has(Signal::ellipsoid_height));
    EXPECT_FALSE(sample.has(Signal::baro_altitude));
    ResampleSettings settings;
    settings.qnh_pa = 102000;
    const SignalSample on_qnh = ResampledFlight(flight, settings, geoid, path).at(over_davos).value();
    EXPECT_NEAR(on_qnh[Signal::baro_altitude] - sample[Signal::standard_altitude], 51, 3) << "6.75 hPa at 7.6 m each, 4 km up";
    settings.assume_geometric = true;
    EXPECT_TRUE(ResampledFlight(flight, settings, geoid, path).derivation().height_is_geometric);
}

TEST_F(ConvertedFlight, NoiseIsRejectedAndCounted) {
    const CommandRun run = convert("adsb_noisy_landing.json.gz");
    EXPECT_EQ(run.code, 0);
    EXPECT_GT(run.json()["rejected"]["gnss_height_jumps"], 20);
    EXPECT_GT(run.json()["derived"]["velocities_not_believed"], 5);
    Listener listener(place_.read("f.log"));
    const auto begin = static_cast<std::int64_t>(run.json()["begin_s"].get<double>() * 1e9);
    double before_m = std::nan("");
    int not_valid = 0, leaps = 0;
    for (int s = 5; s < 840; ++s) {
        const flight::AircraftState state = listener.at({begin + s * std::int64_t{1'000'000'000}});
        if (state.own_ship.state != base::SignalState::valid) {
            ++not_valid;
            continue;
        }
        const double height_m = state.own_ship.position.height.m;
        leaps += std::abs(height_m - before_m) > 40 ? 1 : 0;
        before_m = height_m;
        EXPECT_LT(state[Signal::ground_speed].value_or(1e9), 150) << s;
    }
    EXPECT_LT(not_valid, 10) << "positions that contradict the speed make the own ship stale for a moment";
    EXPECT_LT(leaps, 5) << "the recording itself has 87 of more than 60 m";
}

struct OwnShipFindings {
    int instants = 0, not_valid = 0;
    double farthest_m = 0;  ///< from the position that the bus stated last, less what is flown in a tenth of a second
};

OwnShipFindings listen(const std::string& log, base::Time begin, int from_s, int to_s) {
    Listener listener(log);
    OwnShipFindings found;
    for (int tenth = from_s * 10; tenth <= to_s * 10; ++tenth) {
        const flight::AircraftState state = listener.at(begin + base::Duration::milliseconds(100 * tenth));
        ++found.instants;
        if (state.own_ship.state != base::SignalState::valid) ++found.not_valid;
        const double off_m = distance_m(state, state[Signal::latitude].value_or(0), state[Signal::longitude].value_or(0));
        found.farthest_m = std::max(found.farthest_m, off_m - 0.1 * state[Signal::ground_speed].value_or(0));
    }
    return found;
}

/// The log without the lines that `leave_out` chooses by their time and identifier.
template <class LeaveOut>
std::string thinned(const std::string& log, LeaveOut leave_out) {
    std::string kept;
    kept.reserve(log.size());
    for (std::size_t line = 0, next = 0; line < log.size(); line = next) {
        next = std::min(log.find('\n', line), log.size() - 1) + 1;
        const std::string text = log.substr(line, next - line);
        if (!leave_out(std::stod(text.substr(1)), text.substr(text.find('#') - 3, 3))) kept += text;
    }
    return kept;
}

/// A position is sent each tenth of a second: it is never stale, wherever the flight bends.
TEST_F(ConvertedFlight, OverTheMountainsThePositionIsNeverStale) {
    for (const char* aircraft : {"4b1c22", "4b088c"}) {
        ConvertOptions options;
        options.aircraft = aircraft;
        options.assume_geometric = true;
        const CommandRun run = convert("adsb_switzerland_map.json.gz", options);
        ASSERT_EQ(run.code, 0);
        const double begin_s = run.json()["begin_s"].get<double>();
        const base::Time begin{static_cast<std::int64_t>(begin_s * 1e9)};
        const int length_s = static_cast<int>(run.json()["end_s"].get<double>() - begin_s);
        const std::string log = place_.read("f.log");
        const OwnShipFindings all = listen(log, begin, 1, length_s);
        EXPECT_GT(all.instants, 180000);
        EXPECT_EQ(all.not_valid, 0) << aircraft << " of " << all.instants;
        EXPECT_LT(all.farthest_m, 15) << aircraft;
        // Nor where the bus states no velocity.
        const std::string still =
            thinned(log, [](double, const std::string& identifier) { return identifier == "40F" || identifier == "410"; });
        EXPECT_EQ(listen(still, begin, 1, length_s).not_valid, 0) << aircraft;
        const std::string silent =
            thinned(log.substr(0, log.rfind('\n', log.size() / 8) + 1), [&](double time_s, const std::string& identifier) {
                return std::abs(time_s - begin_s - 1000.25) < 0.25 && (identifier == "40C" || identifier == "40D");
            });
        EXPECT_NEAR(listen(silent, begin, 990, 1010).not_valid, 3, 1) << "control: half a second without positions";
    }
}

TEST_F(ConvertedFlight, ARecordingWithoutPositionsIsRefused) {
    test_support::expect_user_error([&] { (void)convert("adsb_fuelflow_a320.json.gz"); },
                                    "none of its 11808 rows has a latitude and a longitude");
}

}  // namespace
}  // namespace tedavis::host_sim::test_converted_flights
