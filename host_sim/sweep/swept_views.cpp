#include "host_sim/sweep/swept_views.hpp"

#include <algorithm>

namespace tedavis::host_sim {
namespace {

bool has_less_clutter(const SweptView& a, const SweptView& b) { return a.measures.clutter < b.measures.clutter; }

}  // namespace

const char* sight_name(PlaceSight sight) {
    switch (sight) {
        case PlaceSight::seen: return "seen";
        case PlaceSight::behind_terrain: return "behind terrain";
        case PlaceSight::outside_picture: break;
    }
    return "outside the picture";
}

std::size_t least_cluttered(const std::vector<SweptView>& views) {
    return static_cast<std::size_t>(std::min_element(views.begin(), views.end(), has_less_clutter) - views.begin());
}

std::size_t most_cluttered(const std::vector<SweptView>& views) {
    return static_cast<std::size_t>(std::max_element(views.begin(), views.end(), has_less_clutter) - views.begin());
}

std::optional<std::size_t> strongest_place(const std::vector<SweptView>& views) {
    std::optional<std::size_t> strongest;
    for (std::size_t n = 0; n < views.size(); ++n) {
        const bool is_stronger = !strongest || views[n].saliency.times_mean() > views[*strongest].saliency.times_mean();
        if (views[n].sight == PlaceSight::seen && is_stronger) strongest = n;
    }
    return strongest;
}

}  // namespace tedavis::host_sim
