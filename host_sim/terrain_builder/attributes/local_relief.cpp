#include "host_sim/terrain_builder/attributes/local_relief.hpp"

#include <cmath>
#include <cstdint>

namespace tedavis::host_sim {
namespace {

constexpr float kStepsPerMetre = 1024;

struct Steps {
    explicit Steps(const AttributeTile& tile) : columns(static_cast<std::size_t>(tile.full_columns())) {
        height.reserve(tile.height_m.size());
        valid.reserve(tile.height_m.size());
        for (std::size_t n = 0; n < tile.height_m.size(); ++n) {
            const bool known = tile.post_class[n] <= terrain::PostClass::sea;
            height.push_back(known ? static_cast<std::int32_t>(std::floor(tile.height_m[n] * kStepsPerMetre + 0.5f)) : 0);
            valid.push_back(known ? 1 : 0);
        }
    }

    std::size_t columns;
    std::vector<std::int32_t> height, valid;
};

/// Sums over the rows of the square, one for each column of the tile and its apron.
class ColumnSums {
public:
    explicit ColumnSums(const Steps& steps) : height(steps.columns, 0), count(steps.columns, 0), steps_(steps) {}

    void add_row(int row, std::int32_t times) {
        const std::size_t first = static_cast<std::size_t>(row + kAttributeApron) * steps_.columns;
        for (std::size_t c = 0; c < steps_.columns; ++c) {
            height[c] += times * steps_.height[first + c];
            count[c] += times * steps_.valid[first + c];
        }
    }

    std::vector<std::int32_t> height, count;

private:
    const Steps& steps_;
};

void relief_of_row(const Steps& steps, const ColumnSums& sums, int row, std::vector<float>& relief_m) {
    const std::size_t first = static_cast<std::size_t>(row + kAttributeApron) * steps.columns;
    std::int64_t sum = 0, count = 0;
    for (std::size_t c = 0; c < 2 * kReliefReach; ++c) {
        sum += sums.height[c + kAttributeApron - kReliefReach];
        count += sums.count[c + kAttributeApron - kReliefReach];
    }
    for (std::size_t c = kAttributeApron; c + kAttributeApron < steps.columns; ++c) {
        sum += sums.height[c + kReliefReach];
        count += sums.count[c + kReliefReach];
        const std::int64_t excess = steps.height[first + c] * count - sum;
        const bool known = steps.valid[first + c] != 0;
        relief_m.push_back(known ? static_cast<float>(static_cast<double>(excess) / (kStepsPerMetre * static_cast<double>(count)))
                                 : 0.0f);
        sum -= sums.height[c - kReliefReach];
        count -= sums.count[c - kReliefReach];
    }
}

}  // namespace

std::vector<float> local_relief_m(const AttributeTile& tile) {
    const Steps steps(tile);
    ColumnSums sums(steps);
    std::vector<float> relief_m;
    relief_m.reserve(static_cast<std::size_t>(tile.columns) * static_cast<std::size_t>(tile.rows));
    for (int row = -kReliefReach; row < kReliefReach; ++row) sums.add_row(row, 1);
    for (int row = 0; row < tile.rows; ++row) {
        sums.add_row(row + kReliefReach, 1);
        relief_of_row(steps, sums, row, relief_m);
        sums.add_row(row - kReliefReach, -1);
    }
    return relief_m;
}

}  // namespace tedavis::host_sim
