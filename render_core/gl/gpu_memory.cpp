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

GlError over_budget(const base::BudgetLine& line, std::uint64_t needed) {
    GlError error = make_error("the budget line '", line.name.view(), "' has ");
    error.sentence.append(digits(line.bytes - line.use.in_use).view());
    error.sentence.append(" of ");
    error.sentence.append(digits(line.bytes).view());
    error.sentence.append(" bytes left and ");
    error.sentence.append(digits(needed).view());
    error.sentence.append(" are needed; raise the line in the device file");
    return error;
}

}  // namespace tedavis::gl
