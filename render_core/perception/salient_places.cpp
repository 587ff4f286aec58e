#include "render_core/perception/salient_places.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::perception {
namespace {

class PlaceSearch {
public:
    PlaceSearch(const SaliencyMap& map, double radius_px, PlaceMask mask)
        : map_(map), mask_(mask), cell_px_(1 << map.level), radius_px_(radius_px) {}

    /// False where nothing is left.
    [[nodiscard]] bool find(const SalientPlaces& before, SalientPlace& best) const {
        best.value = 0;
        for (int row = 0; row < map_.height; ++row) search_row(row, before, best);
        return best.value > 0;
    }

private:
    [[nodiscard]] double middle(int cell) const { return (cell + 0.5) * cell_px_; }
    void search_row(int row, const SalientPlaces& before, SalientPlace& best) const {
        const std::size_t first = pixels_of(map_.width, row);
        for (int column = 0; column < map_.width; ++column) {
            const std::size_t at = first + static_cast<std::size_t>(column);
            const float value = map_.values[at];
            if (!(value > best.value) || (!mask_.empty() && mask_[at] == 0)) continue;
            const SalientPlace place{middle(column), middle(row), value};
            if (!is_inhibited(place, before)) best = place;
        }
    }
    [[nodiscard]] bool is_inhibited(const SalientPlace& place, const SalientPlaces& before) const {
        return std::any_of(before.begin(), before.end(), [&](const SalientPlace& winner) {
            return std::hypot(place.x - winner.x, place.y - winner.y) <= radius_px_;
        });
    }

    const SaliencyMap& map_;
    PlaceMask mask_;
    double cell_px_, radius_px_;
};

}  // namespace

SalientPlaces salient_places(const SaliencyMap& map, double radius_px, std::size_t most, PlaceMask mask) noexcept {
    SalientPlaces places;
    if (!mask.empty() && mask.size() < map.values.size()) return places;
    const PlaceSearch search(map, radius_px, mask);
    SalientPlace next;
    for (std::size_t n = 0; n < std::min(most, kMaxSalientPlaces) && search.find(places, next); ++n)
        static_cast<void>(places.try_push_back(next));
    return places;
}

}  // namespace tedavis::perception
