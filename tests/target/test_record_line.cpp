#include "target/record_line.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "host_sim/flight_test/board_record.hpp"
#include "host_sim/reports/frame_record_json.hpp"

namespace tedavis::target::test_record_line {
namespace {

using Json = nlohmann::json;

Json parsed(const display::FrameRecord& record, const FrameDelivery& delivery) {
    static JsonLine line;
    write_record(record, delivery, line);
    EXPECT_FALSE(line.cut());
    return Json::parse(line.line());
}

/// As it is after a flight, every list with an entry.
display::FrameRecord filled_record() {
    display::FrameRecord record{};
    record.frame = 41;
    record.time = {12'500'000'000};
    record.flight_time = {base::Time{1'780'315'207'250'000'000}, true, true};
    record.phase = flight::stated_phase(flight::phase_from_name("approach.final").phase, flight::PhaseSource::can);
    record.own_ship.state = base::SignalState::valid;
    record.own_ship.position.latitude_rad = 0.8;
    record.own_ship.position.longitude_rad = -0.2;
    record.altitude_msl_m = 1234.5;
    record.heading_rad = 1.5;
    record.pitch_rad = -0.125;
    record.signals.fill(base::SignalState::stale);
    EXPECT_TRUE(record.flags.try_push_back(display::Name("a \"flag\"")));
    record.terrain.tau_px = 1.5;
    record.terrain.limit = "met";
    record.terrain.triangles = 12'000;
    record.terrain.renderer = "raster";
    record.terrain.renderer_reason = base::FixedString<63>("it costs no more than the other renderer");
    record.terrain.triangles_ms = 7.5;
    record.terrain.rays_ms = 9.25;
    record.alerts.terrain = policy::TerrainAhead::caution;
    record.alerts.is_watching = true;
    record.alerts.height_above_terrain_m = 150.25;
    display::EffectRecord effect;
    effect.name = "haze";
    effect.state = display::EffectState::replaced;
    effect.reason = "no room";
    effect.replaced_by = "fog";
    EXPECT_TRUE(record.effects.try_push_back(effect));
    record.scene_revision = 7;
    record.design = "default";
    return record;
}

/// Whether what the board says stands in the record of the desk with the same value.
void expect_part(const Json& board, const Json& desk, const std::string& where) {
    for (const auto& [key, value] : board.items()) {
        const std::string place = where + "/" + key;
        ASSERT_TRUE(desk.contains(key)) << place;
        if (value.is_object())
            expect_part(value, desk[key], place);
        else if (value.is_array() && !value.empty() && value[0].is_object())
            for (std::size_t n = 0; n < value.size(); ++n) expect_part(value[n], desk[key][n], place);
        else if (value.is_number())
            EXPECT_NEAR(value.get<double>(), desk[key].get<double>(), 1e-6) << place;
        else
            EXPECT_EQ(value, desk[key]) << place;
    }
}

Json without_delivery(Json record) {
    for (const char* key :
         {"switch_fault", "disagreement", "warm", "on_screen", "can_to_screen_ms", "ms", "monotonic_s", "values"})
        record.erase(key);
    return record;
}

TEST(RecordLine, HasTheKeysAndValuesOfTheDesk) {
    const auto record = std::make_unique<display::FrameRecord>(filled_record());
    const base::Time begun{2'500'000'000};
    const Json board = parsed(*record, {begun, {}, true, true, {}, {}});
    host_sim::FrameResult result;
    result.record = *record;
    expect_part(without_delivery(board), Json::parse(host_sim::frame_record_json(result, begun)), "");
    for (const char* key : {"frame", "utc", "phase_source", "own_ship", "signals", "flags", "terrain", "alerts", "scene_revision",
                            "effects", "presentation", "warm", "on_screen", "can_to_screen_ms", "ms"})
        EXPECT_TRUE(board.contains(key)) << key;
    EXPECT_EQ(board["utc"]["time_s"], 1780315207.25);
    EXPECT_EQ(board["time_s"], 10.0);
    EXPECT_EQ(board["phase"], "approach");
    EXPECT_EQ(board["sub_phase"], "final");
    EXPECT_EQ(board["flags"][0], "a \"flag\"");
    EXPECT_EQ(board["terrain"]["renderer_ms"], Json({{"raster", 7.5}, {"trace", 9.25}}));
}

TEST(RecordLine, APlaceThatIsLostIsNotStated) {
    const auto record = std::make_unique<display::FrameRecord>(filled_record());
    record->own_ship.state = base::SignalState::lost;
    const Json board = parsed(*record, {});
    EXPECT_TRUE(board["own_ship"]["lat_deg"].is_null());
    EXPECT_EQ(board["own_ship"]["state"], "lost");
    host_sim::FrameResult result;
    result.record = *record;
    expect_part(without_delivery(board), Json::parse(host_sim::frame_record_json(result, {})), "");
}

TEST(RecordLine, SaysWhenThePictureWasOnTheScreen) {
    const auto record = std::make_unique<display::FrameRecord>(filled_record());
    const Json shown = parsed(*record, {{}, base::Duration::milliseconds(9), true, true, base::Duration::milliseconds(31), {}});
    EXPECT_EQ(shown["can_to_screen_ms"], 31.0);
    EXPECT_EQ(shown["on_screen"], true);
    EXPECT_EQ(shown["ms"]["total"], 9.0);
    const Json hidden = parsed(*record, {{}, {}, false, false, std::nullopt, {}});
    EXPECT_TRUE(hidden["can_to_screen_ms"].is_null());
    EXPECT_EQ(hidden["on_screen"], false);
    EXPECT_EQ(shown["warm"], true);
    EXPECT_EQ(hidden["warm"], false);
}

/// Programs on the same machine read the same clock, whenever the run began.
TEST(RecordLine, SaysTheInstantOfTheMachinesClock) {
    const auto record = std::make_unique<display::FrameRecord>(filled_record());
    record->time = {1'234'567'890'123'456'000};  // 39 years after the machine's start
    const Json board = parsed(*record, {{1'234'567'890'000'000'000}, {}, true, true, {}, {}});
    EXPECT_NEAR(board["monotonic_s"].get<double>(), 1234567890.123456, 1e-5);
    EXPECT_NEAR(board["time_s"].get<double>(), 0.123456, 1e-9);
}

TEST(RecordLine, HasTheValuesOfSignalsThatHaveOne) {
    const auto record = std::make_unique<display::FrameRecord>(filled_record());
    auto state = std::make_unique<flight::AircraftState>();
    (*state)[flight::Signal::pitch] = base::Stamped<double>(-0.25, {});
    FrameDelivery delivery;
    delivery.values = values_of(*state);
    const Json values = parsed(*record, delivery)["values"];
    EXPECT_EQ(values, Json({{"pitch", -0.25}}));
}

/// What flight tests read of it.
TEST(RecordLine, IsReadAsTheFrameThatExpectationsSee) {
    auto record = std::make_unique<display::FrameRecord>(filled_record());
    record->phase.source = flight::PhaseSource::held;
    record->phase.disagreement = true;
    record->alerts.obstacle = policy::TerrainAhead::warning;
    FrameDelivery delivery{{}, {}, true, true, base::Duration::milliseconds(31), {}};
    delivery.values.fill(0.5);
    static JsonLine line;
    write_record(*record, delivery, line);
    const host_sim::BoardRecord read = host_sim::read_board_record(line.line(), "/s");
    EXPECT_EQ(read.frame, 41u);
    EXPECT_DOUBLE_EQ(read.monotonic_s, 12.5);
    EXPECT_DOUBLE_EQ(*read.can_to_screen_s, 0.031);
    const display::FrameRecord& seen = read.seen.record;
    EXPECT_EQ(seen.phase.phase, record->phase.phase);
    EXPECT_EQ(seen.phase.source, record->phase.source);
    EXPECT_TRUE(seen.phase.disagreement);
    EXPECT_EQ(seen.signals, record->signals);
    EXPECT_EQ(read.seen.values[flight::Signal::pitch], 0.5);
    ASSERT_EQ(seen.flags.size(), 1u);
    EXPECT_EQ(seen.flags[0].view(), record->flags[0].view());
    EXPECT_EQ(seen.alerts.terrain, record->alerts.terrain);
    EXPECT_EQ(seen.alerts.obstacle, record->alerts.obstacle);
    EXPECT_EQ(seen.alerts.height_above_terrain_m, record->alerts.height_above_terrain_m);
    ASSERT_EQ(seen.effects.size(), 1u);
    EXPECT_EQ(seen.effects[0].state, display::EffectState::replaced);
    EXPECT_EQ(seen.effects[0].reason.view(), "no room");
    EXPECT_EQ(seen.design.view(), record->design.view());
}

/// The longest names in every list: more than any flight has.
TEST(RecordLine, TheLargestRecordFitsAPacket) {
    const auto record = std::make_unique<display::FrameRecord>(filled_record());
    const std::string longest(47, '"');
    while (record->flags.try_push_back(display::Name(longest))) {
    }
    display::EffectRecord effect;
    effect.name = effect.replaced_by = display::Name(longest);
    effect.reason = base::FixedString<95>(std::string(95, '"'));
    while (record->effects.try_push_back(effect)) {
    }
    EXPECT_EQ(parsed(*record, {})["effects"].size(), record->effects.size());
}

}  // namespace
}  // namespace tedavis::target::test_record_line
