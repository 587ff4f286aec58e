#include "render_core/terrain/verify_page.hpp"

#include "render_core/terrain/chunk_payload.hpp"

namespace tedavis::terrain {
namespace {

TdbFailure verify_chunk(const TerrainDatabase& database, const ChunkEntry& entry, base::Span<std::uint8_t> room) {
    TdbFailure failure = database.read_part(entry.payload, room);
    if (failure.error == TdbError::none && !payload_holds(database.lattice(), entry, room))
        failure = {TdbError::chunk_damaged, entry.payload.offset};
    for (const PartPlace& place : {entry.attributes, entry.drape})
        if (failure.error == TdbError::none && place.bytes != 0) failure = database.read_part(place, room);
    return failure;
}

}  // namespace

TdbFailure verify_page(const TerrainDatabase& database, std::uint32_t page_index, VerifyRoom& room, std::uint64_t& chunks) {
    if (!database.has_page(page_index)) return {};
    if (const TdbFailure failure = database.read_page(page_index, room.page); failure.error != TdbError::none) return failure;
    for (const ChunkEntry& entry : room.page.entries) {
        if (entry.vertex_count == 0) continue;
        if (const TdbFailure failure = verify_chunk(database, entry, room.part); failure.error != TdbError::none) return failure;
        ++chunks;
    }
    return {};
}

}  // namespace tedavis::terrain
