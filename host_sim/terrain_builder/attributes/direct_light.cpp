#include "host_sim/terrain_builder/attributes/direct_light.hpp"

#include <cmath>

#include "host_sim/terrain_builder/attributes/row_directions.hpp"

namespace tedavis::host_sim {
namespace {

using terrain::HorizonBracket;

class Beam {
public:
    explicit Beam(const FixedLight& light)
        : east(static_cast<float>(std::cos(light.elevation_rad) * std::sin(light.azimuth_rad))),
          north(static_cast<float>(std::cos(light.elevation_rad) * std::cos(light.azimuth_rad))),
          up(static_cast<float>(std::sin(light.elevation_rad))),
          tangent_(static_cast<float>(std::tan(light.elevation_rad))),
          part_per_tangent_(
              static_cast<float>(std::cos(light.elevation_rad) * std::cos(light.elevation_rad) / (2 * light.disc_radius_rad))) {}

    [[nodiscard]] Lanes on(const NormalLanes& normal, Lanes horizon) const {
        const Lanes cosine = larger((normal.east * east + normal.north * north) + normal.up * up, all(0.0f));
        const Lanes part = 0.5f + (tangent_ - horizon) * part_per_tangent_;
        return smaller(cosine, all(1.0f)) * smaller(larger(part, all(0.0f)), all(1.0f));
    }

    const float east, north, up;

private:
    const float tangent_, part_per_tangent_;
};

Lanes horizon(const HeightPlanes& planes, const SamplePlaces& places, const RowDirection& direction, std::size_t at, Lanes far) {
    const Lanes height_m = load(&planes.high[at_post][at]);
    Lanes highest = larger(far, all(kNoHorizon));
    for (std::size_t s = 1; s <= kHorizonReach; ++s) {
        const float* const sample = planes.high[places[s].plane].data() + at + places[s].offset;
        highest = larger(highest, (load(sample) - height_m) * direction.per_m[s] - direction.drop[s]);
    }
    return highest;
}

}  // namespace

HalfPlanes direct_light(const HeightPlanes& planes, const Gradients& gradients, const FixedLight& light, const FarView& above) {
    const Beam beam(light);
    const auto places = sample_places(planes.stride);
    const AttributeTile& tile = planes.tile;
    HalfPlanes result;
    result[at_post].assign(planes.validity.size(), beam.up);
    FarRow far(above, -kHorizonReach, tile.columns + 2 * kHorizonReach);
    for (int row = -kHorizonReach; row < tile.rows + kHorizonReach; ++row) {
        far.read(row);
        const auto directions = row_directions(planes.east_m(row), tile.north_m);
        const HorizonBracket bracket = terrain::bracket_azimuth(light.azimuth_rad, planes.east_m(row), tile.north_m);
        const auto first = static_cast<std::size_t>(bracket.first), second = static_cast<std::size_t>(bracket.second);
        const auto weight = static_cast<float>(bracket.weight);
        for (int column = -kHorizonReach; column < tile.columns + kHorizonReach; column += kLanes) {
            const std::size_t at = planes.at(column, row), index = static_cast<std::size_t>(column + kHorizonReach);
            const Lanes height_m = load(&planes.high[at_post][at]);
            const Lanes a = horizon(planes, places[first], directions[first], at, far.tangent(bracket.first, index, height_m));
            const Lanes b = horizon(planes, places[second], directions[second], at, far.tangent(bracket.second, index, height_m));
            const Lanes lit =
                beam.on(normal_of(load(&gradients.east[at]), load(&gradients.north[at])), a * (1 - weight) + b * weight);
            store(&result[at_post][at], load(&planes.validity[at]) > 0.0f ? lit : all(beam.up));
        }
    }
    fill_half_posts(result, planes.validity, planes.stride);
    return result;
}

}  // namespace tedavis::host_sim
