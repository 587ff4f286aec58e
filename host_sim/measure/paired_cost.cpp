#include "host_sim/measure/paired_cost.hpp"

namespace tedavis::host_sim {

effects::PairedCost paired_cost(const std::vector<double>& with_ms, const std::vector<double>& without_ms) {
    std::vector<double> room(with_ms.size());
    return effects::paired_cost({with_ms.data(), with_ms.size()}, {without_ms.data(), without_ms.size()}, room);
}

}  // namespace tedavis::host_sim
