#include "host_sim/evaluation/evaluated_flight.hpp"

#include <algorithm>

namespace tedavis::host_sim {
namespace {

std::vector<LayerShare> mean_layers(const EvaluatedFlight& flight, std::size_t first, std::size_t end) {
    std::vector<LayerShare> sums;
    double frames = 0;
    for (std::size_t n = first; n < end; ++n) {
        const std::vector<LayerShare>& layers = flight.measures[n].layers;
        frames += layers.empty() ? 0 : 1;
        for (const LayerShare& one : layers) {
            auto sum = std::find_if(sums.begin(), sums.end(), [&](const LayerShare& known) { return known.layer == one.layer; });
            if (sum == sums.end()) sum = sums.insert(sums.end(), LayerShare{one.layer, 0, 0});
            sum->share += one.share;
            sum->area += one.area;
        }
    }
    for (LayerShare& sum : sums) sum.share /= frames, sum.area /= frames;
    return sums;
}

MainWeights mean_weights(const std::vector<FlightFrame>& frames, std::size_t first, std::size_t end) {
    MainWeights mean;
    for (std::size_t n = first; n < end; ++n) {
        for (std::size_t aspect = 0; aspect < mean.size(); ++aspect) {
            mean[aspect].weight += frames[n].weights[aspect].weight / static_cast<double>(end - first);
            mean[aspect].stated += frames[n].weights[aspect].stated / static_cast<double>(end - first);
        }
    }
    return mean;
}

std::string first_words(const std::vector<std::string>& aspects) {
    if (aspects.empty()) return "none";
    std::string words = aspects.front();
    for (std::size_t n = 1; n < aspects.size(); ++n) words += (n + 1 == aspects.size() ? " and " : ", ") + aspects[n];
    return words + (aspects.size() > 1 ? " alike" : "");
}

/// Of contiguous frames, phase by phase: hazards on the way raise weights for a while, and that is no other order of a design.
void add_priority(const std::vector<FlightFrame>& frames, SpanSummary& span) {
    for (std::size_t begin = span.first; begin < span.end;) {
        std::size_t next = begin;
        while (next < span.end && frames[next].phase == frames[begin].phase) ++next;
        const std::vector<std::string> aspects = first_aspects(mean_weights(frames, begin, next));
        const std::string words = first_words(aspects);
        const bool is_another = begin > span.first && words != span.comes_first;
        span.comes_first = is_another ? std::string() : words;
        span.prioritized = is_another || aspects.size() != 1 ? std::string() : aspects.front();
        if (is_another) return;
        begin = next;
    }
}

}  // namespace

SpanSummary summary_of(const EvaluatedFlight& flight, std::size_t first, std::size_t end) {
    SpanSummary span{flight.run.frames[first].phase, first, end, 0, 0, first, {}, {}, {}};
    for (std::size_t n = first; n < end; ++n) {
        const double clutter = flight.measures[n].clutter;
        span.mean += clutter / static_cast<double>(end - first);
        if (clutter > span.highest) span.highest = clutter, span.highest_at = n;
    }
    span.layers = mean_layers(flight, first, end);
    add_priority(flight.run.frames, span);
    return span;
}

std::vector<SpanSummary> summaries_by_phase(const EvaluatedFlight& flight) {
    std::vector<SpanSummary> summaries;
    for (const FlightPhaseSpan& span : phase_spans(flight.run.frames))
        summaries.push_back(summary_of(flight, span.first, span.end));
    return summaries;
}

std::optional<double> prioritized_share(const SpanSummary& span) {
    for (const LayerShare& layer : span.layers)
        if (!span.prioritized.empty() && layer.layer == span.prioritized) return layer.share;
    return std::nullopt;
}

std::optional<double> mean_prioritized_share(const EvaluatedFlight& flight) {
    double sum = 0, frames = 0;
    for (std::size_t n = 0; n < flight.measures.size(); ++n) {
        for (const LayerShare& layer : flight.measures[n].layers) {
            if (layer.layer != flight.run.frames[n].prioritized) continue;
            sum += layer.share;
            frames += 1;
        }
    }
    return frames > 0 ? std::optional<double>(sum / frames) : std::nullopt;
}

std::vector<double> times_of(const EvaluatedFlight& flight) {
    std::vector<double> times;
    for (const FlightFrame& frame : flight.run.frames) times.push_back(frame.time_s);
    return times;
}

std::vector<double> clutter_of(const EvaluatedFlight& flight) {
    std::vector<double> values;
    for (const PictureMeasures& one : flight.measures) values.push_back(one.clutter);
    return values;
}

OpinionsAgreement agreement_over_moments(const EvaluatedFlight& flight) {
    std::vector<double> clutter;
    std::vector<ClutterOpinions> opinions;
    for (const FlightMoment& moment : flight.moments) {
        clutter.push_back(flight.measures[moment.index].clutter);
        opinions.push_back(moment.opinions);
    }
    return opinions_agreement(clutter, opinions);
}

std::vector<double> mean_grid(const EvaluatedFlight& flight) {
    std::vector<double> means;
    for (const PictureMeasures& one : flight.measures) {
        means.resize(one.clutter_grid.size(), 0.0);
        for (std::size_t n = 0; n < means.size(); ++n)
            means[n] += one.clutter_grid[n] / static_cast<double>(flight.measures.size());
    }
    return means;
}

std::vector<FlightMoment> moments_of(const EvaluatedFlight& flight, const std::string& prefix) {
    const std::vector<double> clutter = clutter_of(flight);
    std::vector<Peak> peaks = find_peaks(times_of(flight), clutter, flight.peak_rule);
    if (peaks.empty() && !clutter.empty()) {
        const auto highest = std::max_element(clutter.begin(), clutter.end());
        peaks.push_back({static_cast<std::size_t>(highest - clutter.begin()), 0});
    }
    std::vector<FlightMoment> moments;
    for (const Peak& peak : peaks) {
        FlightMoment moment;
        const auto number = static_cast<int>(moments.size());
        moment.label = prefix.empty() ? std::string(1, static_cast<char>('A' + number)) : prefix + std::to_string(number + 1);
        moment.index = peak.index;
        moment.prominence = peak.prominence;
        moments.push_back(std::move(moment));
    }
    return moments;
}

std::string region_name(const perception::RegionGrid& grid, int column, int row) {
    const auto third = [](int place, int count) { return std::min(2, (2 * place + 1) * 3 / (2 * count)); };
    static constexpr const char* kRows[] = {"upper", "middle", "lower"};
    static constexpr const char* kColumns[] = {"left", "centre", "right"};
    return std::string(kRows[third(row, grid.rows)]) + " " + kColumns[third(column, grid.columns)];
}

std::size_t busiest_region(const std::vector<double>& densities) {
    return static_cast<std::size_t>(std::max_element(densities.begin(), densities.end()) - densities.begin());
}

}  // namespace tedavis::host_sim
