#include "host_sim/terrain_builder/attributes/sky_sweep.hpp"

namespace tedavis::host_sim {
namespace {

using terrain::kHorizonDirections;

constexpr float kVanishing = 1e-8f;  // square of the length of a direction that is none

/// sin²H and H - sin H cos H of a limit at this tangent of elevation.
struct Limit {
    explicit Limit(Lanes tangent) {
        const Lanes square = 1.0f / (1.0f + tangent * tangent);
        deficit = tangent * tangent * square;
        level = (kHalfPi - arc_tangent(tangent)) - tangent * square;
    }
    /// Of a surface whose normal has the component `along` in the direction.
    [[nodiscard]] Lanes irradiance(Lanes up, Lanes along) const { return up * (1.0f - deficit) + along * level; }

    Lanes deficit;  ///< cos²H: what the limit takes from sin²H
    Lanes level;
};

/// The ground in view in one direction, from the post's tangent plane up, in strips that end at samples 1, 2, 4, 8 and 16.
struct Strips {
    /// At a post with these rises per metre to the east and to the north.
    Strips(Lanes rise_east, Lanes rise_north, const RowDirection& direction, Lanes own_light)
        : up(normal_of(rise_east, rise_north).up),
          highest(rise_east * direction.east + rise_north * direction.north),
          along(-highest * up),
          light(own_light),
          arriving(Limit(highest).irradiance(up, along)) {}

    void see(Lanes tangent, Lanes light_there) {
        light = tangent > highest ? light_there : light;
        highest = larger(highest, tangent);
    }
    [[nodiscard]] static constexpr bool end_at(std::size_t s) { return (s & (s - 1)) == 0; }
    void end() {
        const Lanes left = Limit(highest).irradiance(up, along);
        bounce += light * (arriving - left);
        arriving = left;
    }

    Lanes up;        ///< of the normal
    Lanes highest;   ///< tangent of what was seen, at first of the tangent plane
    Lanes along;     ///< of the normal, in this direction
    Lanes light;     ///< on the post that was highest
    Lanes arriving;  ///< from above what was seen, were it all sky
    Lanes bounce = all(0.0f);
};

/// Adds directions a right angle apart first, so that a tile turned by a right angle gives the same bits.
Lanes total(const Lanes (&parts)[kHorizonDirections]) {
    Lanes sum = all(0.0f);
    for (std::size_t k = 0; k < 4; ++k) sum += (parts[k] + parts[k + 8]) + (parts[k + 4] + parts[k + 12]);
    return sum;
}

}  // namespace

/// In one direction.
struct SkySweep::Found {
    Lanes horizon;  ///< tangent, not below 0
    Lanes limit;    ///< tangent: the horizon, or the tangent plane where that is higher
    Lanes above,
        below;  ///< largest and least tangent within the reach over a plane Earth; beyond any height where there is no post
    Lanes bounce;
};

/// Weighted values of all directions.
struct SkySweep::Sums {
    Lanes deficit[kHorizonDirections], level[kHorizonDirections], sine[kHorizonDirections], bounce[kHorizonDirections],
        above[kHorizonDirections], below[kHorizonDirections], known[kHorizonDirections];

    void add(std::size_t k, const Found& found, float weight, float no_post) {
        const Limit limit(found.limit);
        deficit[k] = limit.deficit * weight;
        level[k] = limit.level * weight;
        sine[k] = root(limit.deficit) * weight;
        bounce[k] = found.bounce * weight;
        const auto some = found.above > -no_post;
        known[k] = some ? all(weight) : all(0.0f);
        above[k] = some ? arc_tangent(found.above) * weight : all(0.0f);
        below[k] = some ? arc_tangent(found.below) * weight : all(0.0f);
    }
    /// Sum of `level` times the directions' unit vectors.
    [[nodiscard]] Lanes along(const std::array<RowDirection, kHorizonDirections>& d, float RowDirection::*part) const {
        Lanes sum = all(0.0f);
        for (std::size_t k = 0; k < 4; ++k)
            sum += (level[k] - level[k + 8]) * (d[k].*part) + (level[k + 4] - level[k + 12]) * (d[k + 4].*part);
        return sum;
    }
};

SkySweep::SkySweep(const HeightPlanes& planes, const Gradients& gradients, const HalfPlanes& direct, float level_light,
                   const FarView& above)
    : planes_(planes),
      gradients_(gradients),
      direct_(direct),
      level_light_(level_light),
      places_(sample_places(planes.stride)),
      directions_(),
      far_(above, 0, planes.tile.columns) {}

void SkySweep::begin_row(int row) {
    row_ = row;
    directions_ = row_directions(planes_.east_m(row), planes_.tile.north_m);
    far_.read(row);
}

SkySweep::Found SkySweep::look(std::size_t k, std::size_t at, std::size_t column) const {
    const RowDirection& direction = directions_[k];
    const Lanes height_m = load(&planes_.high[at_post][at]);
    Strips strips(load(&gradients_.east[at]), load(&gradients_.north[at]), direction, load(&direct_[at_post][at]));
    Lanes above = all(kNoHorizon), below = all(kNoHeight_m), near = all(0.0f);
    for (std::size_t s = 1; s <= kHorizonReach; ++s) {
        const SamplePlace place = places_[k][s];
        const std::size_t sample = at + static_cast<std::size_t>(place.offset);
        const Lanes high = (load(&planes_.high[place.plane][sample]) - height_m) * direction.per_m[s];
        const Lanes low = (load(&planes_.low[place.plane][sample]) - height_m) * direction.per_m[s];
        above = larger(above, high);
        below = smaller(below, low);
        const Lanes seen = high - direction.drop[s];
        near = larger(near, seen);
        strips.see(seen, load(&direct_[place.plane][sample]));
        if (Strips::end_at(s)) strips.end();
    }
    const Lanes far = far_.tangent(static_cast<int>(k), column, height_m);
    const Lanes horizon = larger(near, far), limit = larger(horizon, strips.highest);
    strips.see(limit, all(level_light_));
    strips.end();
    return {horizon, limit, above, below, strips.bounce};
}

void SkySweep::sweep(int column, SkyLanes& sky) const {
    const std::size_t at = planes_.at(column, row_);
    Sums sums;
    for (std::size_t k = 0; k < kHorizonDirections; ++k) {
        const Found found = look(k, at, static_cast<std::size_t>(column));
        sky.horizon[k] = found.horizon;
        // Halfway between any height and none, seen from the farthest sample.
        sums.add(k, found, directions_[k].weight, 0.5f * kNoHeight_m * directions_[k].per_m[kHorizonReach]);
    }
    const NormalLanes normal = normal_of(load(&gradients_.east[at]), load(&gradients_.north[at]));
    const Lanes east = sums.along(directions_, &RowDirection::east), north = sums.along(directions_, &RowDirection::north);
    const Lanes up = 1.0f - total(sums.deficit);
    const Lanes view = normal.up * up + (normal.east * east + normal.north * north);
    sky.sky_view = smaller(larger(view, all(0.0f)), all(1.0f));
    const Lanes square = up * up + (east * east + north * north), length = root(larger(square, all(kVanishing)));
    sky.aperture_east = square > kVanishing ? east / length : normal.east;
    sky.aperture_north = square > kVanishing ? north / length : normal.north;
    sky.aperture_cosine = smaller(total(sums.sine), all(1.0f));
    const Lanes known = total(sums.known), divisor = known > 0.0f ? known : all(1.0f);
    sky.openness_above = kHalfPi - total(sums.above) / divisor;
    sky.openness_below = kHalfPi + total(sums.below) / divisor;
    sky.bounce = larger(total(sums.bounce), all(0.0f));
}

}  // namespace tedavis::host_sim
