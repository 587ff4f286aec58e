/// Interface that receives the finished parts of chunks: a build writes them to the database, a check compares them with one.
#pragma once

#include <cstdint>

#include "render_core/base/span.hpp"
#include "render_core/terrain/chunk_key.hpp"

namespace tedavis::host_sim {

enum class ChunkPart { regular, irregular, attributes, drape };

class PartStore {
public:
    virtual ~PartStore() = default;
    /// `place` is the part's place in the database. Different parts may be put at once, on any thread. Throws UserError.
    virtual void put(ChunkPart part, const terrain::ChunkKey& chunk, const terrain::PartPlace& place,
                     base::Span<const std::uint8_t> bytes) = 0;
    /// Reads place.bytes bytes of an irregular payload or a drape page that was put before.
    virtual void get(const terrain::PartPlace& place, std::uint8_t* bytes) const = 0;
};

/// The CRC-32 of base::crc32.
[[nodiscard]] std::uint32_t checksum(const void* bytes, std::size_t count);

}  // namespace tedavis::host_sim
