#include "host_sim/commands/start_trial.hpp"

#include <gtest/gtest.h>

#include "host_sim/input_file.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_start_trial {
namespace {

using test_support::expect_user_error;

const std::string kDevices = test_support::source_dir() + "/configs/devices/";

/// The shipped small device with another size of a budget line.
std::string small_device(const test_support::TemporaryFolder& place, const std::string& name, const std::string& bytes) {
    std::string text = read_file(kDevices + "es2-small.toml");
    const std::size_t line = text.find("bytes = ", text.find("name = \"" + name + "\""));
    text.replace(line, text.find('\n', line) - line, "bytes = " + bytes);
    return place.write("small.toml", text);
}

TEST(StartTrial, ShippedDevicesStart) {
    StartTrial trial;
    for (const char* const device : {"es2-small", "es3-mid", "sc2"})
        EXPECT_NO_THROW(trial.require(kDevices + device + ".toml", "default")) << device;
}

/// Lines of the processor's memory and of the GPU's, of terrain and of the picture; each is named as a start names it.
TEST(StartTrial, EveryLineThatIsTooSmallIsNamed) {
    const test_support::TemporaryFolder place;
    StartTrial trial;
    for (const char* const line : {"lod_scratch", "terrain_heights", "terrain_vertices", "render_targets", "symbology", "staging",
                                   "planned_frames", "planner_memory"}) {
        const std::string device = small_device(place, line, "4096");
        expect_user_error([&] { trial.require(device, "default"); },
                          device + ": does not start with the design default: the budget line '" + line + "'");
    }
}

/// A line raised by what its refusal says, again and again, ends with a device that starts.
TEST(StartTrial, ARefusalSaysWhatIsEnough) {
    const test_support::TemporaryFolder place;
    StartTrial trial;
    PictureOptions options;
    for (const char* const line : {"lod_scratch",
                                   "terrain_heights",
                                   "terrain_chunk_slots",
                                   "terrain_index",
                                   "terrain_vertices",
                                   "terrain_indices",
                                   "terrain_attributes",
                                   "terrain_pages",
                                   "render_targets",
                                   "symbology",
                                   "symbology_vertices",
                                   "font_atlas",
                                   "staging",
                                   "planned_frames",
                                   "planner_memory",
                                   "scene_slices",
                                   "scene_ground",
                                   "scene_solids",
                                   "scene_solid_vertices",
                                   "scene_glyphs",
                                   "scene_glyph_vertices",
                                   "scene_billboards",
                                   "scene_billboard_vertices"}) {
        std::uint64_t bytes = 8;
        int starts = 0;
        for (; starts < 12; ++starts) {
            options.device = small_device(place, line, std::to_string(bytes));
            const StartTrial::Outcome outcome = trial.start(options);
            if (!outcome.shortage) break;
            ASSERT_EQ(outcome.shortage->line.view(), line);
            ASSERT_GT(outcome.shortage->enough(), bytes) << line;
            bytes = outcome.shortage->enough();
        }
        EXPECT_LT(starts, 12) << line;
    }
}

TEST(StartTrial, TheDesignDecidesWhatADeviceNeeds) {
    const test_support::TemporaryFolder place;
    StartTrial trial;
    const std::string plain = place.write("plain.toml", "name = 'plain'\n[view]\n"),
                      device = small_device(place, "scene_glyphs", "4096");
    expect_user_error([&] { trial.require(device, "default"); }, "'scene_glyphs'");
    EXPECT_NO_THROW(trial.require(device, plain)) << "which shows no data";
    const std::string no_edges = small_device(place, "picture_edges", "4096");
    expect_user_error([&] { trial.require(no_edges, "effects/clutter_budget"); }, "'picture_edges'");
    EXPECT_NO_THROW(trial.require(no_edges, "default")) << "which measures no clutter";
}

}  // namespace
}  // namespace tedavis::host_sim::test_start_trial
