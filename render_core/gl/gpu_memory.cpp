#include "render_core/gl/gpu_memory.hpp"

#include "render_core/base/check.hpp"

namespace tedavis::gl {

bool try_take(base::BudgetLine& line, std::uint64_t bytes) {
    if (bytes > line.bytes || line.use.in_use > line.bytes - bytes) {
        ++line.use.refused;
        return false;
    }
    line.use.take(bytes);
    return true;
}

void give_back(base::BudgetLine& line, std::uint64_t bytes) {
    TEDAVIS_CHECK(bytes <= line.use.in_use);
    line.use.in_use -= bytes;
}

base::Error over_budget(const base::BudgetLine& line, std::uint64_t needed) {
    base::Error error = base::make_error("the budget line '", line.name.view(), "' has ");
    error.message.append(base::digits(line.bytes - line.use.in_use).view());
    error.message.append(" of ");
    error.message.append(base::digits(line.bytes).view());
    error.message.append(" bytes left and ");
    error.message.append(base::digits(needed).view());
    error.message.append(" are needed; raise the line in the device file");
    return error;
}

}  // namespace tedavis::gl
