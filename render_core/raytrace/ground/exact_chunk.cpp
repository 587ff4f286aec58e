#include "render_core/raytrace/ground/exact_chunk.hpp"

#include "render_core/terrain/chunk_payload.hpp"

namespace tedavis::raytrace {

terrain::TdbFailure read_exact_chunk(const terrain::TerrainDatabase& database, const terrain::ChunkEntry& entry,
                                     base::Span<std::uint8_t> payload) {
    const terrain::TdbFailure damaged{terrain::TdbError::chunk_damaged, entry.payload.offset};
    if ((entry.flags & terrain::kChunkRegular) == 0 || entry.payload.bytes > payload.size()) return damaged;
    const terrain::TdbFailure failure = database.read_part(entry.payload, payload);
    if (failure.error != terrain::TdbError::none) return failure;
    return payload_holds(database.lattice(), entry, payload) ? terrain::TdbFailure{} : damaged;
}

}  // namespace tedavis::raytrace
