/// Runs with pictures, and flights as if they had been evaluated, made from formulas.
#pragma once

#include <cmath>

#include "host_sim/evaluation/evaluate_flight.hpp"
#include "tests/support/files/run_folders.hpp"

namespace tedavis::test_support {

/// Stripes of that many pixels in the picture's left `share`, the rest plain: the finer, the more edges.
inline host_sim::RgbaPicture striped_picture(std::uint32_t width, std::uint32_t height, std::uint32_t stripe, double share = 1) {
    host_sim::RgbaPicture picture{width, height, std::vector<std::uint8_t>(std::size_t{width} * height * 4, 60)};
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            std::uint8_t* pixel = &picture.pixels[(std::size_t{y} * width + x) * 4];
            pixel[3] = 255;
            if (stripe > 0 && x < share * width && x / stripe % 2 == 1) pixel[0] = pixel[1] = 220;
        }
    }
    return picture;
}

/// A run of `frames` pictures, one a second, most stripes in frames of `busy`.
inline void write_striped_run(const TemporaryFolder& place, const std::string& name, std::uint64_t frames,
                              const std::vector<std::uint64_t>& busy) {
    write_run(
        place, name,
        [](host_sim::FrameResult& result) {
            result.record.time = base::Time{} + base::Duration::from_seconds(static_cast<double>(result.record.frame));
            result.record.terrain_aspect.weight = 1;
            result.record.data_aspect.weight = result.record.uncertainty_aspect.weight = 0.3f;
        },
        frames);
    for (std::uint64_t n = 0; n < frames; ++n) {
        const bool is_busy = std::find(busy.begin(), busy.end(), n) != busy.end();
        write_picture(place, name, n, striped_picture(96, 72, is_busy ? 4 : 24, is_busy ? 0.6 : 1));
    }
}

/// One frame a second, two phases, and a peak at each third.
inline host_sim::EvaluatedFlight made_flight(std::size_t frames, double level = 0.1) {
    host_sim::EvaluatedFlight flight;
    flight.run.folder = "run";
    flight.run.log = "flight <1>.log";
    flight.run.design = "default";
    for (std::size_t n = 0; n < frames; ++n) {
        host_sim::FlightFrame frame;
        frame.frame = n;
        frame.time_s = static_cast<double>(n);
        frame.phase = n < frames / 2 ? "cruise" : "approach.final";
        frame.phase_source = "can";
        frame.prioritized = n < frames / 2 ? "data" : "terrain";
        frame.weights = n < frames / 2 ? host_sim::MainWeights{{{0.4, 0.4}, {1, 1}, {0.7, 0.7}}}
                                       : host_sim::MainWeights{{{1, 1}, {0.5, 0.5}, {0.5, 0.5}}};
        frame.picture = "run/frames/" + std::to_string(n) + ".png";
        flight.run.frames.push_back(frame);
        host_sim::PictureMeasures measures;
        measures.width = 96, measures.height = 72;
        const double third =
            std::fmod(static_cast<double>(n), static_cast<double>(frames) / 3) / (static_cast<double>(frames) / 3);
        measures.clutter = level + 0.1 * std::exp(-100 * (third - 0.5) * (third - 0.5));
        measures.clutter_grid.assign(48, measures.clutter);
        measures.clutter_grid[9] = 2 * measures.clutter;
        flight.measures.push_back(measures);
    }
    flight.peak_rule = host_sim::peak_rule_for(host_sim::times_of(flight), host_sim::clutter_of(flight));
    return flight;
}

inline void give_layers(host_sim::EvaluatedFlight& flight) {
    for (host_sim::PictureMeasures& measures : flight.measures)
        measures.layers = {{"terrain", 0.5, 0.7}, {"data", 0.3, 0.1}, {"symbology", 0.2, 0.2}};
}

/// Of three moments: clutter and one other measure have the same order, the third one another.
inline void give_disputed_moments(host_sim::EvaluatedFlight& flight) {
    const double entropies[] = {3.5, 3.9, 3.6};
    for (std::size_t n = 0; n < 3; ++n) {
        const double more = static_cast<double>(n);
        flight.measures[flight.moments[n].index].clutter += 0.01 * more;
        flight.moments[n].opinions = {4 + more, entropies[n]};
    }
}

/// With pictures of single colours as views.
inline void give_moments(host_sim::EvaluatedFlight& flight, const std::string& prefix = "") {
    flight.moments = host_sim::moments_of(flight, prefix);
    const auto png = [](std::uint8_t level) {
        const host_sim::RgbaPicture picture{8, 6, std::vector<std::uint8_t>(8 * 6 * 4, level)};
        return host_sim::encode_small_png(host_sim::view_of(picture));
    };
    for (host_sim::FlightMoment& moment : flight.moments) {
        moment.file = moment.label;
        moment.views = {png(40), png(90), png(140), png(200), png(220)};
        moment.other_views = moment.views;
        moment.opinions = moment.other_opinions = {4.0, 3.5};
        moment.plan = {{"design", "a <plain> one"}, {"weights", "terrain 1.00"}};
    }
}

}  // namespace tedavis::test_support
