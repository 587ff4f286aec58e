#include "host_sim/commands/kept_terrains.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <regex>

#include "host_sim/commands/terrain_cache.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/reports/run_findings.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

namespace fs = std::filesystem;
using KeptJson = nlohmann::ordered_json;

std::string gigabytes(std::uint64_t bytes) {
    constexpr double kMega = 1e6, kGiga = 1e9;
    const auto count = static_cast<double>(bytes);
    return count < kGiga ? decimal(count / kMega, 1) + " MB" : decimal(count / kGiga, 1) + " GB";
}

std::uint64_t bytes_at(const fs::path& path) {
    std::error_code failed;
    if (fs::is_regular_file(path, failed)) {
        const std::uint64_t bytes = fs::file_size(path, failed);
        return failed ? 0 : bytes;
    }
    std::uint64_t sum = 0;
    for (fs::recursive_directory_iterator it(path, failed), end; !failed && it != end; it.increment(failed)) {
        std::error_code gone;
        const std::uint64_t bytes = it->is_regular_file(gone) ? it->file_size(gone) : 0;
        sum += gone ? 0 : bytes;
    }
    return sum;
}

/// The database to which a file of the folder belongs; empty where it belongs to none.
std::string database_of(const fs::path& file) {
    static const std::regex kName("(.*-[0-9a-f]{16}\\.tdb)(\\.part)?");
    std::smatch match;
    const std::string name = file.filename().string();
    return std::regex_match(name, match, kName) ? (file.parent_path() / match[1].str()).string() : std::string();
}

KeptTerrain kept_at(const std::string& path) {
    std::error_code failed;
    KeptTerrain kept{path, bytes_at(path) + bytes_at(path + ".part"), fs::file_time_type::min(), fs::exists(path, failed)};
    for (const std::string& file : {path, path + ".part", path + ".lock"}) {
        const fs::file_time_type time = fs::last_write_time(file, failed);
        if (!failed) kept.used = std::max(kept.used, time);
    }
    return kept;
}

/// False where it is being built or used, or cannot be removed.
bool is_removed(const KeptTerrain& kept) {
    const int lock = open((kept.path + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (lock < 0) return false;
    std::error_code failed, part_failed;
    const bool is_free = flock(lock, LOCK_EX | LOCK_NB) == 0;
    if (is_free) {
        fs::remove(kept.path, failed);
        fs::remove_all(kept.path + ".part", part_failed);
    }
    close(lock);
    return is_free && !failed && !part_failed;
}

std::uint64_t bytes_of(const std::vector<KeptTerrain>& terrains) {
    std::uint64_t sum = 0;
    for (const KeptTerrain& kept : terrains) sum += kept.bytes;
    return sum;
}

double seconds_since(fs::file_time_type time) {
    return std::max(0.0, std::chrono::duration<double>(fs::file_time_type::clock::now() - time).count());
}

std::string name_of_kept(const KeptTerrain& kept) {
    return fs::path(kept.path).filename().string() + (kept.is_built ? "" : " (an interrupted build)");
}

KeptJson kept_json(const std::vector<KeptTerrain>& terrains) {
    KeptJson json = KeptJson::array();
    for (const KeptTerrain& kept : terrains)
        json.push_back(
            {{"file", kept.path}, {"bytes", kept.bytes}, {"used_s_ago", seconds_since(kept.used)}, {"is_built", kept.is_built}});
    return json;
}

std::string kept_text(const std::string& folder, const std::vector<KeptTerrain>& terrains) {
    std::string text = folder + ": " + counted(terrains.size(), "database") + ", " + gigabytes(bytes_of(terrains)) + "; beyond " +
                       gigabytes(kKeptTerrainBytes) + " those used longest ago are removed";
    for (const KeptTerrain& kept : terrains)
        text +=
            "\n  " + name_of_kept(kept) + ": " + gigabytes(kept.bytes) + ", used " + age_words(seconds_since(kept.used)) + " ago";
    return text;
}

}  // namespace

std::vector<KeptTerrain> kept_terrains(const std::string& folder) {
    std::vector<std::string> paths;
    std::error_code failed;
    for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed))
        if (std::string path = database_of(it->path()); !path.empty()) paths.push_back(std::move(path));
    std::sort(paths.begin(), paths.end());
    paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
    std::vector<KeptTerrain> terrains;
    for (const std::string& path : paths) terrains.push_back(kept_at(path));
    std::stable_sort(terrains.begin(), terrains.end(),
                     [](const KeptTerrain& a, const KeptTerrain& b) { return a.used > b.used; });
    return terrains;
}

TerrainUse::TerrainUse(const std::string& path) : file_(open((path + ".lock").c_str(), O_RDONLY | O_CLOEXEC)) {
    if (file_ >= 0) static_cast<void>(flock(file_, LOCK_SH | LOCK_NB));
}

TerrainUse::~TerrainUse() {
    if (file_ >= 0) close(file_);
}

void record_terrain_use(const std::string& path) {
    std::error_code ignored;  // of another user's cache: it may be used all the same
    fs::last_write_time(path + ".lock", fs::file_time_type::clock::now(), ignored);
}

std::vector<KeptTerrain> trim_terrains(const std::string& folder, std::uint64_t limit_bytes, const std::string& path) {
    std::vector<KeptTerrain> terrains = kept_terrains(folder), removed;
    std::uint64_t bytes = bytes_of(terrains);
    for (auto kept = terrains.rbegin(); kept != terrains.rend() && bytes > limit_bytes; ++kept) {
        if (kept->path == path || !is_removed(*kept)) continue;
        bytes -= kept->bytes;
        removed.push_back(*kept);
    }
    return removed;
}

std::string removed_words(const std::vector<KeptTerrain>& removed) {
    if (removed.size() != 1) return "removed " + counted(removed.size(), "database") + " (" + gigabytes(bytes_of(removed)) + ")";
    return "removed " + name_of_kept(removed[0]) + " (" + gigabytes(removed[0].bytes) + ", last used " +
           age_words(seconds_since(removed[0].used)) + " ago)";
}

int run_terrain_cache(const TerrainCacheOptions& options, Console& console) {
    const std::string folder = terrain_cache_folder();
    if (folder.empty()) throw UserError("terrain cache: there is no folder; set HOME or XDG_CACHE_HOME");
    const std::vector<KeptTerrain> removed = options.clear ? trim_terrains(folder, 0, "") : std::vector<KeptTerrain>();
    const std::vector<KeptTerrain> kept = kept_terrains(folder);
    const KeptJson json = {
        {"folder", folder}, {"limit_bytes", kKeptTerrainBytes}, {"databases", kept_json(kept)}, {"removed", kept_json(removed)}};
    const std::string stay =
        kept.empty() ? "" : "; " + counted(kept.size(), "database") + " in use, being built or not removable stay";
    console.result(options.clear ? folder + ": " + removed_words(removed) + stay : kept_text(folder, kept), json_text(json, 2));
    return 0;
}

}  // namespace tedavis::host_sim
