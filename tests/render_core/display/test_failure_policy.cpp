#include "render_core/display/failure_policy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/device_files.hpp"

namespace tedavis::display {
namespace {

using base::Duration;
using base::Quality;
using base::SignalState;
using base::Stamped;
using base::Time;
using flight::AircraftState;
using flight::Signal;

const Time kNow{1'000'000'000'000};

Stamped<double> in_state(SignalState state, double value) {
    switch (state) {
        case SignalState::missing: return {};
        case SignalState::valid: return {value, kNow};
        case SignalState::stale: return {value, kNow - Duration::milliseconds(700)};
        case SignalState::lost: return {value, kNow - Duration::seconds(5)};
        case SignalState::invalid: return {value, kNow, Quality::bad};
    }
    return {};
}

double plausible(Signal signal) {
    switch (signal) {
        case Signal::horizontal_accuracy:
        case Signal::vertical_accuracy: return 5;
        case Signal::ground_speed:
        case Signal::indicated_airspeed: return 60;
        case Signal::baro_setting: return 101'325;
        default: return 0.1;
    }
}

AircraftState everything_valid() {
    AircraftState state;
    for (std::size_t i = 0; i < flight::kSignalCount; ++i)
        state.signals[i] = in_state(SignalState::valid, plausible(static_cast<Signal>(i)));
    state.own_ship.state = SignalState::valid;
    state.own_ship.height_is_geometric = true;
    state.own_ship.velocity_north_mps = 60;
    state.own_ship.at = kNow;
    return state;
}

void put(AircraftState& state, Signal signal, SignalState as) { state[signal] = in_state(as, plausible(signal)); }

DisplayConditions good_conditions() {
    DisplayConditions conditions;
    conditions.terrain = TerrainSource::ready;
    return conditions;
}

DisplayDecisions decide(const AircraftState& state, const DisplayConditions& conditions = good_conditions()) {
    return decide_display(state, kNow, conditions, design::default_design_settings());
}

std::vector<std::string> flags_of(const DisplayDecisions& decisions) {
    std::vector<std::string> flags;
    for (const auto& flag : decisions.flags) flags.emplace_back(flag.view());
    return flags;
}
bool has_flag(const DisplayDecisions& decisions, const std::string& name) {
    const auto flags = flags_of(decisions);
    return std::find(flags.begin(), flags.end(), name) != flags.end();
}
bool has_notice(const DisplayDecisions& decisions, std::string_view text) {
    return std::any_of(decisions.notices.begin(), decisions.notices.end(),
                       [&](const Notice& n) { return n.text.view() == text; });
}

constexpr Element kNone = Element::count_;
constexpr SignalState kBadStates[] = {SignalState::missing, SignalState::stale, SignalState::lost, SignalState::invalid};

/// One row of the table in the module's README, which is written independently of the policy's own: what is left on the
/// display for missing, stale, lost and invalid.
struct Row {
    Signal signal = Signal::count_;
    Element element = kNone;
    std::array<std::string, 4> alone;          ///< all other signals valid
    std::array<std::string, 4> without_peers;  ///< no other source of the same information received
};

constexpr const char* kElementNames[] = {"attitude",       "heading",      "airspeed",      "altitude",
                                         "vertical_speed", "baro_setting", "ground_height", "flight_path"};

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
        if (element != std::end(kElementNames)) row.element = static_cast<Element>(element - std::begin(kElementNames));
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

DisplayConditions map_conditions() {
    DisplayConditions conditions = good_conditions();
    conditions.is_map = true;
    return conditions;
}

DisplayDecisions decide_track_up(const AircraftState& state) {
    design::DesignSettings design = design::default_design_settings();
    design.view.map_orientation = design::MapOrientation::track_up;
    return decide_display(state, kNow, map_conditions(), design);
}

/// What else states the same information on the display.
std::vector<Signal> peers_of(Signal signal) {
    const std::vector<std::vector<Signal>> families = {
        {Signal::true_heading, Signal::magnetic_heading, Signal::magnetic_variation, Signal::true_track},
        {Signal::indicated_airspeed, Signal::calibrated_airspeed, Signal::true_airspeed, Signal::ground_speed},
        {Signal::radio_height, Signal::height_above_terrain},
        {Signal::ellipsoid_height, Signal::true_altitude},
    };
    std::vector<Signal> peers;
    if (signal == Signal::baro_altitude) return {Signal::true_altitude, Signal::ellipsoid_height, Signal::standard_altitude};
    if (signal == Signal::standard_altitude) return {Signal::true_altitude, Signal::ellipsoid_height, Signal::baro_altitude};
    for (const auto& family : families)
        if (std::find(family.begin(), family.end(), signal) != family.end())
            std::copy_if(family.begin(), family.end(), std::back_inserter(peers), [&](Signal s) { return s != signal; });
    return peers;
}

std::string picture(const DisplayDecisions& decisions, const Row& row, SignalState state) {
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
        EXPECT_EQ(signal_rule(static_cast<Signal>(i)).signal, static_cast<Signal>(i));
        EXPECT_EQ(consequences(signal_rule(static_cast<Signal>(i)), SignalState::valid), kNoConsequence);
    }
}

TEST(FailurePolicy, EveryCellWithAllOtherSignalsValid) {
    for (const Row& row : table())
        for (int i = 0; i < 4; ++i) {
            AircraftState state = everything_valid();
            put(state, row.signal, kBadStates[i]);
            EXPECT_EQ(picture(decide(state), row, kBadStates[i]), row.alone[i])
                << to_string(row.signal) << "." << to_string(kBadStates[i]);
        }
}

TEST(FailurePolicy, EveryCellWithoutAnotherSourceOfTheInformation) {
    for (const Row& row : table())
        for (int i = 0; i < 4; ++i) {
            AircraftState state = everything_valid();
            for (Signal peer : peers_of(row.signal)) put(state, peer, SignalState::missing);
            put(state, row.signal, kBadStates[i]);
            const DisplayDecisions decisions = decide(state);
            EXPECT_EQ(picture(decisions, row, kBadStates[i]), row.without_peers[i])
                << to_string(row.signal) << "." << to_string(kBadStates[i]);
            const bool attitude_lost = decisions[Element::attitude].show == ElementShow::failed;
            EXPECT_EQ(decisions.plain_horizon, !decisions.show_terrain && !attitude_lost);
        }
}

TEST(FailurePolicy, EveryCellOnTheMap) {
    EXPECT_EQ(read_table("map: ").size(), 6u);
    for (const Row& row : map_table())
        for (int i = 0; i < 4; ++i) {
            AircraftState state = everything_valid();
            put(state, row.signal, kBadStates[i]);
            EXPECT_EQ(picture(decide(state, map_conditions()), row, kBadStates[i]), row.alone[i])
                << to_string(row.signal) << "." << to_string(kBadStates[i]);
            for (Signal peer : peers_of(row.signal)) put(state, peer, SignalState::missing);
            const DisplayDecisions decisions = decide(state, map_conditions());
            EXPECT_EQ(picture(decisions, row, kBadStates[i]), row.without_peers[i])
                << "alone " << to_string(row.signal) << "." << to_string(kBadStates[i]);
            EXPECT_FALSE(decisions.plain_horizon);
        }
}

TEST(FailurePolicy, TheMapTurnsToTheTrackThenToTheHeadingThenToNorth) {
    AircraftState state = everything_valid();
    EXPECT_EQ(decide_track_up(state)[Element::map_up].source, Signal::true_track);
    EXPECT_EQ(decide_track_up(state)[Element::map_up].show, ElementShow::normal);
    EXPECT_TRUE(decide_track_up(state).flags.empty());
    for (const SignalState bad : kBadStates) {
        put(state, Signal::true_track, bad);
        const DisplayDecisions by_heading = decide_track_up(state);
        EXPECT_EQ(by_heading[Element::map_up].source, Signal::true_heading);
        EXPECT_EQ(by_heading[Element::map_up].show, ElementShow::substituted);
        EXPECT_TRUE(has_flag(by_heading, "map.heading_up"));
        EXPECT_FALSE(has_notice(by_heading, "MAP NORTH UP"));
        AircraftState without = state;
        for (const Signal lost : {Signal::true_heading, Signal::magnetic_heading}) put(without, lost, SignalState::lost);
        const DisplayDecisions north = decide_track_up(without);
        EXPECT_EQ(north[Element::map_up].source, Signal::count_);
        EXPECT_EQ(north[Element::map_up].show, ElementShow::flagged);
        EXPECT_TRUE(has_flag(north, "map.north_up"));
        EXPECT_TRUE(has_notice(north, "MAP NORTH UP"));
        EXPECT_TRUE(north.show_terrain);
    }
    EXPECT_EQ(decide(state, map_conditions())[Element::map_up].show, ElementShow::normal) << "north was asked for";
    EXPECT_FALSE(has_flag(decide(state, map_conditions()), "map.heading_up"));
    design::DesignSettings track_up = design::default_design_settings();
    track_up.view.map_orientation = design::MapOrientation::track_up;
    EXPECT_FALSE(has_flag(decide_display(state, kNow, good_conditions(), track_up), "map.heading_up")) << "no map, no flag";
}

TEST(FailurePolicy, TheMapFlagsItsPositionInPlace) {
    AircraftState state = everything_valid();
    EXPECT_EQ(decide(state, map_conditions())[Element::position].show, ElementShow::normal);
    for (const SignalState bad : kBadStates) {
        state.own_ship.state = bad;
        const DisplayDecisions decisions = decide(state, map_conditions());
        EXPECT_EQ(decisions[Element::position].show, bad == SignalState::stale ? ElementShow::flagged : ElementShow::failed);
        EXPECT_EQ(decisions[Element::map_up].show, bad == SignalState::stale ? ElementShow::normal : ElementShow::absent);
        EXPECT_FALSE(decisions.show_terrain);
        EXPECT_FALSE(decisions.plain_horizon);
        EXPECT_TRUE(has_notice(decisions, "TERRAIN OFF"));
    }
}

TEST(FailurePolicy, TheMapHasNoRecoveryPicture) {
    AircraftState state = everything_valid();
    state[Signal::roll] = {base::radians(179), kNow};
    EXPECT_TRUE(decide(state).unusual_attitude);
    EXPECT_FALSE(decide(state, map_conditions()).unusual_attitude);
    EXPECT_TRUE(decide(state, map_conditions()).show_warning_colors);
}

TEST(FailurePolicy, EverythingValidShowsEverythingAndFlagsNothing) {
    const DisplayDecisions decisions = decide(everything_valid());
    EXPECT_TRUE(decisions.show_terrain);
    EXPECT_TRUE(decisions.show_warning_colors);
    EXPECT_FALSE(decisions.terrain_degraded);
    EXPECT_FALSE(decisions.plain_horizon);
    EXPECT_TRUE(decisions.flags.empty());
    for (const ElementDecision& element : decisions.elements) EXPECT_EQ(element.show, ElementShow::normal);
    EXPECT_EQ(decisions.view_heading, Signal::true_heading);
    ASSERT_EQ(decisions.notices.size(), 1u);
    EXPECT_EQ(decisions.notices[0].text.view(), "NOT FOR NAVIGATION");
}

TEST(FailurePolicy, NothingReceivedShowsNoInformationAtAll) {
    const DisplayDecisions decisions = decide(AircraftState{});
    EXPECT_FALSE(decisions.show_terrain);
    EXPECT_FALSE(decisions.plain_horizon);
    EXPECT_EQ(decisions.view_heading, Signal::count_);
    for (const ElementDecision& element : decisions.elements)
        EXPECT_TRUE(element.show == ElementShow::failed || element.show == ElementShow::absent);
    EXPECT_TRUE(has_notice(decisions, "NO GPS POSITION"));
    EXPECT_TRUE(has_flag(decisions, "own_ship.missing"));
}

TEST(FailurePolicy, OwnShipEstimateNotValidRemovesTerrain) {
    for (SignalState bad : kBadStates) {
        AircraftState state = everything_valid();
        state.own_ship.state = bad;
        const DisplayDecisions decisions = decide(state);
        EXPECT_FALSE(decisions.show_terrain);
        EXPECT_TRUE(decisions.plain_horizon);
        EXPECT_EQ(decisions[Element::flight_path].show, ElementShow::failed);
        EXPECT_TRUE(has_flag(decisions, std::string("own_ship.") + to_string(bad)));
        EXPECT_TRUE(has_notice(decisions, bad == SignalState::stale ? "GPS POSITION STALE" : "NO GPS POSITION"));
        EXPECT_TRUE(has_notice(decisions, "TERRAIN OFF"));
    }
}

TEST(FailurePolicy, HeightWithoutGeometryKeepsTerrainDegradedAndUncoloured) {
    AircraftState state = everything_valid();
    state.own_ship.height_is_geometric = false;
    const DisplayDecisions decisions = decide(state);
    EXPECT_TRUE(decisions.show_terrain);
    EXPECT_TRUE(decisions.terrain_degraded);
    EXPECT_FALSE(decisions.show_warning_colors);
    EXPECT_TRUE(has_flag(decisions, "terrain.degraded"));
    EXPECT_TRUE(has_notice(decisions, "TERRAIN DEGRADED"));
}

TEST(FailurePolicy, AHeightOnTheAltimetersSettingKeepsTerrainWithoutColours) {
    AircraftState state = everything_valid();
    put(state, Signal::ellipsoid_height, SignalState::missing);
    put(state, Signal::true_altitude, SignalState::missing);
    state.own_ship.height_is_geometric = false;
    state.own_ship.height_is_on_qnh = true;
    DisplayDecisions decisions = decide(state);
    EXPECT_TRUE(decisions.show_terrain);
    EXPECT_FALSE(decisions.terrain_degraded);
    EXPECT_FALSE(decisions.show_warning_colors);
    EXPECT_TRUE(has_flag(decisions, "own_ship.height_on_qnh"));
    for (const Signal needed : {Signal::baro_altitude, Signal::baro_setting}) {
        AircraftState without = state;
        put(without, needed, SignalState::missing);
        EXPECT_TRUE(decide(without).terrain_degraded) << to_string(needed);
    }
}

TEST(FailurePolicy, TerrainThatIsNotAsItShouldBeIsShownAndSaid) {
    struct Case {
        bool DisplayConditions::*condition;
        const char *notice, *flag;
    };
    for (const Case& said : {Case{&DisplayConditions::terrain_is_coarse, "TERRAIN COARSE", "terrain.coarse"},
                             Case{&DisplayConditions::image_is_missing, "NO TERRAIN IMAGE", "terrain.no_image"}}) {
        DisplayConditions conditions = good_conditions();
        conditions.*said.condition = true;
        const DisplayDecisions decisions = decide(everything_valid(), conditions);
        EXPECT_TRUE(decisions.show_terrain);
        EXPECT_TRUE(has_notice(decisions, said.notice));
        EXPECT_TRUE(has_flag(decisions, said.flag));
        conditions.terrain = TerrainSource::outside;
        EXPECT_FALSE(has_notice(decide(everything_valid(), conditions), said.notice)) << "no terrain is shown";
    }
}

TEST(FailurePolicy, AccuracyBeyondItsLimitDegrades) {
    for (Signal accuracy : {Signal::horizontal_accuracy, Signal::vertical_accuracy}) {
        AircraftState state = everything_valid();
        const auto limits = design::default_design_settings().degradation;
        const double limit = accuracy == Signal::horizontal_accuracy ? limits.horizontal_accuracy_m : limits.vertical_accuracy_m;
        state[accuracy] = {limit, kNow};
        EXPECT_FALSE(decide(state).terrain_degraded);
        state[accuracy] = {limit + 0.1, kNow};
        EXPECT_TRUE(decide(state).terrain_degraded);
        EXPECT_FALSE(decide(state).show_warning_colors);
        EXPECT_TRUE(has_flag(decide(state), std::string(to_string(accuracy)) + ".above_limit"));
    }
}

TEST(FailurePolicy, HeadingFallsBackFromTrueToMagneticToTrack) {
    AircraftState state = everything_valid();
    put(state, Signal::true_heading, SignalState::lost);
    EXPECT_EQ(decide(state).view_heading, Signal::magnetic_heading);
    put(state, Signal::magnetic_variation, SignalState::lost);
    EXPECT_EQ(decide(state).view_heading, Signal::true_track);
    EXPECT_EQ(decide(state)[Element::heading].source, Signal::magnetic_heading);  // shown, but cannot turn the view
    put(state, Signal::magnetic_heading, SignalState::lost);
    const DisplayDecisions tracked = decide(state);
    EXPECT_EQ(tracked.view_heading, Signal::true_track);
    EXPECT_EQ(tracked[Element::heading].show, ElementShow::substituted);
    EXPECT_TRUE(tracked.show_terrain);
    EXPECT_TRUE(has_flag(tracked, "true_heading.lost"));
    put(state, Signal::true_track, SignalState::stale);
    EXPECT_FALSE(decide(state).show_terrain);
    EXPECT_EQ(decide(state)[Element::heading].show, ElementShow::flagged);
}

TEST(FailurePolicy, TheDatabaseHasItsPictures) {
    const std::pair<TerrainSource, const char*> cases[] = {
        {TerrainSource::none, "NO TERRAIN DATA"},   {TerrainSource::outside, "OUTSIDE DATABASE"},
        {TerrainSource::failed, "TERRAIN FAIL"},    {TerrainSource::over_budget, "TERRAIN OFF"},
        {TerrainSource::too_coarse, "TERRAIN OFF"}, {TerrainSource::above_own_ship, "BELOW TERRAIN"}};
    for (const auto& [source, text] : cases) {
        DisplayConditions conditions = good_conditions();
        conditions.terrain = source;
        const DisplayDecisions decisions = decide(everything_valid(), conditions);
        EXPECT_FALSE(decisions.show_terrain);
        EXPECT_FALSE(decisions.show_warning_colors);
        EXPECT_TRUE(decisions.plain_horizon);
        EXPECT_TRUE(has_notice(decisions, text));
        EXPECT_EQ(decisions.flags.size(), 1u);
    }
}

TEST(FailurePolicy, UnusualAttitudesDeclutter) {
    const std::pair<double, double> unusual[] = {{31, 0}, {-21, 0}, {0, 61}, {0, -61}, {0, 179}};
    for (const auto& [pitch_deg, roll_deg] : unusual) {
        AircraftState state = everything_valid();
        state[Signal::pitch] = {base::radians(pitch_deg), kNow};
        state[Signal::roll] = {base::radians(roll_deg), kNow};
        EXPECT_TRUE(decide(state).unusual_attitude);
        EXPECT_FALSE(decide(state).show_warning_colors);
        EXPECT_EQ(decide(state)[Element::flight_path].show, ElementShow::absent);
    }
    AircraftState steep = everything_valid();
    steep[Signal::pitch] = {base::radians(29), kNow};
    steep[Signal::roll] = {base::radians(-59), kNow};
    EXPECT_FALSE(decide(steep).unusual_attitude);
}

TEST(FailurePolicy, PhaseFaultsAndGeneratedFlightsAreSaid) {
    DisplayConditions conditions = good_conditions();
    conditions.phase.switch_fault = true;
    conditions.phase.disagreement = true;
    conditions.generated_flight = true;
    const DisplayDecisions decisions = decide(everything_valid(), conditions);
    EXPECT_TRUE(has_flag(decisions, "phase.switch_fault"));
    EXPECT_TRUE(has_flag(decisions, "phase.disagreement"));
    EXPECT_TRUE(has_notice(decisions, "GENERATED FLIGHT"));
    for (std::size_t i = 1; i < decisions.notices.size(); ++i)
        EXPECT_GE(decisions.notices[i].level, decisions.notices[i - 1].level);
}

TEST(FailurePolicy, NoMixOfStatesOverflowsOrShowsTerrainOnBadAttitude) {
    // Every signal drawn from a small deterministic generator; a full container would stop the program.
    std::uint32_t random = 1;
    for (int round = 0; round < 20'000; ++round) {
        AircraftState state = everything_valid();
        for (std::size_t i = 0; i < flight::kSignalCount; ++i) {
            random = random * 1664525u + 1013904223u;
            put(state, static_cast<Signal>(i), static_cast<SignalState>((random >> 16) % 5));
        }
        random = random * 1664525u + 1013904223u;
        state.own_ship.state = static_cast<SignalState>((random >> 16) % 5);
        DisplayConditions conditions = good_conditions();
        conditions.terrain = static_cast<TerrainSource>((random >> 20) % 4);
        conditions.phase.switch_fault = conditions.phase.disagreement = conditions.generated_flight = true;
        const DisplayDecisions decisions = decide(state, conditions);
        const bool known = state.is_valid(Signal::pitch, kNow) && state.is_valid(Signal::roll, kNow) &&
                           state.own_ship.state == SignalState::valid && decisions.view_heading != Signal::count_;
        EXPECT_TRUE(known || !decisions.show_terrain);
        EXPECT_TRUE(!decisions.show_warning_colors || (decisions.show_terrain && !decisions.terrain_degraded));
        EXPECT_FALSE(decisions.show_terrain && decisions.plain_horizon);
    }
}

}  // namespace
}  // namespace tedavis::display
