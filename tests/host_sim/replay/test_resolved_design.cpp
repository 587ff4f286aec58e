#include "host_sim/replay/resolved_design.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "host_sim/input_file.hpp"
#include "host_sim/replay/load_design.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/toml_text.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_resolved_design {
namespace {

/// The resolved text of a shipped design, in a file that is based on nothing.
TEST(ResolvedDesign, ReadAgainEveryShippedDesignIsTheSame) {
    const test_support::TemporaryFolder place;
    const std::string designs = shipped_root() + "/configs/designs";
    std::size_t inheriting = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(designs)) {
        if (entry.path().extension() != ".toml") continue;
        const std::string path = entry.path().string();
        const auto whole = resolved_design(path);
        EXPECT_FALSE(whole.contains("based_on")) << path;
        const std::string again = place.write("again.toml", toml_text(whole));
        EXPECT_EQ(resolved_design(again), whole) << path;
        inheriting += read_file(path).find("based_on") != std::string::npos ? 1 : 0;
    }
    EXPECT_GT(inheriting, 100u) << "the control: there is something to inherit";
}

TEST(ResolvedDesign, SaysWhatItInherits) {
    const auto approach = resolved_design(shipped_root() + "/configs/designs/approach.toml");
    EXPECT_EQ(approach["name"], "approach");
    EXPECT_EQ(approach["terrain"]["shade"]["ambient"], 0.3) << "its own";
    EXPECT_EQ(approach["sky"]["haze_distance_m"], 40000) << "of takeoff";
    EXPECT_EQ(approach["sky"]["zenith_color"], "#1c54a8") << "of default";
    EXPECT_FALSE(approach.contains("phases")) << "default's own";
}

TEST(ResolvedDesign, PathsOfABaseElsewhereAreFoundFromTheDesign) {
    const test_support::TemporaryFolder place;
    std::filesystem::create_directories(place.file("bases/colours"));
    std::filesystem::create_directory(place.file("designs"));
    place.write("bases/colours/mine.toml", read_file(resolve_config("grey", "palettes")));
    place.write("bases/base.toml", "name = 'base'\n[terrain]\npalette = 'colours/mine.toml'\n");
    const std::string design = place.write("designs/d.toml", "name = 'd'\nbased_on = '../bases/base.toml'\n");
    const auto whole = resolved_design(design);
    EXPECT_EQ(whole["terrain"]["palette"], "../bases/colours/mine.toml");
    PictureOptions options;
    options.design = place.write("designs/again.toml", toml_text(whole));
    EXPECT_EQ(load_design(options).terrain.palette.name.view(), "grey");
}

TEST(ResolvedDesign, FaultsNameFileAndLine) {
    const test_support::TemporaryFolder place;
    place.write("b.toml", "name = 'b'\n[view]\nzoom = 1\n");
    const std::string design = place.write("d.toml", "name = 'd'\nbased_on = 'b.toml'\n");
    test_support::expect_user_error([&] { static_cast<void>(resolved_design(design)); },
                                    place.file("b.toml") + ":3: unknown key");
}

}  // namespace
}  // namespace tedavis::host_sim::test_resolved_design
