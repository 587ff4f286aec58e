/// Reads and verifies everything that one directory page of a database names, as a display would in flight.
///
/// Memory  the caller's VerifyRoom. Thread  any, each with its own room.
#pragma once

#include <algorithm>

#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::terrain {

/// Memory for one page and one part at a time.
struct VerifyRoom {
    DirectoryPage page;
    alignas(ChunkVertex) std::uint8_t part[std::max({kMaxPayloadBytes, sizeof(AttributePage), sizeof(DrapePage)})];
};

/// Verifies every checksum, entry and vertex of the page and of its chunks, and adds the number of chunks to `chunks`; a page
/// that does not exist has none. Returns the first fault, if any.
[[nodiscard]] TdbFailure verify_page(const TerrainDatabase& database, std::uint32_t page_index, VerifyRoom& room,
                                     std::uint64_t& chunks);

}  // namespace tedavis::terrain
