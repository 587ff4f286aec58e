#include "render_core/terrain/kept_heights.hpp"

#include "render_core/base/hash.hpp"

namespace tedavis::terrain {

bool KeptHeights::start(base::Arena& arena) {
    kept_ = arena.allocate_array<Kept>(kSets * kWays);
    return !kept_.empty();
}

base::Span<KeptHeights::Kept> KeptHeights::set_of(double latitude_rad, double longitude_rad) const {
    base::Fnv1a64 hash;
    hash.add(&latitude_rad, sizeof latitude_rad);
    hash.add(&longitude_rad, sizeof longitude_rad);
    return kept_.subspan(hash.value() % kSets * kWays, kWays);
}

const HeightAnswer* KeptHeights::find(double latitude_rad, double longitude_rad) {
    for (Kept& kept : set_of(latitude_rad, longitude_rad)) {
        if (kept.asked == 0 || kept.latitude_rad != latitude_rad || kept.longitude_rad != longitude_rad) continue;
        kept.asked = ++asked_;
        return &kept.answer;
    }
    return nullptr;
}

void KeptHeights::keep(double latitude_rad, double longitude_rad, const HeightAnswer& answer) {
    const base::Span<Kept> set = set_of(latitude_rad, longitude_rad);
    Kept* oldest = &set[0];
    for (Kept& kept : set)
        if (kept.asked < oldest->asked) oldest = &kept;
    *oldest = {latitude_rad, longitude_rad, answer, ++asked_};
}

}  // namespace tedavis::terrain
