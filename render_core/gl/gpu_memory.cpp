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

}  // namespace tedavis::gl
