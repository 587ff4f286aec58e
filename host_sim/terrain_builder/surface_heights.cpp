#include "host_sim/terrain_builder/surface_heights.hpp"

#include <algorithm>
#include <vector>

namespace tedavis::host_sim {

void add_undulation(const BuildPlan& plan, LatticeWindow& window) {
    const PostUndulation undulation(plan.undulation, plan.lattice);
    const std::int64_t end = window.i0 + window.columns;
    window.surface_m.assign(window.height_m.size(), 0.0f);
    std::vector<double> row;
    for (std::int64_t j = std::max<std::int64_t>(window.j0, 0);
         j < std::min<std::int64_t>(window.j0 + window.rows, plan.header.rows); ++j) {
        undulation.row(window.i0, window.columns, static_cast<std::uint32_t>(j), row);
        for (std::int64_t i = window.i0; i < end; ++i) {
            const std::size_t n = window.at(i, j);
            if (window.post_class[n] == terrain::PostClass::outside) continue;
            window.surface_m[n] = static_cast<float>(double{window.height_m[n]} + row[static_cast<std::size_t>(i - window.i0)]);
        }
    }
}

}  // namespace tedavis::host_sim
