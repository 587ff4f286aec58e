#include "host_sim/evaluation/order_agreement.hpp"

namespace tedavis::host_sim {

OrderAgreement order_agreement(const std::vector<double>& first, const std::vector<double>& second) {
    OrderAgreement agreement;
    for (std::size_t a = 0; a < first.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            if (first[a] == first[b]) continue;
            ++agreement.pairs;
            const bool rises = first[a] > first[b];
            agreement.alike += rises ? (second[a] > second[b] ? 1 : 0) : (second[a] < second[b] ? 1 : 0);
        }
    }
    return agreement;
}

}  // namespace tedavis::host_sim
