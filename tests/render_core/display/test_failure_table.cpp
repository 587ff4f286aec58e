// The failure policy against the table in the module's README, cell by cell, in 3D and on the map.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/files/device_files.hpp"
#include "tests/support/flights/policy_states.hpp"

namespace tedavis::display::test_failure_table {
namespace {

using base::SignalState;
using flight::AircraftState;
using flight::Signal;
using test_support::decide_on;
using test_support::everything_valid;
using test_support::has_flag;
using test_support::kBadStates;
using test_support::map_conditions;
using test_support::put_signal;

constexpr policy::Element kNone = policy::Element::count_;

/// One row of the table in the module's README, which is written independently of the policy's own: what is left on the
/// display for missing, stale, lost and invalid.
struct Row {
    Signal signal = Signal::count_;
    policy::Element element = kNone;
    std::array<std::string, 4> alone;          ///< all other signals valid
    std::array<std::string, 4> without_peers;  ///< no other source of the same information received
};

constexpr const char* kElementNames[] = {"attitude",
                                         "heading",
                                         "airspeed",
                                         "altitude",
                                         "vertical_speed",
                                         "baro_setting",
                                         "ground_height",
                                         "flight_path",
                                         "position",
                                         "map_up",
                                         "wind",
                                         "outside_temperature",
                                         "slip",
                                         "turn_rate",
                                         "flaps",
                                         "navigation_source",
                                         "course",
                                         "lateral_deviation",
                                         "vertical_deviation",
                                         "waypoint_bearing",
                                         "flight_path_reference",
                                         "flight_director",
                                         "selected_altitude",
                                         "selected_heading",
                                         "selected_airspeed",
                                         "selected_vertical_speed",
                                         "airspeed_trend",
                                         "radio_minimum",
                                         "baro_minimum"};
static_assert(sizeof kElementNames / sizeof kElementNames[0] == policy::kElementCount);

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream text(line.substr(1));
    for (std::string cell; std::getline(text, cell, '|');) {
        cell.erase(0, cell.find_first_not_of(' '));
        cells.push_back(cell.substr(0, cell.find_last_not_of(' ') + 1));
    }
    return cells;
}

/// The rows whose signals' names have a prefix: "map: " for those that change on the map.
std::vector<Row> read_table(const std::string& prefix) {
    std::vector<Row> rows;
    std::istringstream document(test_support::source_file("render_core/display/README.md"));
    for (std::string line; std::getline(document, line);) {
        const std::vector<std::string> cells = line.empty() || line[0] != '|' ? std::vector<std::string>() : cells_of(line);
        if (cells.size() != 10) continue;
        Row row;
        for (std::size_t n = 0; n < flight::kSignalCount; ++n)
            if (cells[0] == prefix + to_string(static_cast<Signal>(n))) row.signal = static_cast<Signal>(n);
        if (row.signal == Signal::count_) continue;  // the table's head
        const auto element = std::find(std::begin(kElementNames), std::end(kElementNames), cells[1]);
        if (element != std::end(kElementNames)) row.element = static_cast<policy::Element>(element - std::begin(kElementNames));
        EXPECT_EQ(row.element == kNone, cells[1].empty()) << "no such element: " << cells[1];
        for (std::size_t n = 0; n < 4; ++n) {
            row.alone[n] = cells[2 + n];
            row.without_peers[n] = cells[6 + n];
        }
        rows.push_back(row);
    }
    return rows;
}

const std::vector<Row>& table() {
    static const std::vector<Row> rows = read_table("");
    return rows;
}

/// The whole table as it is on the map.
const std::vector<Row>& map_table() {
    static const std::vector<Row> rows = [] {
        std::vector<Row> all = table();
        for (const Row& changed : read_table("map: "))
            for (Row& row : all)
                if (row.signal == changed.signal) row = changed;
        return all;
    }();
    return rows;
}

/// What else states the same information on the display.
std::vector<Signal> peers_of(Signal signal) {
    const std::vector<std::vector<Signal>> families = {
        {Signal::true_heading, Signal::magnetic_heading, Signal::magnetic_variation, Signal::true_track},
        {Signal::indicated_airspeed, Signal::calibrated_airspeed, Signal::true_airspeed, Signal::ground_speed},
        {Signal::radio_height, Signal::height_above_terrain},
        {Signal::ellipsoid_height, Signal::true_altitude},
        {Signal::flaps_position, Signal::flaps_lever},
    };
    std::vector<Signal> peers;
    if (signal == Signal::baro_altitude) return {Signal::true_altitude, Signal::ellipsoid_height, Signal::standard_altitude};
    if (signal == Signal::standard_altitude) return {Signal::true_altitude, Signal::ellipsoid_height, Signal::baro_altitude};
    for (const auto& family : families)
        if (std::find(family.begin(), family.end(), signal) != family.end())
            std::copy_if(family.begin(), family.end(), std::back_inserter(peers), [&](Signal s) { return s != signal; });
    return peers;
}

std::string picture(const policy::DisplayDecisions& decisions, const Row& row, SignalState state) {
    std::string text;
    if (decisions.show_terrain) text += 'T';
    if (decisions.show_warning_colors) text += 'W';
    if (decisions.terrain_degraded) text += 'D';
    if (row.element != kNone) text += "nsfx-"[static_cast<int>(decisions[row.element].show)];
    if (has_flag(decisions, std::string(to_string(row.signal)) + "." + to_string(state))) text += '!';
    return text;
}

TEST(FailurePolicy, TheTableHasARowForEverySignal) {
    for (std::size_t i = 0; i < flight::kSignalCount; ++i) {
        const auto rows =
            std::count_if(table().begin(), table().end(), [&](const Row& r) { return r.signal == static_cast<Signal>(i); });
        EXPECT_EQ(rows, 1) << to_string(static_cast<Signal>(i));
        EXPECT_EQ(policy::signal_rule(static_cast<Signal>(i)).signal, static_cast<Signal>(i));
        EXPECT_EQ(policy::consequences(policy::signal_rule(static_cast<Signal>(i)), SignalState::valid), policy::kNoConsequence);
    }
}

TEST(FailurePolicy, EveryCellWithAllOtherSignalsValid) {
    for (const Row& row : table())
        for (int i = 0; i < 4; ++i) {
            AircraftState state = everything_valid();
            put_signal(state, row.signal, kBadStates[i]);
            EXPECT_EQ(picture(decide_on(state), row, kBadStates[i]), row.alone[i])
                << to_string(row.signal) << "." << to_string(kBadStates[i]);
        }
}

TEST(FailurePolicy, EveryCellWithoutAnotherSourceOfTheInformation) {
    for (const Row& row : table())
        for (int i = 0; i < 4; ++i) {
            AircraftState state = everything_valid();
            for (Signal peer : peers_of(row.signal)) put_signal(state, peer, SignalState::missing);
            put_signal(state, row.signal, kBadStates[i]);
            const policy::DisplayDecisions decisions = decide_on(state);
            EXPECT_EQ(picture(decisions, row, kBadStates[i]), row.without_peers[i])
                << to_string(row.signal) << "." << to_string(kBadStates[i]);
            const bool attitude_lost = decisions[policy::Element::attitude].show == policy::ElementShow::failed;
            EXPECT_EQ(decisions.plain_horizon, !decisions.show_terrain && !attitude_lost);
        }
}

TEST(FailurePolicy, EveryCellOnTheMap) {
    EXPECT_EQ(read_table("map: ").size(), 6u);
    for (const Row& row : map_table())
        for (int i = 0; i < 4; ++i) {
            AircraftState state = everything_valid();
            put_signal(state, row.signal, kBadStates[i]);
            EXPECT_EQ(picture(decide_on(state, map_conditions()), row, kBadStates[i]), row.alone[i])
                << to_string(row.signal) << "." << to_string(kBadStates[i]);
            for (Signal peer : peers_of(row.signal)) put_signal(state, peer, SignalState::missing);
            const policy::DisplayDecisions decisions = decide_on(state, map_conditions());
            EXPECT_EQ(picture(decisions, row, kBadStates[i]), row.without_peers[i])
                << "alone " << to_string(row.signal) << "." << to_string(kBadStates[i]);
            EXPECT_FALSE(decisions.plain_horizon);
        }
}

}  // namespace
}  // namespace tedavis::display::test_failure_table
