/// What an index of a log was made from. An index is used only where every part is what it was.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "render_core/base/ports/byte_source.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::host_sim {

struct IndexKey {
    enum Part : std::uint8_t { program, log, bus, switch_log, switch_config, phases, terrain, count_ };
    std::array<std::uint64_t, count_> parts{};
};
static_assert(std::is_trivially_copyable_v<IndexKey>);

/// The first part that differs, as words: "the log", "the terrain database"; null when all are equal.
[[nodiscard]] const char* first_difference(const IndexKey& a, const IndexKey& b);

/// Size and times of a file, and its first and last 64 KiB. The change time makes it this very file on this machine: a
/// byte changed in place, a restored modification time and a copy all give another identity.
struct FileIdentity {
    std::uint64_t hash = 0;
    std::int64_t changed_ns = 0;  ///< since the epoch, of the machine's clock
};
/// Throws UserError where the file is gone.
[[nodiscard]] FileIdentity file_identity(const std::string& path, base::ByteSource& content);

/// Of a file's size and times alone. Throws UserError where the file is gone.
[[nodiscard]] std::uint64_t times_identity(const std::string& path);

/// Of the file that runs: checkpoints are its memory as it is, and another build may lay it out or compute it differently.
[[nodiscard]] std::uint64_t program_identity();
/// Of a text that was read; 0 for an empty one.
[[nodiscard]] std::uint64_t text_identity(std::string_view text);
/// Of the surface that heights come from, by the database's own checksums; 0 for none.
[[nodiscard]] std::uint64_t terrain_identity(const terrain::TerrainDatabase* database);

}  // namespace tedavis::host_sim
