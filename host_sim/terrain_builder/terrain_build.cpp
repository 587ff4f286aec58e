#include "host_sim/terrain_builder/terrain_build.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "host_sim/terrain_builder/build_stages.hpp"
#include "host_sim/user_error.hpp"
#include "platform/threads/thread_workers.hpp"

namespace tedavis::host_sim {
namespace {

std::unique_ptr<base::Workers> make_workers(std::uint32_t threads) {
    const std::uint32_t most = std::min(platform::usable_processors(), kMaxThreads);
    auto workers = platform::make_thread_workers({threads == 0 ? most : threads, nullptr});
    if (!workers.ok()) throw UserError(std::string(workers.error().message.view()));
    return std::move(workers.value());
}

void require_place(const std::string& output) {
    const std::filesystem::path folder = std::filesystem::absolute(output).parent_path();
    if (!std::filesystem::is_directory(folder))
        throw UserError(output + ": there is no folder " + folder.string() + "; make it or name another output");
    if (std::filesystem::is_directory(output)) throw UserError(output + ": is a folder; name a file for the database");
}

/// `goes_on` tells, also where it throws, whether enough was done that going on is worth it.
void build_in(const std::string& folder, const TerrainSources& sources, const BuildOptions& options, bool& goes_on) {
    BuildParts parts(sources, folder, options);
    const std::unique_ptr<base::Workers> workers = make_workers(options.threads);
    StagedRun run(
        parts.journal, parts.record, *workers, options.progress, [&parts] { parts.sync(); }, options.between_records);
    try {
        run.run(build_stages(parts));
    } catch (const WorkFileError&) {
        goes_on = parts.journal.last().stage > 0;  // once there is room on the disk
        throw;
    }
}

}  // namespace

void build_terrain(const TerrainSources& sources, const std::string& output, const BuildOptions& options) {
    require_place(output);
    const std::string folder = output + ".part";
    bool goes_on = false;
    try {
        build_in(folder, sources, options, goes_on);
    } catch (const UserError&) {
        // What was wrong will be wrong again; a build that was stopped goes on from its work folder.
        std::error_code ignored;
        if (!goes_on) std::filesystem::remove_all(folder, ignored);
        throw;
    }
    if (std::rename((folder + "/database").c_str(), output.c_str()) != 0)
        throw UserError(output + ": cannot be put in its place; check the folder");
    std::filesystem::remove_all(folder);
}

}  // namespace tedavis::host_sim
