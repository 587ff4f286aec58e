#include "render_core/policy/obstacle_alerts.hpp"

#include <cmath>
#include <utility>

#include "render_core/policy/terrain_ahead.hpp"

namespace tedavis::policy {

void ObstacleAlerts::add(std::uint16_t layer, std::uint32_t feature, double on_track_s, double straight_s) {
    const double counts_s = counted_s(on_track_s, straight_s);
    if (!(counts_s <= kTerrainCaution_s)) return;
    ++count_;
    const bool is_straight = counts_s < on_track_s;
    const auto tenths = static_cast<std::uint16_t>(10 * std::fmax(is_straight ? straight_s : on_track_s, 0));
    const std::uint16_t mark = is_straight ? AlertedObstacle::kStraightAhead : 0;
    const AlertedObstacle one{feature, layer, static_cast<std::uint16_t>(tenths | mark)};
    if (all_.full()) {
        if (!(one.counted_s() < all_.back().counted_s())) return;
        all_.pop_back();
    }
    static_cast<void>(all_.try_push_back(one));
    for (std::size_t n = all_.size() - 1; n > 0 && all_[n].counted_s() < all_[n - 1].counted_s(); --n)
        std::swap(all_[n], all_[n - 1]);
}

TerrainAhead ObstacleAlerts::level() const { return all_.empty() ? TerrainAhead::none : all_[0].level(); }

TerrainAhead ObstacleAlerts::of(std::uint16_t layer, std::uint32_t feature) const {
    for (const AlertedObstacle& one : all_)
        if (one.layer == layer && one.feature == feature) return one.level();
    return TerrainAhead::none;
}

/// A sum, so that the order of their times does not count.
std::uint64_t ObstacleAlerts::key() const {
    std::uint64_t key = 0;
    for (const AlertedObstacle& one : all_) {
        const std::uint64_t place = std::uint64_t{one.layer} << 34 | std::uint64_t{one.feature} << 2 | std::uint64_t(one.level());
        const std::uint64_t mixed = (place + 1) * 0x9E37'79B9'7F4A'7C15u;
        key += mixed ^ mixed >> 29;
    }
    return key;
}

}  // namespace tedavis::policy
