/// Which solids cast shadows (solid_casters.hpp). Pure; any thread.
#pragma once

#include <cstdint>

#include "render_core/draw/data/solid_batch.hpp"

namespace tedavis::draw {

/// A bit a group.
struct CasterGroups {
    std::uint32_t all = 0, thin = 0;
};

/// True where a piece casts a shadow.
[[nodiscard]] bool casts_shadow(const SolidPiece& piece, const CasterGroups& groups);

}  // namespace tedavis::draw
