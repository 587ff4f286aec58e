#include "host_sim/terrain_builder/attributes/far_horizons.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/terrain_builder/attributes/row_directions.hpp"

namespace tedavis::host_sim {
namespace {

using terrain::kHorizonDirections;

/// The two posts of the level above round a place, and the part of the second.
struct Between {
    int first, second;
    float part;
};

Between between(double place, int posts) {
    const double low = std::floor(place);
    const int last = posts - 1 + kFarMargin;
    const auto clamped = [last](double post) { return static_cast<int>(std::clamp<double>(post, -kFarMargin, last)); };
    return {clamped(low), clamped(low + 1), static_cast<float>(place - low)};
}

struct FarLanes {
    Lanes intercept, per_m;
};

/// The highest of the samples between kFarNearEnd and kHorizonReach, and of what was seen beyond.
FarLanes sweep(const HeightPlanes& planes, const SamplePlaces& places, const RowDirection& direction, std::size_t at,
               FarLanes beyond) {
    const Lanes height_m = load(&planes.high[at_post][at]);
    Lanes highest = beyond.intercept - beyond.per_m * height_m, per_m = beyond.per_m;
    for (std::size_t s = kFarNearEnd; s <= kHorizonReach; ++s) {
        const float* const sample = planes.high[places[s].plane].data() + at + places[s].offset;
        const Lanes tangent = (load(sample) - height_m) * direction.per_m[s] - direction.drop[s];
        per_m = tangent > highest ? all(direction.per_m[s]) : per_m;
        highest = larger(tangent, highest);
    }
    const Lanes intercept = highest + per_m * height_m;
    const auto seen = highest > 0.5f * kNoHorizon * direction.per_m[kHorizonReach];
    return {seen ? intercept : all(kNoHorizon), seen ? per_m : all(0.0f)};
}

}  // namespace

FarRow::FarRow(const FarView& view, int first_column, int columns)
    : view_(view), count_(static_cast<std::size_t>(columns + kLanes - 1)) {
    values_.assign(2 * kHorizonDirections * count_, 0.0f);
    std::fill_n(values_.begin(), kHorizonDirections * count_, kNoHorizon);
    if (view.horizons == nullptr) return;
    for (std::size_t n = 0; n < count_; ++n) {
        const double place = view.first_column + 0.5 * (first_column + static_cast<int>(n));
        const Between columns_round = between(place, view.horizons->columns);
        columns_.push_back({columns_round.first, columns_round.second, columns_round.part});
    }
}

void FarRow::read(int row) {
    if (view_.horizons == nullptr) return;
    const FarHorizons& far = *view_.horizons;
    const Between rows = between(view_.first_row + 0.5 * row, far.rows);
    for (std::size_t n = 0; n < count_; ++n) {
        const Column& c = columns_[n];
        const std::array<std::size_t, 4> corners = {far.at(c.west, rows.first), far.at(c.east, rows.second),
                                                    far.at(c.east, rows.first), far.at(c.west, rows.second)};
        std::array<float, 4> weights = {(1 - c.part) * (1 - rows.part), c.part * rows.part, c.part * (1 - rows.part),
                                        (1 - c.part) * rows.part};
        for (std::size_t i = 0; i < 4; ++i) weights[i] *= far.known[corners[i]];
        mix(n, corners, weights);
    }
}

// Opposite corners are added first: a tile turned by a right angle gives the same bits.
void FarRow::mix(std::size_t index, const std::array<std::size_t, 4>& corners, const std::array<float, 4>& weights) {
    const float total = (weights[0] + weights[1]) + (weights[2] + weights[3]);
    const float scale = total > 0 ? 1 / total : 0.0f, nothing = total > 0 ? 0.0f : kNoHorizon;
    const FarLines* const lines[4] = {&view_.horizons->lines[corners[0]], &view_.horizons->lines[corners[1]],
                                      &view_.horizons->lines[corners[2]], &view_.horizons->lines[corners[3]]};
    const auto mixed = [&](auto part) {
        return ((part(*lines[0]) * weights[0] + part(*lines[1]) * weights[1]) +
                (part(*lines[2]) * weights[2] + part(*lines[3]) * weights[3])) *
               scale;
    };
    for (std::size_t k = 0; k < kHorizonDirections; k += kLanes) {
        const Lanes intercepts = mixed([k](const FarLines& l) { return load(&l.intercept[k]); }) + nothing;
        const Lanes per_m = mixed([k](const FarLines& l) { return load(&l.per_m[k]); });
        for (std::size_t n = 0; n < kLanes; ++n) {
            values_[(k + n) * count_ + index] = intercepts[static_cast<int>(n)];
            values_[(kHorizonDirections + k + n) * count_ + index] = per_m[static_cast<int>(n)];
        }
    }
}

Lanes FarRow::tangent(int direction, std::size_t index, Lanes height_m) const {
    return intercept(direction, index) - per_m(direction, index) * height_m;
}

namespace {

/// Writes four posts' lines, as many of them as are in the row.
class LineWriter {
public:
    LineWriter(FarHorizons& far, const HeightPlanes& planes, const FarRow& beyond)
        : far_(far), planes_(planes), places_(sample_places(planes.stride)), beyond_(beyond) {}

    void begin_row(int row) {
        row_ = row;
        directions_ = row_directions(planes_.east_m(row), planes_.tile.north_m);
    }
    void write(int column) {
        const std::size_t at = planes_.at(column, row_), to = far_.at(column, row_), index = to - far_.at(-kFarMargin, row_);
        const auto lanes = static_cast<std::size_t>(std::min(kLanes, far_.columns + kFarMargin - column));
        std::copy_n(&planes_.validity[at], lanes, &far_.known[to]);
        for (int k = 0; k < kHorizonDirections; ++k) {
            const auto direction = static_cast<std::size_t>(k);
            const FarLanes lines = sweep(planes_, places_[direction], directions_[direction], at,
                                         {beyond_.intercept(k, index), beyond_.per_m(k, index)});
            for (std::size_t n = 0; n < lanes; ++n) {
                far_.lines[to + n].intercept[direction] = lines.intercept[n];
                far_.lines[to + n].per_m[direction] = lines.per_m[n];
            }
        }
    }

private:
    FarHorizons& far_;
    const HeightPlanes& planes_;
    const std::array<SamplePlaces, kHorizonDirections> places_;
    std::array<RowDirection, kHorizonDirections> directions_{};
    const FarRow& beyond_;
    int row_ = 0;
};

}  // namespace

FarHorizons make_far_horizons(const HeightPlanes& planes, const FarView& above) {
    FarHorizons far;
    far.columns = planes.tile.columns;
    far.rows = planes.tile.rows;
    const int columns = far.columns + 2 * kFarMargin;
    far.lines.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(far.rows + 2 * kFarMargin));
    far.known.resize(far.lines.size());
    FarRow beyond(above, -kFarMargin, columns);
    LineWriter writer(far, planes, beyond);
    for (int row = -kFarMargin; row < far.rows + kFarMargin; ++row) {
        beyond.read(row);
        writer.begin_row(row);
        for (int column = -kFarMargin; column < far.columns + kFarMargin; column += kLanes) writer.write(column);
    }
    return far;
}

}  // namespace tedavis::host_sim
