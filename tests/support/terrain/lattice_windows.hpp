/// Windows of posts to be read.
#pragma once

#include "host_sim/terrain_builder/lattice_window.hpp"

namespace tedavis::test_support {

[[nodiscard]] inline host_sim::LatticeWindow window_of(std::int64_t i, std::int64_t j, std::uint32_t columns,
                                                       std::uint32_t rows) {
    host_sim::LatticeWindow window;
    window.i0 = i;
    window.j0 = j;
    window.columns = columns;
    window.rows = rows;
    return window;
}

}  // namespace tedavis::test_support
