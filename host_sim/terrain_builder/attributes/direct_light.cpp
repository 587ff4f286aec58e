#include "host_sim/terrain_builder/attributes/direct_light.hpp"

#include <cmath>

#include "host_sim/terrain_builder/attributes/row_directions.hpp"
#include "render_core/base/check.hpp"

namespace tedavis::host_sim {
namespace {

class Beam {
public:
    explicit Beam(const FixedLight& light)
        : east_(static_cast<float>(std::cos(light.elevation_rad) * std::sin(light.azimuth_rad))),
          north_(static_cast<float>(std::cos(light.elevation_rad) * std::cos(light.azimuth_rad))),
          along_(static_cast<float>(std::cos(light.elevation_rad))),
          up_(static_cast<float>(std::sin(light.elevation_rad))),
          per_disc_(static_cast<float>(0.5 / light.disc_radius_rad)) {
        TEDAVIS_CHECK(light.elevation_rad > 0 && light.elevation_rad <= base::kPi / 2 && light.disc_radius_rad > 0);
    }

    [[nodiscard]] float on_level_ground() const { return up_; }
    /// `horizon` is the tangent of its elevation, not below 0.
    [[nodiscard]] Lanes on(const NormalLanes& normal, Lanes horizon) const {
        const Lanes cosine = (normal.east * east_ + normal.north * north_) + normal.up * up_;
        const Lanes sine_above = (up_ - along_ * horizon) / root(1.0f + horizon * horizon);
        return clamped(cosine) * clamped(0.5f + sine_above * per_disc_);
    }

private:
    static Lanes clamped(Lanes part) { return smaller(larger(part, all(0.0f)), all(1.0f)); }

    const float east_, north_, along_, up_, per_disc_;
};

/// Tangent of the horizon's elevation in one direction, not below 0.
Lanes horizon(const HeightPlanes& planes, const SamplePlaces& places, const RowDirection& direction, std::size_t at, Lanes far) {
    const Lanes height_m = load(&planes.high[at_post][at]);
    Lanes highest = larger(far, all(0.0f));
    for (std::size_t s = 1; s <= kHorizonReach; ++s) {
        const float* const sample = planes.high[places[s].plane].data() + at + places[s].offset;
        highest = larger(highest, (load(sample) - height_m) * direction.per_m[s] - direction.drop[s]);
    }
    return highest;
}

/// At the light's azimuth, between the two directions beside it, for one row of posts.
class LightHorizon {
public:
    LightHorizon(const HeightPlanes& planes, const std::array<SamplePlaces, terrain::kHorizonDirections>& places, int row,
                 double azimuth_rad)
        : planes_(planes),
          places_(places),
          directions_(row_directions(planes.east_m(row), planes.tile.north_m)),
          bracket_(terrain::bracket_azimuth(azimuth_rad, planes.east_m(row), planes.tile.north_m)) {}

    [[nodiscard]] Lanes at(std::size_t at, const FarRow& far, std::size_t index) const {
        const auto weight = static_cast<float>(bracket_.weight);
        return in(bracket_.first, at, far, index) * (1 - weight) + in(bracket_.second, at, far, index) * weight;
    }

private:
    [[nodiscard]] Lanes in(int direction, std::size_t at, const FarRow& far, std::size_t index) const {
        const auto k = static_cast<std::size_t>(direction);
        return horizon(planes_, places_[k], directions_[k], at, far.tangent(direction, index, load(&planes_.high[at_post][at])));
    }

    const HeightPlanes& planes_;
    const std::array<SamplePlaces, terrain::kHorizonDirections>& places_;
    const std::array<RowDirection, terrain::kHorizonDirections> directions_;
    const terrain::HorizonBracket bracket_;
};

}  // namespace

HalfPlanes direct_light(const HeightPlanes& planes, const Gradients& gradients, const FixedLight& light, const FarView& above) {
    const Beam beam(light);
    const auto places = sample_places(planes.stride);
    const AttributeTile& tile = planes.tile;
    HalfPlanes result;
    result[at_post].assign(planes.validity.size(), beam.on_level_ground());
    FarRow far(above, -kHorizonReach, tile.columns + 2 * kHorizonReach);
    for (int row = -kHorizonReach; row < tile.rows + kHorizonReach; ++row) {
        far.read(row);
        const LightHorizon horizons(planes, places, row, light.azimuth_rad);
        const int columns = tile.columns + 2 * kHorizonReach;
        for (int index = 0; index < columns; index += kLanes) {
            const std::size_t at = planes.at(index - kHorizonReach, row);
            const NormalLanes normal = normal_of(load(&gradients.east[at]), load(&gradients.north[at]));
            const Lanes lit = beam.on(normal, horizons.at(at, far, static_cast<std::size_t>(index)));
            store(&result[at_post][at], load(&planes.validity[at]) > 0.0f ? lit : all(beam.on_level_ground()));
        }
    }
    fill_half_posts(result, planes.validity, planes.stride);
    return result;
}

}  // namespace tedavis::host_sim
