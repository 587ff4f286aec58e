/// The threads of commands that measure pictures.
#pragma once

#include <cstdint>
#include <memory>

#include "render_core/base/ports/workers.hpp"

namespace tedavis::host_sim {

/// Starts `threads` threads; 0: as many as there are processors. Throws UserError.
[[nodiscard]] std::unique_ptr<base::Workers> evaluation_workers(std::uint32_t threads);

}  // namespace tedavis::host_sim
