/// Where the finished parts of chunks go: into a database that is built, or against one that is checked.
#pragma once

#include <cstdint>

#include "render_core/base/span.hpp"
#include "render_core/terrain/chunk_key.hpp"

namespace tedavis::host_sim {

enum class ChunkPart { regular, irregular, attributes, drape };

class PartStore {
public:
    virtual ~PartStore() = default;
    /// `place` is where the part belongs in a database that is built. Any thread; different parts at once. Throws UserError.
    virtual void put(ChunkPart part, const terrain::ChunkKey& chunk, const terrain::PartPlace& place,
                     base::Span<const std::uint8_t> bytes) = 0;
    /// An irregular payload or a drape page that was put before, place.bytes of it.
    virtual void get(const terrain::PartPlace& place, std::uint8_t* bytes) const = 0;
};

/// CRC-32 as base::crc32 has it.
[[nodiscard]] std::uint32_t checksum(const void* bytes, std::size_t count);

}  // namespace tedavis::host_sim
