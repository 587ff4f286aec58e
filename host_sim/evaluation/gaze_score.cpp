#include "host_sim/evaluation/gaze_score.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::host_sim {
namespace {

/// Of a value among sorted ones: how many lie below, half of the equal ones added.
double rank_among(const std::vector<float>& sorted, float value) {
    const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), value);
    return static_cast<double>(first - sorted.begin()) + 0.5 * static_cast<double>(last - first);
}

std::optional<double> nss_of(const std::vector<float>& map, const std::vector<float>& looked_at) {
    double sum = 0, squares = 0, at_gaze = 0;
    for (const float value : map) sum += static_cast<double>(value);
    const double mean = sum / static_cast<double>(map.size());
    for (const float value : map) squares += (static_cast<double>(value) - mean) * (static_cast<double>(value) - mean);
    const double deviation = std::sqrt(squares / static_cast<double>(map.size()));
    if (!(deviation > 1e-12)) return std::nullopt;
    for (const float value : looked_at) at_gaze += (static_cast<double>(value) - mean) / deviation;
    return at_gaze / static_cast<double>(looked_at.size());
}

}  // namespace

std::optional<GazeScore> gaze_score(const std::vector<float>& map, std::uint32_t width, const std::vector<GazePixel>& gaze) {
    std::vector<std::size_t> places;
    for (const GazePixel& pixel : gaze) places.push_back(std::size_t{pixel.y} * width + pixel.x);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    if (places.empty() || places.size() == map.size()) return std::nullopt;
    std::vector<float> looked_at, others;
    others.reserve(map.size());
    std::size_t next = 0;
    for (std::size_t n = 0; n < map.size(); ++n) {
        const bool is_gaze = next < places.size() && places[next] == n;
        (is_gaze ? looked_at : others).push_back(map[n]);
        if (is_gaze) ++next;
    }
    std::sort(others.begin(), others.end());
    double ranks = 0;
    for (const float value : looked_at) ranks += rank_among(others, value);
    const double pairs = static_cast<double>(looked_at.size()) * static_cast<double>(others.size());
    return GazeScore{static_cast<std::uint32_t>(places.size()), ranks / pairs, nss_of(map, looked_at)};
}

}  // namespace tedavis::host_sim
