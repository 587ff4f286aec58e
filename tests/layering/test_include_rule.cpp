#include "tests/layering/include_rule.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace tedavis::tests::layering::test_include_rule {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::set<std::string> kKnown = {"bus/frame/can_frame.hpp", "render_core/earth/wgs84.hpp"};

std::vector<std::string> judge(const std::string& path, const std::string& include) {
    return include_findings({path, "\n#include " + include + "\n"}, kKnown);
}

struct Seed {
    const char* path;
    const char* include;
};

void PrintTo(const Seed& seed, std::ostream* out) { *out << seed.path << " includes " << seed.include; }

class RefusedInclude : public ::testing::TestWithParam<Seed> {};

TEST_P(RefusedInclude, IsFoundWithItsLine) {
    EXPECT_THAT(judge(GetParam().path, GetParam().include), ElementsAre(HasSubstr(std::string(GetParam().path) + ":2: ")));
}

INSTANTIATE_TEST_SUITE_P(
    Folders, RefusedInclude,
    ::testing::Values(Seed{"render_core/base/a.cpp", "\"render_core/earth/wgs84.hpp\""},
                      Seed{"render_core/earth/a.cpp", "\"render_core/flight/signal.hpp\""},
                      Seed{"render_core/flight/a.cpp", "\"render_core/terrain/view.hpp\""},
                      Seed{"render_core/terrain/a.cpp", "\"render_core/scene/grid.hpp\""},
                      Seed{"render_core/scene/a.cpp", "\"render_core/terrain/view.hpp\""},
                      Seed{"render_core/design/a.cpp", "\"render_core/raytrace/mipmap.hpp\""},
                      Seed{"render_core/perception/a.cpp", "\"render_core/design/color.hpp\""},
                      Seed{"render_core/effects/a.cpp", "\"render_core/raytrace/mipmap.hpp\""},
                      Seed{"render_core/policy/a.cpp", "\"render_core/gl/gl.hpp\""},
                      Seed{"render_core/raytrace/a.cpp", "\"render_core/effects/planner.hpp\""},
                      Seed{"render_core/effects/a.cpp", "\"render_core/gl/gl.hpp\""},
                      Seed{"render_core/gl/a.cpp", "\"render_core/terrain/view.hpp\""},
                      Seed{"render_core/gl/a.cpp", "\"render_core/effects/planner.hpp\""},
                      Seed{"render_core/gl/a.cpp", "\"render_core/draw/rect.hpp\""},
                      Seed{"render_core/draw/a.cpp", "\"bus/frame/can_frame.hpp\""},
                      Seed{"render_core/draw/a.cpp", "\"render_core/gl/gl.hpp\""},
                      Seed{"render_core/draw/a.cpp", "\"render_core/draw/drawers/sky_drawer.hpp\""},
                      Seed{"render_core/draw/drawers/a.cpp", "\"render_core/display/planner/camera.hpp\""},
                      Seed{"render_core/display/planner/a.cpp", "\"render_core/gl/gl.hpp\""},
                      Seed{"render_core/display/planner/a.cpp", "\"render_core/draw/drawers/sky_drawer.hpp\""},
                      Seed{"render_core/display/planner/a.cpp", "\"render_core/display/display.hpp\""},
                      Seed{"render_core/display/a.cpp", "\"platform/clock/monotonic_clock.hpp\""},
                      Seed{"bus/state/a.cpp", "\"render_core/terrain/view.hpp\""},
                      Seed{"bus/state/a.cpp", "\"render_core/display/planner/frame_record.hpp\""},
                      Seed{"platform/files/a.cpp", "\"render_core/earth/wgs84.hpp\""},
                      Seed{"platform/files/a.cpp", "\"bus/frame/can_frame.hpp\""},
                      Seed{"platform/files/a.cpp", "\"render_core/display/display.hpp\""},
                      Seed{"platform/files/a.cpp", "\"platform/runtime/display_host.hpp\""},
                      Seed{"platform/runtime/a.cpp", "\"target/watchdog.hpp\""},
                      Seed{"render_core/display/a.cpp", "\"platform/runtime/display_host.hpp\""},
                      Seed{"target/a.cpp", "\"host_sim/version.hpp\""}, Seed{"host_sim/a.cpp", "\"target/watchdog.hpp\""},
                      Seed{"host_sim/a.cpp", "\"tests/support/a.hpp\""},
                      Seed{"toolchains/a.cpp", "\"render_core/base/span.hpp\""}));

INSTANTIATE_TEST_SUITE_P(FoldersOfTheSimulator, RefusedInclude,
                         ::testing::Values(Seed{"host_sim/a.cpp", "\"host_sim/options/replay_options.hpp\""},
                                           Seed{"host_sim/replay/a.cpp", "\"host_sim/commands/replay.hpp\""},
                                           Seed{"host_sim/replay/a.cpp", "\"host_sim/evaluation/flight_run.hpp\""},
                                           Seed{"host_sim/reports/a.cpp", "\"host_sim/replay/effect_ledger.hpp\""},
                                           Seed{"host_sim/flight_log/a.cpp", "\"host_sim/importers/fix_cleaner.hpp\""},
                                           Seed{"host_sim/terrain_builder/attributes/a.cpp",
                                                "\"host_sim/terrain_builder/raster.hpp\""},
                                           Seed{"host_sim/undeclared/a.cpp", "\"host_sim/console.hpp\""},
                                           Seed{"host_sim/commands/a.cpp", "\"host_sim/undeclared/a.hpp\""},
                                           Seed{"render_core/undeclared/a.cpp", "\"render_core/base/span.hpp\""}));

INSTANTIATE_TEST_SUITE_P(
    SystemHeaders, RefusedInclude,
    ::testing::Values(Seed{"bus/candump/a.cpp", "<linux/can.h>"}, Seed{"bus/candump/a.cpp", "<linux/can/raw.h>"},
                      Seed{"host_sim/a.cpp", "<linux/can.h>"}, Seed{"bus/switches/switch_debounce.cpp", "<gpiod.h>"},
                      Seed{"target/a.cpp", "<gpiod.h>"}, Seed{"platform/egl_kms/drm_card.cpp", "<libseat.h>"},
                      Seed{"render_core/draw/a.cpp", "<GLES2/gl2.h>"}, Seed{"host_sim/a.cpp", "<GLES3/gl3.h>"},
                      Seed{"render_core/gl/a.cpp", "<GL/gl.h>"}, Seed{"platform/egl_headless/a.cpp", "<GL/osmesa.h>"},
                      Seed{"render_core/gl/a.cpp", "<EGL/egl.h>"}, Seed{"target/a.cpp", "<EGL/egl.h>"},
                      Seed{"host_sim/a.cpp", "<SDL2/SDL.h>"}, Seed{"host_sim/a.cpp", "<SDL.h>"},
                      Seed{"render_core/design/a.cpp", "<toml++/toml.h>"}, Seed{"host_sim/a.cpp", "<toml++/toml.h>"},
                      Seed{"render_core/terrain/a.cpp", "<gdal_priv.h>"}, Seed{"target/a.cpp", "<nlohmann/json.hpp>"},
                      Seed{"render_core/earth/a.cpp", "<GeographicLib/Geodesic.hpp>"},
                      Seed{"render_core/draw/a.cpp", "<stb/stb_truetype.h>"}, Seed{"host_sim/a.cpp", "<gtest/gtest.h>"},
                      Seed{"render_core/base/a.cpp", "<unistd.h>"}, Seed{"bus/candump/a.cpp", "<sys/socket.h>"},
                      Seed{"render_core/base/a.cpp", "<thread>"}, Seed{"bus/state/a.cpp", "<chrono>"},
                      Seed{"render_core/flight/a.cpp", "<fstream>"}, Seed{"platform/files/a.cpp", "<stdexcept>"},
                      Seed{"render_core/scene/a.cpp", "<map>"}, Seed{"bus/state/a.cpp", "<functional>"},
                      Seed{"render_core/base/a.cpp", "<boost/any.hpp>"}));

INSTANTIATE_TEST_SUITE_P(Spelling, RefusedInclude,
                         ::testing::Values(Seed{"bus/frame/a.cpp", "\"can_frame.hpp\""},
                                           Seed{"bus/frame/a.cpp", "\"../frame/x.hpp\""}, Seed{"bus/frame/a.cpp", "\"cmath\""},
                                           Seed{"elsewhere/a.cpp", "\"bus/frame/can_frame.hpp\""}));

class AllowedInclude : public ::testing::TestWithParam<Seed> {};

TEST_P(AllowedInclude, IsNoFinding) { EXPECT_THAT(judge(GetParam().path, GetParam().include), IsEmpty()); }

INSTANTIATE_TEST_SUITE_P(Folders, AllowedInclude,
                         ::testing::Values(Seed{"render_core/terrain/a.cpp", "\"render_core/earth/wgs84.hpp\""},
                                           Seed{"render_core/policy/a.cpp", "\"render_core/effects/effect_table.hpp\""},
                                           Seed{"render_core/gl/a.cpp", "\"render_core/effects/device_capability.hpp\""},
                                           Seed{"render_core/draw/a.cpp", "\"render_core/draw/generated/shaders.hpp\""},
                                           Seed{"render_core/draw/drawers/a.cpp", "\"render_core/gl/gl.hpp\""},
                                           Seed{"render_core/display/planner/a.cpp", "\"render_core/draw/quad_batch.hpp\""},
                                           Seed{"render_core/display/a.cpp", "\"render_core/display/planner/camera.hpp\""},
                                           Seed{"bus/state/a.cpp", "\"render_core/flight/signal.hpp\""},
                                           Seed{"platform/files/a.cpp", "\"render_core/base/ports/byte_source.hpp\""},
                                           Seed{"platform/runtime/a.cpp", "\"platform/files/file_byte_source.hpp\""},
                                           Seed{"platform/runtime/a.cpp", "\"render_core/display/display.hpp\""},
                                           Seed{"target/a.cpp", "\"platform/runtime/display_host.hpp\""},
                                           Seed{"target/a.cpp", "\"platform/clock/monotonic_clock.hpp\""},
                                           Seed{"host_sim/a.cpp", "\"host_sim/console.hpp\""},
                                           Seed{"host_sim/replay/a.cpp", "\"host_sim/options/replay_options.hpp\""},
                                           Seed{"host_sim/commands/a.cpp", "\"host_sim/replay/display_session.hpp\""},
                                           Seed{"host_sim/main.cpp", "\"host_sim/commands/command_line.hpp\""},
                                           Seed{"tests/host_sim/a.cpp", "\"host_sim/commands/replay.hpp\""},
                                           Seed{"tests/target/a.cpp", "\"target/watchdog.hpp\""}));

INSTANTIATE_TEST_SUITE_P(
    SystemHeaders, AllowedInclude,
    ::testing::Values(Seed{"bus/socketcan/a.cpp", "<linux/can/raw.h>"}, Seed{"bus/switches/gpiod_v1_lines.cpp", "<gpiod.h>"},
                      Seed{"render_core/gl/a.hpp", "<GLES3/gl3.h>"}, Seed{"platform/osmesa/a.cpp", "<GL/osmesa.h>"},
                      Seed{"platform/egl_headless/a.cpp", "<EGL/egl.h>"}, Seed{"platform/window/a.cpp", "<SDL2/SDL.h>"},
                      Seed{"render_core/base/config_reader.cpp", "<toml++/toml.h>"}, Seed{"host_sim/a.cpp", "<gdal_priv.h>"},
                      Seed{"platform/threads/a.cpp", "<pthread.h>"}, Seed{"render_core/base/a.hpp", "<glm/vec3.hpp>"},
                      Seed{"render_core/base/a.hpp", "<cstdint>"}, Seed{"tests/bus/a.cpp", "<filesystem>"}));

TEST(OwnHeader, IsIncludedFirst) {
    const std::set<std::string> known = {"bus/frame/a.hpp", "bus/frame/a.cpp", "target/main.cpp"};
    EXPECT_THAT(own_header_findings({"bus/frame/a.cpp", "#include \"bus/frame/a.hpp\"\n#include <cmath>\n"}, known), IsEmpty());
    EXPECT_THAT(own_header_findings({"bus/frame/a.cpp", "\n#include <cmath>\n#include \"bus/frame/a.hpp\"\n"}, known),
                ElementsAre(HasSubstr("bus/frame/a.cpp:2: ")));
    EXPECT_THAT(own_header_findings({"bus/frame/a.cpp", "int a;\n"}, known), ElementsAre(HasSubstr("bus/frame/a.cpp:1: ")));
    EXPECT_THAT(own_header_findings({"target/main.cpp", "#include <cmath>\n"}, known), IsEmpty());
}

TEST(OwnHeader, IsReadOnce) {
    EXPECT_THAT(own_header_findings({"bus/frame/a.hpp", "// What it is.\n#pragma once\n"}, {}), IsEmpty());
    EXPECT_THAT(own_header_findings({"bus/frame/a.hpp", "// #pragma once\n"}, {}), ElementsAre(HasSubstr("#pragma once")));
}

TEST(FoldersOfTheSimulator, StandInTheOrderThatItsPageStates) {
    std::string order;
    for (const std::string& folder : folders_below("host_sim")) order += (order.empty() ? "`" : " → `") + folder + "`";
    const std::filesystem::path page = std::filesystem::path(TEDAVIS_SOURCE_DIR) / "host_sim/README.md";
    std::ifstream stream(page);
    std::string text, word;
    while (stream >> word) text += (text.empty() ? "" : " ") + word;
    EXPECT_NE(text.find(order), std::string::npos) << page << " does not state the order of host_sim/CMakeLists.txt: " << order;
}

TEST(IncludeRule, HoldsOverTheTree) {
    const auto files = read_tree(TEDAVIS_SOURCE_DIR);
    std::set<std::string> known;
    for (const SourceFile& file : files) known.insert(file.path);
    ASSERT_GT(files.size(), 50u) << "the tree was not read";
    for (const SourceFile& file : files) {
        EXPECT_THAT(include_findings(file, known), IsEmpty());
        EXPECT_THAT(own_header_findings(file, known), IsEmpty());
    }
}

}  // namespace
}  // namespace tedavis::tests::layering::test_include_rule
