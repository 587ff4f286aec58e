#include "host_sim/commands/start_trial.hpp"

#include <memory>

#include "host_sim/replay/display_session.hpp"
#include "host_sim/terrain_builder/fractal_geotiff.hpp"
#include "host_sim/terrain_builder/post_source.hpp"
#include "host_sim/terrain_builder/terrain_build.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint32_t kTrialPosts = 65, kTrialSeed = 1;

}  // namespace

const std::string& StartTrial::terrain() {
    if (!terrain_.empty()) return terrain_;
    const std::string raster = folder_.path() + "/trial.tif", database = folder_.path() + "/trial.tdb";
    write_fractal_geotiff(raster, kTrialPosts, kTrialSeed, FractalNumbers::int16);
    build_terrain(
        PostReaderFactory([&raster] { return std::make_unique<PostSource>(std::vector<std::string>{raster}, RasterOptions{}); }),
        database, {});
    return terrain_ = database;
}

void StartTrial::require(const std::string& device, const std::string& design) {
    PictureOptions options;
    options.device = device;
    options.design = design;
    options.terrain = terrain();
    try {
        const DisplaySession session(options, false);
    } catch (const UserError& error) {
        const std::string message = error.what(), file = device + ": ";
        const bool is_of_device = message.compare(0, file.size(), file) == 0;
        throw UserError(file + "does not start with the design " + design + ": " +
                        (is_of_device ? message.substr(file.size()) : message));
    }
}

StartTrial::Outcome StartTrial::start(PictureOptions options) {
    if (options.terrain.empty()) options.terrain = terrain();
    Outcome outcome;
    try {
        DisplaySession session(options, false);
        outcome.used = session.display().planner().budget();
    } catch (const UserError& error) {
        base::BudgetShortage shortage;
        if (!base::find_shortage(error.what(), shortage)) throw;
        outcome.shortage = shortage;
    }
    return outcome;
}

}  // namespace tedavis::host_sim
