/// The identities of all files that an index of a log depends on. An index is used only if all of them are unchanged.
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

/// A hash of a file's size, its times, and its first and last 64 KiB. It includes the inode's change time, so a byte changed in
/// place, a restored modification time and a copy all give another identity.
struct FileIdentity {
    std::uint64_t hash = 0;
    std::int64_t changed_ns = 0;  ///< since the epoch, of the machine's clock
};
/// Throws UserError where the file is gone.
[[nodiscard]] FileIdentity file_identity(const std::string& path, base::ByteSource& content);

/// Identity by a file's size and times alone. Throws UserError where the file does not exist.
[[nodiscard]] std::uint64_t times_identity(const std::string& path);

/// Identity of the running executable by its file's size and times, since checkpoints are copies of its memory and another build
/// may lay it out or compute it differently.
[[nodiscard]] std::uint64_t program_identity();
/// Identity of a text; 0 for an empty one.
[[nodiscard]] std::uint64_t text_identity(std::string_view text);
/// Identity of a database's terrain surface by its checksums; 0 without a database.
[[nodiscard]] std::uint64_t terrain_identity(const terrain::TerrainDatabase* database);

}  // namespace tedavis::host_sim
