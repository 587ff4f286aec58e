#include "host_sim/commands/option_texts.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

#include "host_sim/number_list.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/tracing/traced_shot.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/utc_time.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::host_sim {

PictureSize size_from(const std::string& text) {
    const std::vector<double> n = parse_number_list(text, 'x');
    const auto is_edge = [](double pixels) { return pixels >= 16 && pixels <= 16384 && pixels == std::floor(pixels); };
    if (n.size() != 2 || !is_edge(n[0]) || !is_edge(n[1]))
        throw UserError("--size " + text + ": not WIDTHxHEIGHT of 16..16384 pixels, such as 1024x768");
    return {static_cast<std::uint32_t>(n[0]), static_cast<std::uint32_t>(n[1])};
}

AircraftPose pose_from(const std::string& text) {
    constexpr double kLimits[] = {90, 360, 100'000, 360, 90, 180};
    const std::vector<double> n = parse_number_list(text, ',');
    bool sane = n.size() == std::size(kLimits);
    for (std::size_t i = 0; sane && i < n.size(); ++i) sane = std::abs(n[i]) <= kLimits[i];
    if (!sane)
        throw UserError("--pose " + text +
                        ": not lat,lon,alt_m,heading,pitch,roll in degrees and metres above sea level; write for "
                        "instance 46.98,10.02,3500,90,0,0");
    return {n[0], n[1], n[2], n[3], n[4], n[5]};
}

SweptPlace place_from(const std::string& text) {
    constexpr double kLimits[] = {90, 360, 100'000};
    const std::vector<double> n = parse_number_list(text, ',');
    bool sane = n.size() == 2 || n.size() == 3;
    for (std::size_t i = 0; sane && i < n.size() && i < std::size(kLimits); ++i) sane = std::abs(n[i]) <= kLimits[i];
    if (!sane)
        throw UserError("--around " + text +
                        ": not lat,lon or lat,lon,alt_m in degrees and metres above sea level; write for instance 36.6,-84.25");
    SweptPlace place{n[0], n[1], {}};
    if (n.size() == 3) place.altitude_msl_m = n[2];
    return place;
}

std::vector<double> metres_from(const std::string& option, const std::string& text, double least_m, double most_m) {
    std::vector<double> n = parse_number_list(text, ',');
    const bool is_sane = !n.empty() && n.size() <= SweepRings::kMaxSteps &&
                         std::all_of(n.begin(), n.end(), [&](double metres) { return metres >= least_m && metres <= most_m; });
    if (!is_sane)
        throw UserError(option + " " + text + ": not 1 to " + std::to_string(SweepRings::kMaxSteps) + " numbers of " +
                        decimal(least_m, 0) + " to " + decimal(most_m, 0) + " m; write for instance 2000,5000");
    return n;
}

perception::CannySettings canny_from(const std::string& text) {
    const std::vector<double> n = parse_number_list(text, ',');
    perception::CannySettings canny;
    if (n.size() == 3) canny = {n[0], n[1], n[2]};
    if (n.size() != 3 || !canny.is_valid())
        throw UserError("--canny " + text +
                        ": not sigma,low,high: sigma 0 to 3 px, and thresholds on the gradient, low not above high; write for "
                        "instance 1,70,170");
    return canny;
}

std::string phase_from(const std::string& name) {
    if (!flight::phase_from_name(name).ok)
        throw UserError("--phase " + name + ": no such phase; say for example takeoff.first_climb or cruise");
    return name;
}

raytrace::SearchSettings search_from(const std::string& text) {
    using raytrace::SearchKind;
    const std::string name = text.substr(0, text.find(':'));
    std::optional<raytrace::SearchSettings> search;
    for (const SearchKind kind : {SearchKind::exact, SearchKind::cells, SearchKind::ray, SearchKind::cones})
        if (name == to_string(kind)) search = raytrace::usual_search(kind);
    std::vector<double> n;
    if (name.size() < text.size()) n = parse_number_list(text.substr(name.size() + 1), ':');
    const auto is_whole = [](double value, double least, double most) {
        return value >= least && value <= most && value == std::floor(value);
    };
    bool is_sane = search && (name.size() == text.size() || (!search->is_exact() && !n.empty() && n.size() <= 2));
    if (is_sane && !n.empty()) is_sane = is_whole(n[0], 1, raytrace::SearchSettings::kMaxSteps);
    if (is_sane && n.size() == 2) is_sane = is_whole(n[1], 0, raytrace::UniformSearch::kMaxHalvings);
    if (!is_sane)
        throw UserError("--search " + text +
                        ": not exact, cells, ray or cones, the last three with up to 65536 steps and 24 halvings; write for "
                        "instance ray:1024:12");
    if (!n.empty()) search->steps = static_cast<std::uint32_t>(n[0]);
    if (n.size() == 2) search->halvings = static_cast<std::uint32_t>(n[1]);
    return *search;
}

base::Time time_from(const std::string& text) {
    base::Time time;
    if (!base::parse_utc(text, time))
        throw UserError("--time " + text + ": not an instant of UTC; write for instance 2026-06-01T14:00:00Z");
    return time;
}

}  // namespace tedavis::host_sim
