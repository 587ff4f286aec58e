/// Interface to heights at halved resolutions over a whole database, from which attribute maps are made.
#pragma once

#include <cstdint>

#include "host_sim/terrain_builder/lattice_window.hpp"

namespace tedavis::host_sim {

/// Posts of level m are 2^m posts apart. Unknown heights of levels above 0 are NaN; the post's class states how it is drawn.
class HeightLevels {
public:
    virtual ~HeightLevels() = default;
    [[nodiscard]] virtual std::uint32_t level_count() const = 0;
    /// Posts of a level across and down.
    [[nodiscard]] virtual std::uint32_t columns(std::uint32_t level) const = 0;
    [[nodiscard]] virtual std::uint32_t rows(std::uint32_t level) const = 0;
    virtual void read(std::uint32_t level, LatticeWindow& window) const = 0;
};

}  // namespace tedavis::host_sim
