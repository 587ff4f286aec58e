#include "host_sim/importers/fix_cleaner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kSpeedQuantile = 0.98;
constexpr double kSpeedFactor = 1.6;
constexpr double kSpeedMargin_mps = 20.0;
constexpr double kFastest_mps = 500.0;
constexpr double kPositionMargin_m = 60.0;
constexpr std::size_t kBelievedInARow = 5;
constexpr std::ptrdiff_t kMedianReach = 4;
constexpr double kHeightMargin_m = 40.0;
constexpr double kHeightMargin_mps = 8.0;

double distance_m(const RecordedFix& a, const RecordedFix& b) {
    return earth::surface_distance_m({a.latitude_rad, a.longitude_rad, {}}, {b.latitude_rad, b.longitude_rad, {}});
}

double seconds_between(const RecordedFix& a, const RecordedFix& b) { return (b.time - a.time).to_seconds(); }

void sort_and_drop_duplicates(std::vector<RecordedFix>& fixes, CleaningCounts& counts) {
    for (std::size_t i = 1; i < fixes.size(); ++i) counts.out_of_order += fixes[i].time < fixes[i - 1].time ? 1 : 0;
    std::stable_sort(fixes.begin(), fixes.end(), [](const RecordedFix& a, const RecordedFix& b) { return a.time < b.time; });
    const auto end =
        std::unique(fixes.begin(), fixes.end(), [](const RecordedFix& a, const RecordedFix& b) { return a.time == b.time; });
    counts.duplicates = static_cast<std::size_t>(fixes.end() - end);
    fixes.erase(end, fixes.end());
}

double speed_limit_mps(const std::vector<RecordedFix>& fixes) {
    std::vector<double> speeds;
    for (std::size_t i = 1; i < fixes.size(); ++i)
        speeds.push_back(distance_m(fixes[i - 1], fixes[i]) / seconds_between(fixes[i - 1], fixes[i]));
    if (speeds.empty()) return kFastest_mps;
    const auto place = speeds.begin() + static_cast<std::ptrdiff_t>(kSpeedQuantile * static_cast<double>(speeds.size() - 1));
    std::nth_element(speeds.begin(), place, speeds.end());
    return std::min(kFastest_mps, kSpeedFactor * *place + kSpeedMargin_mps);
}

bool within_reach(const RecordedFix& from, const RecordedFix& to, double limit_mps) {
    return distance_m(from, to) <= limit_mps * seconds_between(from, to) + kPositionMargin_m;
}

/// Jumps wait in `doubted` until one fix fits the last good one again (they were jumps) or enough agree (it moved).
void drop_position_jumps(std::vector<RecordedFix>& fixes, CleaningCounts& counts) {
    const double limit_mps = speed_limit_mps(fixes);
    std::vector<RecordedFix> kept, doubted;
    for (const RecordedFix& fix : fixes) {
        if (kept.empty() || within_reach(kept.back(), fix, limit_mps)) {
            counts.position_jumps += doubted.size();
            doubted.clear();
            kept.push_back(fix);
            continue;
        }
        if (!doubted.empty() && !within_reach(doubted.back(), fix, limit_mps)) {
            counts.position_jumps += doubted.size();
            doubted.clear();
        }
        doubted.push_back(fix);
        if (doubted.size() == kBelievedInARow) {
            kept.insert(kept.end(), doubted.begin(), doubted.end());
            doubted.clear();
        }
    }
    counts.position_jumps += doubted.size();
    fixes = std::move(kept);
}

using HeightMember = std::optional<double> RecordedFix::*;

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

struct TimedHeight {
    double time_s = 0, height_m = 0;
};

/// Off the line through the neighbourhood that a third of wild values cannot turn (Theil 1950, Sen 1968: the median of
/// all slopes), so that a steady climb goes on through a pause of the recording.
double off_line_m(const std::vector<TimedHeight>& near, const TimedHeight& asked) {
    std::vector<double> slopes, heights;
    for (std::size_t a = 0; a < near.size(); ++a)
        for (std::size_t b = a + 1; b < near.size(); ++b)
            slopes.push_back((near[b].height_m - near[a].height_m) / (near[b].time_s - near[a].time_s));
    const double slope_mps = median(std::move(slopes));
    for (const TimedHeight& known : near) heights.push_back(known.height_m + slope_mps * (asked.time_s - known.time_s));
    return asked.height_m - median(std::move(heights));
}

bool is_outlier(const std::vector<RecordedFix>& fixes, std::ptrdiff_t i, HeightMember height) {
    const auto fix = [&fixes](std::ptrdiff_t k) -> const RecordedFix& { return fixes[static_cast<std::size_t>(k)]; };
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, i - kMedianReach);
    const std::ptrdiff_t last = std::min(static_cast<std::ptrdiff_t>(fixes.size()) - 1, i + kMedianReach);
    std::vector<TimedHeight> near;
    for (std::ptrdiff_t k = first; k <= last; ++k)
        if (fix(k).*height) near.push_back({seconds_between(fix(first), fix(k)), *(fix(k).*height)});
    if (near.size() < 3) return false;
    const double interval_s = seconds_between(fix(first), fix(last)) / static_cast<double>(last - first);
    const TimedHeight asked{seconds_between(fix(first), fix(i)), *(fix(i).*height)};
    return std::abs(off_line_m(near, asked)) > kHeightMargin_m + kHeightMargin_mps * interval_s;
}

std::size_t empty_height_outliers(std::vector<RecordedFix>& fixes, HeightMember height) {
    std::vector<std::size_t> outliers;
    for (std::size_t i = 0; i < fixes.size(); ++i) {
        if ((fixes[i].*height).has_value() && is_outlier(fixes, static_cast<std::ptrdiff_t>(i), height)) outliers.push_back(i);
    }
    for (const std::size_t i : outliers) (fixes[i].*height).reset();
    return outliers.size();
}

}  // namespace

CleaningCounts clean_fixes(RecordedFlight& flight) {
    CleaningCounts counts;
    sort_and_drop_duplicates(flight.fixes, counts);
    drop_position_jumps(flight.fixes, counts);
    counts.gnss_height_jumps = empty_height_outliers(flight.fixes, &RecordedFix::gnss_height_m);
    counts.pressure_jumps = empty_height_outliers(flight.fixes, &RecordedFix::pressure_altitude_m);
    return counts;
}

}  // namespace tedavis::host_sim
