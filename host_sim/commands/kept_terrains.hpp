/// The databases in the folder of terrain_cache.hpp: which there are, how large, when they were used; `tedavis terrain cache`.
///
/// A database and what an interrupted build of it has left (`.part`) are one. When it was used last is the time of its `.lock`
/// file, since that of the database tells others whether it changed. Files of other names in the folder are left alone, and so is
/// a database that is being built or used (TerrainUse).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

/// Beyond it, the databases that were used longest ago are removed when another one is built.
inline constexpr std::uint64_t kKeptTerrainBytes = 10'000'000'000;

struct KeptTerrain {
    std::string path;         ///< of the database
    std::uint64_t bytes = 0;  ///< with an interrupted build
    std::filesystem::file_time_type used;
    bool is_built = true;  ///< false: only an interrupted build
};

/// The one that was used last comes first; empty where there is no folder.
[[nodiscard]] std::vector<KeptTerrain> kept_terrains(const std::string& folder);
/// While it lives, the database is not removed, by this or another process.
class TerrainUse {
public:
    TerrainUse() = default;
    /// Where the lock cannot be had, as in another user's cache, the database is used without it.
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

/// The database is used now; its lock file exists.
void record_terrain_use(const std::string& path);
/// Removes those that were used longest ago until the others have at most `limit_bytes`, but not the one at `path`; returns those
/// that were removed.
std::vector<KeptTerrain> trim_terrains(const std::string& folder, std::uint64_t limit_bytes, const std::string& path);
/// "removed alps-0123456789abcdef.tdb (1.2 GB, last used 12 d ago)".
[[nodiscard]] std::string removed_words(const std::vector<KeptTerrain>& removed);

struct TerrainCacheOptions {
    bool clear = false;
};
/// Returns the exit code. Throws UserError where the environment names no folder.
[[nodiscard]] int run_terrain_cache(const TerrainCacheOptions& options, Console& console);

}  // namespace tedavis::host_sim
