#include "render_core/base/valid_period.hpp"

namespace tedavis::base {

Currency currency_at(const ValidPeriod& period, Time utc) noexcept {
    if (period.begin && utc < *period.begin) return Currency::not_yet_valid;
    return period.end && utc >= *period.end ? Currency::expired : Currency::current;
}

}  // namespace tedavis::base
