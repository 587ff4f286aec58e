// The phase that motion tells of recorded flights, against labels that were given by hand (flight_phases.csv).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <vector>

#include "host_sim/importers/fix_cleaner.hpp"
#include "host_sim/importers/flight_importer.hpp"
#include "host_sim/importers/resampled_flight.hpp"
#include "host_sim/input_file.hpp"
#include "render_core/flight/motion_phase_detector.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::host_sim::test_flight_phases {
namespace {

using flight::AircraftClass;
using flight::Scenario;

constexpr double kStep_s = 0.5;
constexpr double kFloorOfOneFlight = 0.85;  // the helicopter's flight lasts 20 minutes, and a dwell of 15 s is a hundredth of it

struct Label {
    double from_s = 0, to_s = 0;
    std::vector<std::string> scenarios;
};
struct LabelledFlight {
    std::string file, aircraft;
    AircraftClass type = AircraftClass::unstated;
    std::vector<Label> labels;
};

AircraftClass class_named(const std::string& name) {
    const auto found = std::find(flight::kAircraftClassNames.begin(), flight::kAircraftClassNames.end(), name);
    EXPECT_NE(found, flight::kAircraftClassNames.end()) << name;
    return static_cast<AircraftClass>(found - flight::kAircraftClassNames.begin());
}

std::vector<LabelledFlight> labelled_flights() {
    std::istringstream lines(read_file(test_support::source_dir() + "/tests/real/flight_phases.csv"));
    std::vector<LabelledFlight> flights;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream cells(line);
        std::string file, aircraft, type, from, to, scenarios;
        for (std::string* cell : {&file, &aircraft, &type, &from, &to, &scenarios}) std::getline(cells, *cell, ',');
        if (flights.empty() || flights.back().file != file || flights.back().aircraft != aircraft)
            flights.push_back({file, aircraft, class_named(type), {}});
        std::istringstream words(scenarios);
        Label label{std::stod(from), std::stod(to), {}};
        for (std::string word; words >> word;) label.scenarios.push_back(word);
        flights.back().labels.push_back(label);
    }
    return flights;
}

flight::AircraftState state_of(const SignalSample& sample, base::Time now) {
    flight::AircraftState state;
    for (const flight::Signal signal : {flight::Signal::ground_speed, flight::Signal::vertical_speed,
                                        flight::Signal::standard_altitude, flight::Signal::longitudinal_acceleration})
        if (std::isfinite(sample[signal])) state[signal] = {sample[signal], now};
    const double height_m = sample[flight::Signal::ellipsoid_height];
    if (std::isfinite(height_m)) {
        state.own_ship.position.height.m = height_m;
        state.own_ship.state = base::SignalState::valid;
        state.own_ship.velocity_up_mps = std::nan("");  // speeds are those that the recording states
    }
    return state;
}

/// Seconds by what was labelled and what was found; of a label with two scenarios the one that was found counts, else the first.
using Confusion = std::map<std::pair<std::string, std::string>, double>;

void judge(const Label& label, const std::string& found, Confusion& confusion) {
    const bool is_right = std::find(label.scenarios.begin(), label.scenarios.end(), found) != label.scenarios.end();
    confusion[{is_right ? found : label.scenarios[0], found}] += kStep_s;
}

Confusion fly(const LabelledFlight& labelled, AircraftClass type) {
    const std::string path = test_support::real_data_dir() + "/flights/" + labelled.file;
    RecordedFlight recorded = choose_aircraft(import_flight_file(path), labelled.aircraft, path);
    (void)clean_fixes(recorded);
    const ResampledFlight resampled(recorded, {}, GeoidEgm96::installed(), path);
    const flight::MotionPhaseSettings settings = flight::motion_phase_settings(type);
    flight::MotionPhaseState state;
    Confusion confusion;
    for (double s = 0; s < (resampled.end() - resampled.begin()).to_seconds(); s += kStep_s) {
        const base::Time now = resampled.begin() + base::Duration::from_seconds(s);
        const std::optional<SignalSample> sample = resampled.at(now);
        const flight::PhaseStatement found =
            flight::detect_motion_phase(sample ? state_of(*sample, now) : flight::AircraftState(), now, settings, state);
        if (!sample) continue;
        const std::string name = found.stated ? flight::scenario_name(found.phase) : "unknown";
        for (const Label& label : labelled.labels)
            if (s >= label.from_s && s < label.to_s) judge(label, name, confusion);
    }
    return confusion;
}

double share_right(const Confusion& confusion) {
    double right_s = 0, all_s = 0;
    for (const auto& [pair, seconds] : confusion) {
        all_s += seconds;
        if (pair.first == pair.second) right_s += seconds;
    }
    return right_s / all_s;
}

/// The rows of the table of configs/aircraft/README.md.
std::string table_of(const Confusion& confusion) {
    constexpr const char* kLabelled[] = {"ground", "takeoff", "cruise", "approach"};
    constexpr const char* kFound[] = {"ground", "takeoff", "cruise", "approach", "go_around", "unknown"};
    std::ostringstream table;
    for (const char* labelled : kLabelled) {
        table << "| " << labelled;
        for (const char* found : kFound) {
            const auto entry = confusion.find({labelled, found});
            table << " | " << std::lround(entry == confusion.end() ? 0 : entry->second);
        }
        table << " |\n";
    }
    return table.str();
}

std::string text_of(const Confusion& confusion) {
    std::ostringstream text;
    for (const auto& [pair, seconds] : confusion)
        text << "  " << pair.first << " -> " << pair.second << ": " << seconds << " s\n";
    return text.str();
}

TEST(FlightPhases, OfLabelledFlightsMotionIsRightForNineteenTwentiethsOfTheTime) {
    Confusion whole;
    for (const LabelledFlight& labelled : labelled_flights()) {
        const Confusion confusion = fly(labelled, labelled.type);
        EXPECT_GE(share_right(confusion), kFloorOfOneFlight) << labelled.file << " " << labelled.aircraft << "\n"
                                                             << text_of(confusion);
        for (const auto& [pair, seconds] : confusion) whole[pair] += seconds;
    }
    EXPECT_GE(share_right(whole), 0.95) << text_of(whole);
}

TEST(FlightPhases, TheTableOfTheReadmeIsWhatIsMeasured) {
    Confusion whole;
    for (const LabelledFlight& labelled : labelled_flights())
        for (const auto& [pair, seconds] : fly(labelled, labelled.type)) whole[pair] += seconds;
    const std::string readme = read_file(test_support::source_dir() + "/configs/aircraft/README.md");
    EXPECT_NE(readme.find(table_of(whole)), std::string::npos) << "write it anew:\n" << table_of(whole);
    whole[{"cruise", "unknown"}] += 1;
    EXPECT_EQ(readme.find(table_of(whole)), std::string::npos) << "control";
}

TEST(FlightPhases, AGliderJudgedAsAPoweredAircraftIsWrong) {
    for (const LabelledFlight& labelled : labelled_flights()) {
        if (labelled.type != AircraftClass::glider) continue;
        EXPECT_LT(share_right(fly(labelled, AircraftClass::light)), 0.8) << labelled.file << ": control";
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_phases
