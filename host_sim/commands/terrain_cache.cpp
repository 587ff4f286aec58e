#include "host_sim/commands/terrain_cache.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/kept_terrains.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/reports/frame_record_json.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/terrain_builder/verify_database.hpp"
#include "host_sim/user_error.hpp"
#include "host_sim/version.hpp"
#include "render_core/base/hash.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::host_sim {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kLookAgain(100);

/// Held by one process; the system releases it when the process ends, however it ends. The file stays, since a name that is
/// removed and made again would be two locks.
class BuildLock {
public:
    explicit BuildLock(const std::string& path) : file_(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
        if (file_ < 0) throw UserError(path + ": cannot be written (" + std::strerror(errno) + "); check the folder");
    }
    ~BuildLock() { close(file_); }
    BuildLock(const BuildLock&) = delete;
    BuildLock& operator=(const BuildLock&) = delete;

    void wait(const std::string& path, Console& console) const {
        if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
        console.note("note: another tedavis builds " + path + "; waiting for it");
        const InterruptGuard interrupt;
        while (flock(file_, LOCK_EX | LOCK_NB) != 0) {
            if (interrupt.requested()) throw Interrupted("interrupted; nothing was written");
            std::this_thread::sleep_for(kLookAgain);
        }
    }

private:
    int file_;
};

std::string cache_key(const TerrainBuildOptions& build) {
    const std::string text = terrain_build_identity(build) + '\n' + version() + '\n' + std::to_string(terrain::kTdbVersion);
    base::Fnv1a64 hash;
    hash.add(text.data(), text.size());
    return hash_text(hash.value());
}

std::string cached_path(const TerrainBuildOptions& build, const std::string& folder) {
    return folder + "/" + fs::path(build.rasters.front()).stem().string() + "-" + cache_key(build) + ".tdb";
}

/// A database that cannot be opened is built anew.
bool is_sound(const std::string& path) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) return false;
    try {
        const OpenDatabase open(path);
        return true;
    } catch (const UserError&) {
        return false;
    }
}

/// Names with a colon may be GDAL's own, such as NETCDF:"file.nc":z.
void require_there(const std::string& raster) {
    std::error_code ignored;
    if (raster.find(':') == std::string::npos && !fs::exists(raster, ignored)) require_regular_file(raster);
}

std::string megabytes(const std::string& path) {
    std::error_code ignored;
    return decimal(static_cast<double>(fs::file_size(path, ignored)) / 1e6, 1) + " MB";
}

std::string required_folder() {
    std::string folder = terrain_cache_folder();
    if (folder.empty())
        throw UserError(
            "--terrain: there is no folder to keep a database in; set HOME or XDG_CACHE_HOME, or build one with "
            "'tedavis terrain build'");
    return folder;
}

bool is_found(const std::string& path, Console& console) {
    record_terrain_use(path);  // first, so that no other process takes it for the oldest
    if (!is_sound(path)) return false;
    console.note("note: terrain from the cache: " + path);
    return true;
}

void build_at(const std::string& path, const TerrainBuildOptions& build, Console& console) {
    TerrainBuildOptions here = build;
    here.output = path;
    std::error_code ignored;
    fs::remove(path, ignored);  // what could not be opened
    Console only_notes = console.without_result();
    (void)run_terrain_build(here, only_notes);
    console.note("note: terrain was built for this and later flights: " + path + " (" + megabytes(path) + ")");
}

void keep_below_limit(const std::string& folder, const std::string& path, Console& console) {
    record_terrain_use(path);
    const std::vector<KeptTerrain> removed = trim_terrains(folder, kKeptTerrainBytes, path);
    if (!removed.empty())
        console.note("note: " + removed_words(removed) + " from " + folder + ", where those used longest ago go beyond " +
                     decimal(static_cast<double>(kKeptTerrainBytes) / 1e9, 0) + " GB; 'tedavis terrain cache' shows it");
}

}  // namespace

std::string terrain_cache_folder() {
    const char* const named = std::getenv("XDG_CACHE_HOME");
    if (named != nullptr && named[0] == '/') return std::string(named) + "/tedavis/terrain";
    const char* const home = std::getenv("HOME");
    return home != nullptr && home[0] == '/' ? std::string(home) + "/.cache/tedavis/terrain" : std::string();
}

std::string cached_terrain(const TerrainBuildOptions& build, Console& console) {
    for (const std::string& raster : build.rasters) require_there(raster);
    const std::string folder = required_folder();
    std::string path = cached_path(build, folder);
    if (is_found(path, console)) return path;
    make_folder(folder);
    const BuildLock lock(path + ".lock");
    lock.wait(path, console);
    if (is_found(path, console)) return path;
    build_at(path, build, console);
    keep_below_limit(folder, path, console);
    return path;
}

}  // namespace tedavis::host_sim
