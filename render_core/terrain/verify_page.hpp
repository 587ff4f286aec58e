/// Reads what a page of a database's directory names, as a display would in the course of a flight.
///
/// Memory  the room it is given. Thread  any, each with a room of its own.
#pragma once

#include <algorithm>

#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::terrain {

/// For one page, and one part after the other.
struct VerifyRoom {
    DirectoryPage page;
    alignas(ChunkVertex) std::uint8_t part[std::max({kMaxPayloadBytes, sizeof(AttributePage), sizeof(DrapePage)})];
};

/// Every checksum, entry and vertex of the page and of its chunks. Adds their number to `chunks`; a page that does not exist has
/// none. The first fault, if there is one.
[[nodiscard]] TdbFailure verify_page(const TerrainDatabase& database, std::uint32_t page_index, VerifyRoom& room,
                                     std::uint64_t& chunks);

}  // namespace tedavis::terrain
