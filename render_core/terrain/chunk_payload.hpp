/// The bytes of a chunk's payload: its two arrays, and their validation.
///
/// Bytes must be aligned for ChunkVertex and in the machine's byte order. Pure functions; any thread.
#pragma once

#include "render_core/base/span.hpp"
#include "render_core/terrain/lattice.hpp"

namespace tedavis::terrain {

/// `bytes` holds at least entry.payload.bytes.
[[nodiscard]] base::Span<const ChunkVertex> payload_vertices(const ChunkEntry& entry, base::Span<const std::uint8_t> bytes);
/// Three indices per triangle, counter-clockwise seen from above; empty for a regular chunk, whose triangles follow from its
/// vertices.
[[nodiscard]] base::Span<const std::uint16_t> payload_indices(const ChunkEntry& entry, base::Span<const std::uint8_t> bytes);

/// Validates the content of a payload whose checksum is right, so that it can be used without range checks: numbers finite and
/// inside the entry's box (with a margin), posts inside the chunk, classes known, the border first, complete and clockwise,
/// marks on borders only and on all corners, regular chunks in their order, indices below vertex_count, strips first. The entry
/// itself must have passed TerrainDatabase::check_page().
[[nodiscard]] bool payload_holds(const Lattice& lattice, const ChunkEntry& entry, base::Span<const std::uint8_t> bytes);

}  // namespace tedavis::terrain
