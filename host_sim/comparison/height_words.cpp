#include "host_sim/comparison/height_words.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/reports/run_findings.hpp"

namespace tedavis::host_sim {
namespace {

/// The end of "heights of A"; empty where they are geometric.
std::string basis_words(const ComparedRun& run) {
    if (run.assumes_heights) return "are pressure altitudes, taken for heights above sea level (--assume-geometric)";
    const std::size_t by_pressure = frames_by_pressure(run);
    if (by_pressure == 0) return {};
    const std::string where =
        by_pressure == run.frames.size() ? std::string() : " in " + part_of(by_pressure, run.frames.size()) + " frames";
    return "are pressure altitudes alone" + where + ", which are no heights above sea level";
}

std::string basis_sentence(const RunComparison& runs) {
    const std::string a = basis_words(runs.a), b = basis_words(runs.b);
    if (a.empty() && b.empty()) return {};
    if (a == b) return "Heights of both " + a + ".";
    if (!a.empty() && !b.empty()) return "Heights of A " + a + "; those of B " + b + ".";
    const bool is_a = b.empty();
    return std::string("Heights of ") + (is_a ? "A " : "B ") + (is_a ? a : b) + "; those of " + (is_a ? "B" : "A") +
           " are not, so that a part of each difference in height comes from that.";
}

std::string ground_words(const ComparedRun& run, const char* letter) {
    const std::size_t known = frames_over_known_ground(run);
    return (known == 0 ? "none of " + std::to_string(run.frames.size()) : part_of(known, run.frames.size())) + " frames of " +
           letter;
}

/// Without the whole, a closest point reads as that of the whole flight.
std::string known_ground_sentence(const RunComparison& runs) {
    const std::size_t a = frames_over_known_ground(runs.a), b = frames_over_known_ground(runs.b);
    if ((a == runs.a.frames.size() && b == runs.b.frames.size()) || a + b == 0) return {};
    return "The ground below is known in " + ground_words(runs.a, "A") + " and " + ground_words(runs.b, "B") +
           ": heights above it, distances to it and closest points are of these alone.";
}

}  // namespace

std::size_t frames_by_pressure(const ComparedRun& run) {
    return static_cast<std::size_t>(std::count_if(run.frames.begin(), run.frames.end(),
                                                  [](const ComparedFrame& frame) { return frame.has_pressure_height; }));
}

std::size_t frames_over_known_ground(const ComparedRun& run) {
    return static_cast<std::size_t>(std::count_if(run.frames.begin(), run.frames.end(), [](const ComparedFrame& frame) {
        return std::isfinite(frame.values[kHeightAboveTerrain]);
    }));
}

std::vector<std::string> height_sentences(const RunComparison& runs) {
    std::vector<std::string> sentences;
    for (const std::string& sentence : {basis_sentence(runs), known_ground_sentence(runs)})
        if (!sentence.empty()) sentences.push_back(sentence);
    return sentences;
}

}  // namespace tedavis::host_sim
