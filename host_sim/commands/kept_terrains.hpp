/// The databases in the folder of terrain_cache.hpp with their sizes and times of last use; `tedavis terrain cache`.
///
/// A database and the remains of an interrupted build of it (`.part`) count as one. The time of last use is that of its `.lock`
/// file, since the database's own time states when it was changed. Files of other names in the folder are not touched, nor is a
/// database that is being built or used (TerrainUse).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

/// Limit of all databases together, bytes: above it, those that were used longest ago are removed when another one is built.
inline constexpr std::uint64_t kKeptTerrainBytes = 10'000'000'000;

struct KeptTerrain {
    std::string path;         ///< of the database
    std::uint64_t bytes = 0;  ///< including the remains of an interrupted build
    std::filesystem::file_time_type used;
    bool is_built = true;  ///< false: only an interrupted build
};

/// Returns the databases, the one that was used last first; empty where there is no folder.
[[nodiscard]] std::vector<KeptTerrain> kept_terrains(const std::string& folder);
/// A lock: while the object exists, neither this nor another process removes the database.
class TerrainUse {
public:
    TerrainUse() = default;
    /// Takes the lock. Where that is not possible, as in another user's cache, the database is used without it.
    explicit TerrainUse(const std::string& path);
    ~TerrainUse();
    TerrainUse(const TerrainUse&) = delete;
    TerrainUse& operator=(const TerrainUse&) = delete;
    TerrainUse(TerrainUse&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
    TerrainUse& operator=(TerrainUse&& other) noexcept {
        std::swap(file_, other.file_);
        return *this;
    }

private:
    int file_ = -1;
};

/// Sets the time of last use to now; the lock file must exist.
void record_terrain_use(const std::string& path);
/// Removes the databases that were used longest ago, but not the one at `path`, until the others have at most `limit_bytes`;
/// returns the removed ones.
std::vector<KeptTerrain> trim_terrains(const std::string& folder, std::uint64_t limit_bytes, const std::string& path);
/// "removed alps-0123456789abcdef.tdb (1.2 GB, last used 12 d ago)".
[[nodiscard]] std::string removed_words(const std::vector<KeptTerrain>& removed);

struct TerrainCacheOptions {
    bool clear = false;
};
/// Returns the exit code. Throws UserError where the environment names no folder.
[[nodiscard]] int run_terrain_cache(const TerrainCacheOptions& options, Console& console);

}  // namespace tedavis::host_sim
