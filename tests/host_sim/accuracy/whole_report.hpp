/// A made-up report that has every chapter.
#pragma once

#include "host_sim/accuracy/knobs/frame_settings_knob.hpp"
#include "tests/host_sim/accuracy/made_knob.hpp"
#include "tests/support/flights/six_levels.hpp"

namespace tedavis::test_support {

inline host_sim::KnobPictures made_pictures() {
    host_sim::RgbaPicture cheap{4, 2, std::vector<std::uint8_t>(32, 90)}, exact = cheap;
    cheap.pixels[4] = 250;
    host_sim::KnobPictures pictures = host_sim::compare_pictures("made", host_sim::view_of(cheap), host_sim::view_of(exact),
                                                                 {"a pose", "tedavis shot --pose a", 1, 0});
    pictures.cheap_level = "1 steps";
    pictures.exact_level = "16 steps";
    pictures.metric = "distance, m";
    pictures.metric_max = 0.875;
    pictures.metric_map = pictures.color_map;
    pictures.metric_map.file = "made-metric.png";
    return pictures;
}

inline host_sim::FlightErrors made_flight_errors() {
    host_sim::FlightErrors flight;
    flight.flight = "a flight";
    flight.terrain = "alps.tdb";
    flight.asked_px = 1;
    flight.moments = {{10, 0.9, 0.5, 12, 100, "36,-84,1000,0,0,0"}, {20, 0.8, 0.7, 13, 90, "37,-84,1000,0,0,0"}};
    flight.lines = {{4, 3.5, 2.1, 600, 2, {0.4, 0.6}}, {1, 0.9, 0.7, 500, 0, {0.5, 0.78}}};
    flight.drawn = " --terrain alps.tdb";
    return flight;
}

inline host_sim::UncalledEffects made_uncalled() {
    host_sim::EffectUse use;
    use.name = "haze";
    use.contribution = "color";
    use.asked = 8;
    use.run = 5;
    use.skipped = 3;
    use.reasons = {{"nothing near", 3}};
    use.saved = {1.5, 0.25};
    use.largest_difference = 1;
    use.worst_pose = "36,-84,1000,0,0,0";
    return {"default", "es3-mid", 8, {use}};
}

inline host_sim::GovernorChoice made_governor_choice() {
    host_sim::GovernorChoice choice;
    choice.costs = "costs.toml";
    choice.device = "es3-mid";
    choice.renderer = "llvmpipe";
    choice.flight = "the default flight";
    choice.levels = six_levels();
    choice.deadline_ms = 33;
    choice.frames = {60, 0, 0, 15, 0, 5};
    choice.missed = 2;
    return choice;
}

inline host_sim::AccuracyReport whole_report() {
    host_sim::AccuracyReport report = made_report();
    report.knobs[0].pictures = made_pictures();
    report.knobs[0].levels[0].worst_pixel = host_sim::KnobPixel{1, 0};
    report.knobs[0].levels[0].uploaded_bytes = 123'400;
    report.knobs[0].levels[1].bytes = 56'700;
    report.knobs.push_back(report.knobs[0]);
    report.knobs[1].name = host_sim::kFrameSettings;
    report.knobs[1].pictures.reset();
    report.knobs[1].noise = 0.125;
    report.knobs[1].moments = 20;
    report.knobs[1].dearest = 1.25;
    for (host_sim::MeasuredLevel& level : report.knobs[1].levels) {
        level.options = "--steps " + level.name;
        level.proven = 1.5 * level.error.max;
    }
    report.knobs.push_back(made_knob_of_one_level());
    report.flights = {made_flight_errors()};
    report.uncalled = made_uncalled();
    report.governor = made_governor_choice();
    report.control =
        host_sim::NegativeControl{"steps", "m", "bad", "good", "there", 1e-9, {30, 40, 50, 60, 7}, {1.5, 2, 2, 2.5, 7}, true};
    report.comparisons = {{"old.json",
                           "another processor",
                           "2001-01-01T00:00:00Z",
                           "1.0",
                           false,
                           {{"made", "4 steps", 12, 21, 0.25, 0.125, false, true}},
                           {"made: 32 steps"},
                           {10, 8, 7, 9, 8}}};
    report.not_measured = {"left_out"};
    return report;
}

}  // namespace tedavis::test_support
