/// Height of the surface at a place, or why there is none. Plain data.
#pragma once

#include <cstdint>

#include "render_core/earth/geodetic.hpp"

namespace tedavis::terrain {

enum class HeightStatus : std::uint8_t { land, sea, void_, outside, damaged };

struct HeightAnswer {
    HeightStatus status = HeightStatus::outside;
    earth::MslHeight height;            ///< valid for land and sea only
    earth::GeoidUndulation undulation;  ///< valid everywhere, clamped to the database's border
};

}  // namespace tedavis::terrain
