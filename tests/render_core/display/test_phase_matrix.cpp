// Phase x freshness x data: what every cell of the table in render_core/display/README.md shows, drawn by the shipped designs.
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "render_core/display/display.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/display/hills_display.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::display::test_phase_matrix {
namespace {

using flight::FlightPhase;
using flight::Scenario;
using flight::Signal;
using test_support::HeadlessDisplay;
using test_support::kHillsNow;

constexpr std::int64_t kMinute_ns = 60'000'000'000;

struct PhaseCell {
    FlightPhase phase;
    const char* design;
    std::size_t first;  ///< aspect
};
const PhaseCell kPhases[] = {{{}, "default", 0},
                             {flight::kTakeoffFirstClimb, "takeoff", 0},
                             {{Scenario::cruise, 0}, "cruise", 1},
                             {flight::kApproachFinal, "approach", 0},
                             {flight::kGoAroundAbort, "approach", 0},
                             {flight::kGoAroundReplanning, "replanning", 2}};

/// What is known of the weather.
enum class Weather { fresh, stale, out_of_date, unsure, none };

/// Cells of a storm before the aircraft, measured `age_min` before the flight.
std::vector<std::uint8_t> scene_of(Weather weather) {
    host_sim::LayerDraft cells;
    cells.name = "cells";
    cells.shape = scene::LayerShape::areas;
    cells.role = scene::LayerRole::storm_cell;
    for (const auto& [latitude, longitude] : {std::pair(47.02, 9.70), {47.02, 9.74}, {47.05, 9.74}, {47.05, 9.70}})
        cells.points.push_back(test_support::scene_point(latitude, longitude, 4000));
    cells.starts = {0, 4};
    const std::int64_t age_min = weather == Weather::stale ? 40 : 5;
    cells.data_time_ns = kHillsNow.ns - age_min * kMinute_ns;
    cells.valid_from_ns = cells.data_time_ns;
    cells.valid_until_ns = cells.data_time_ns + (weather == Weather::out_of_date ? 2 : 120) * kMinute_ns;
    host_sim::AttributeDraft intensity;
    intensity.name = "intensity";
    intensity.unit = "dBZ";
    intensity.of = scene::AttributeOf::feature;
    intensity.values = {42};
    intensity.uncertainty_kind = scene::UncertaintyKind::standard_deviation;
    intensity.uncertainty_full = 10;
    intensity.uncertainty_all = weather == Weather::unsure ? scene::Uncertainty() : scene::Uncertainty::from_level(0.2);
    cells.attributes.push_back(intensity);
    host_sim::SceneDraft draft{"weather", "made for a test", 1, {}};
    draft.layers.push_back(cells);
    return host_sim::sdb_bytes(draft);
}

/// The display of the shipped designs.
class Flown {
public:
    explicit Flown(Weather weather) {
        for (const PhaseCell& cell : kPhases)
            if (std::string(cell.design) != "default" &&
                !phases_->add({cell.phase, cell.design}, test_support::shipped_design(cell.design)))
                ADD_FAILURE() << cell.design;
        if (weather != Weather::none) {
            image_ = scene_of(weather);
            scene_ = std::make_unique<test_support::MemoryBytes>(image_);
        }
        headless = std::make_unique<HeadlessDisplay>("egl", test_support::shipped_device("es3-mid"), 240, 180, &terrain_,
                                                     test_support::shipped_design("default"), test_support::as_it_is,
                                                     scene_.get(), phases_.get());
    }
    const FrameRecord& show(const flight::AircraftState& state, const flight::PhaseStatus& phase) {
        pixels = test_support::settled_pixels(*headless, state, kHillsNow, phase);
        return headless->display().record();
    }

    std::unique_ptr<HeadlessDisplay> headless;
    std::vector<std::uint8_t> pixels;

private:
    test_support::MemoryBytes terrain_{test_support::hills().image};
    std::vector<std::uint8_t> image_;
    std::unique_ptr<test_support::MemoryBytes> scene_;
    std::unique_ptr<design::PhaseDesigns> phases_ = std::make_unique<design::PhaseDesigns>();
};

bool has_flag(const FrameRecord& record, std::string_view flag) {
    for (const Name& name : record.flags)
        if (name.view() == flag) return true;
    return false;
}

/// One row of the table.
struct Row {
    const char* input;
    Weather weather;
    std::function<void(flight::AircraftState&, flight::PhaseStatus&)> spoil;
    const char* flag;  ///< that says it; null: none
    bool shows_terrain;
    bool shows_cells;
    double least_uncertainty;  ///< weight
};

void lose(flight::AircraftState& state, Signal signal) { state[signal] = {}; }

std::vector<Row> rows() {
    const auto nothing = [](flight::AircraftState&, flight::PhaseStatus&) {};
    return {
        {"all available", Weather::fresh, nothing, nullptr, true, true, 0},
        {"position stale", Weather::fresh, [](auto& state, auto&) { state.own_ship.state = base::SignalState::stale; },
         "own_ship.stale", false, false, 0},
        {"position lost", Weather::fresh,
         [](auto& state, auto&) {
             state.own_ship.state = base::SignalState::lost;
             lose(state, Signal::latitude);
             lose(state, Signal::longitude);
         },
         "own_ship.lost", false, false, 0},
        {"attitude missing", Weather::fresh,
         [](auto& state, auto&) {
             lose(state, Signal::pitch);
             lose(state, Signal::roll);
         },
         "pitch.missing", false, false, 0},
        {"position inaccurate", Weather::fresh,
         [](auto& state, auto&) {
             state[Signal::horizontal_accuracy] = {5000, kHillsNow};
         },
         "horizontal_accuracy.above_limit", true, true, 0},
        {"weather stale", Weather::stale, nothing, "data.stale", true, true, 0.6},
        {"weather out of date", Weather::out_of_date, nothing, "data.missing", true, false, 0.6},
        {"weather of unknown quality", Weather::unsure, nothing, nullptr, true, true, 0},
        {"no weather", Weather::none, nothing, nullptr, true, false, 0},
        {"sources of the phase disagree", Weather::fresh, [](auto&, auto& phase) { phase.disagreement = true; },
         "phase.disagreement", true, true, 0},
        {"phase switches faulty", Weather::fresh, [](auto&, auto& phase) { phase.switch_fault = true; }, "phase.switch_fault",
         true, true, 0},
    };
}

std::uint32_t cells_drawn(const FrameRecord& record) {
    for (const DataRecord& data : record.data)
        if (data.type.view() == "storm_cell") return data.drawn + data.aggregated;
    return 0;
}

void expect_cell(const Row& row, const PhaseCell& phase, const FrameRecord& record) {
    const std::string where = std::string(row.input) + ", " + phase.design;
    EXPECT_TRUE(row.flag == nullptr || has_flag(record, row.flag)) << where;
    const bool waits = row.weather == Weather::none && phase.first != design::kTerrainAspect;
    const std::string_view design = waits ? "default" : phase.design;
    EXPECT_EQ(record.design.view(), design) << where;
    EXPECT_EQ(has_flag(record, "data.stale"), row.weather == Weather::stale && row.shows_terrain) << where;
    ASSERT_EQ(record.stale.size(), has_flag(record, "data.stale") ? 1u : 0u) << where;
    if (!record.stale.empty()) EXPECT_EQ(record.stale[0].layer.view(), "cells") << where;
    if (!record.stale.empty()) EXPECT_NEAR(record.stale[0].age_s, 40 * 60, 1) << where;
    EXPECT_EQ(record.terrain_aspect.technique.view() != "none", row.shows_terrain) << where;
    if (design == "default") return;  // it states no weights
    EXPECT_EQ(record.weights[phase.first].stated, 1) << where;
    const WeightRecord& uncertainty = record.weights[design::kUncertaintyAspect];
    EXPECT_GE(uncertainty.weight, row.least_uncertainty) << where;
    EXPECT_TRUE(row.least_uncertainty > 0 || uncertainty.weight == uncertainty.stated) << where;
}

TEST(PhaseMatrix, EveryCellIsShownAsTheTableSays) {
    for (const Row& row : rows()) {
        Flown flown(row.weather);
        for (const PhaseCell& phase : kPhases) {
            flight::AircraftState state = test_support::aircraft_over_hills(3000);
            flight::PhaseStatus status = flight::stated_phase(phase.phase, flight::PhaseSource::can);
            const FrameRecord whole = flown.show(state, status);
            const std::vector<std::uint8_t> unspoilt = flown.pixels;
            row.spoil(state, status);
            const FrameRecord record = flown.show(state, status);
            expect_cell(row, phase, record);
            const std::string where = std::string(row.input) + ", " + phase.design;
            EXPECT_EQ(cells_drawn(record) > 0, row.shows_cells) << where;
            const bool is_spoilt_by_signals = row.flag != nullptr && row.weather == Weather::fresh;
            EXPECT_EQ(flown.pixels != unspoilt, is_spoilt_by_signals) << where << ": what is lost is seen to be lost";
            EXPECT_FALSE(is_spoilt_by_signals && has_flag(whole, row.flag)) << where << ": control";
        }
    }
}

/// The weather alone differs: each kind of it has a picture of its own in every phase.
TEST(PhaseMatrix, WeatherOfAnotherQualityLooksDifferent) {
    const flight::AircraftState state = test_support::aircraft_over_hills(3000);
    std::vector<std::vector<std::uint8_t>> pictures[std::size(kPhases)];
    for (const Weather weather : {Weather::fresh, Weather::out_of_date, Weather::unsure, Weather::none}) {
        Flown flown(weather);
        for (std::size_t n = 0; n < std::size(kPhases); ++n) {
            static_cast<void>(flown.show(state, flight::stated_phase(kPhases[n].phase, flight::PhaseSource::can)));
            pictures[n].push_back(flown.pixels);
        }
    }
    for (std::size_t n = 0; n < std::size(kPhases); ++n)
        for (std::size_t a = 0; a < pictures[n].size(); ++a)
            for (std::size_t b = a + 1; b < pictures[n].size(); ++b)
                EXPECT_NE(pictures[n][a], pictures[n][b]) << kPhases[n].design << ": " << a << " and " << b;
}

TEST(PhaseMatrix, TheTableHasEveryRow) {
    const std::string page = test_support::source_file("render_core/display/README.md");
    for (const Row& row : rows()) EXPECT_NE(page.find("| " + std::string(row.input) + " |"), std::string::npos) << row.input;
}

}  // namespace
}  // namespace tedavis::display::test_phase_matrix
