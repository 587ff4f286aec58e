// A scene of everything that is published round Davos: weather, towns, runways, recorded flights and traffic. What the display
// would read of it is compared with what the files themselves say, counted here by other means.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "host_sim/input_file.hpp"
#include "host_sim/scene_builder/scene_build.hpp"
#include "platform/files/memory_byte_source.hpp"
#include "render_core/base/units.hpp"
#include "render_core/scene/scene.hpp"
#include "tests/real/davos_files.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::test_scene {
namespace {

using scene::Attribute;
using scene::Layer;

/// Beside what the sheet of Davos shows: long flights, one of them with a gap.
constexpr const char* kFlights = R"(
[[layer]]
name = "valais"
source = "@/flights/igcxc_trifai-xcontest-362.70.igc"
role = "trajectory"
[[layer]]
name = "gap"
source = "@/flights/igcxc_discontinuity.igc"
role = "trajectory"
)";

class DavosScene : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        const test_support::DavosFiles davos;
        const auto& folder = davos.folder;
        const std::string text = folder.read("scenes/davos.toml") + davos.with_real_data(kFlights, "@");
        state().notes = host_sim::build_scene(folder.write("scenes/all.toml", text), folder.file("davos.sdb"),
                                              [](std::string_view, std::size_t, std::size_t) {});
        state().bytes = host_sim::read_bytes(folder.file("davos.sdb"));
        state().memory.resize(state().bytes.size() + (1u << 16));
        platform::MemoryByteSource source({state().bytes.data(), state().bytes.size()});
        base::Arena arena(state().memory.data(), state().memory.size());
        auto loaded = scene::Scene::load(source, arena);
        ASSERT_TRUE(loaded.ok());
        state().scene = loaded.value();
    }
    static void TearDownTestSuite() { state() = {}; }
    static const Layer& layer(const char* name) {
        const Layer* const found = state().scene.find(name);
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }

    struct State {
        std::vector<std::string> notes;
        std::vector<std::uint8_t> bytes;
        std::vector<unsigned char> memory;
        scene::Scene scene;
    };
    static State& state() {
        static State state;
        return state;
    }
};

std::string text_of(const std::string& file) { return host_sim::read_file_unpacked(test_support::real_data_dir() + file); }

std::size_t lines_with(const std::string& text, const std::function<bool(const std::string&)>& wanted) {
    std::istringstream lines(text);
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line);) count += wanted(line) ? 1 : 0;
    return count;
}

TEST_F(DavosScene, TownsAreAllThere) {
    const Layer& towns = layer("towns");
    const std::string table = text_of("/nav/davos_places.csv");
    EXPECT_EQ(towns.entry->feature_count, lines_with(table, [](const std::string& line) { return !line.empty(); }) - 1);
    const Attribute& kind = *towns.find("kind");
    std::size_t number_of_towns = 0;
    for (const float value : kind.values) number_of_towns += value == 1 ? 1 : 0;
    EXPECT_EQ(number_of_towns, lines_with(table, [](const std::string& line) { return line.rfind("town,", 0) == 0; }));
    bool has_davos = false;
    for (std::uint32_t n = 0; n < towns.entry->feature_count; ++n) {
        if (towns.name_of(n) != "Davos") continue;
        has_davos = true;
        EXPECT_NEAR(base::degrees(towns.points[n].latitude_rad), 46.7961744, 1e-9);
        EXPECT_NEAR(base::degrees(towns.points[n].longitude_rad), 9.8237266, 1e-9);
        EXPECT_TRUE(std::isnan(towns.points[n].height_m)) << "on the ground";
    }
    EXPECT_TRUE(has_davos);
}

TEST_F(DavosScene, SamedansRunwayIsWhereItIs) {
    const Layer& runway = layer("samedan");
    ASSERT_EQ(runway.entry->feature_count, 1u);
    EXPECT_EQ(runway.name_of(0).substr(0, 4), "LSZS");
    EXPECT_NEAR(double{runway.points[0].height_m}, 1707, 10);
    EXPECT_NEAR(double{runway.find("length")->values[0]}, 1800, 60);
    // Length of the line on a sphere, against what the table states.
    const double north_m = 6371000 * (runway.points[1].latitude_rad - runway.points[0].latitude_rad);
    const double east_m =
        6371000 * std::cos(runway.points[0].latitude_rad) * (runway.points[1].longitude_rad - runway.points[0].longitude_rad);
    EXPECT_NEAR(std::hypot(north_m, east_m), double{runway.find("length")->values[0]}, 100);
}

TEST_F(DavosScene, AFlightKeepsItsFixes) {
    const Layer& flight = layer("valais");
    const std::size_t fixes =
        lines_with(text_of("/flights/igcxc_trifai-xcontest-362.70.igc"), [](const std::string& line) { return line[0] == 'B'; });
    EXPECT_GT(fixes, 30000u);
    EXPECT_LE(flight.entry->point_count, fixes);
    EXPECT_GT(flight.entry->point_count, fixes - fixes / 100) << "few were not flown";
    const Attribute& speed = *flight.find("ground_speed");
    double sum = 0;
    for (std::size_t n = 0; n < flight.points.size(); ++n) {
        ASSERT_FALSE(std::isnan(flight.points[n].height_m)) << n;
        ASSERT_GT(flight.points[n].height_m, 300);
        ASSERT_LT(flight.points[n].height_m, 5500);
        const std::int64_t before_ns = n > 0 ? flight.points[n - 1].time_ns : scene::kNoTime;
        ASSERT_GT(flight.points[n].time_ns, before_ns);
        sum += double{speed.values[n]};
    }
    const double mean_mps = sum / static_cast<double>(flight.points.size());
    EXPECT_GT(mean_mps, 5);
    EXPECT_LT(mean_mps, 20) << "a paraglider";
}

TEST_F(DavosScene, AGapEndsALineAndIsSaid) {
    const Layer& flight = layer("gap");
    EXPECT_GT(flight.entry->feature_count, 1u);
    bool is_said = false;
    for (const std::string& note : state().notes)
        is_said |= note.rfind("gap: ", 0) == 0 && note.find("in the recording") != std::string::npos;
    EXPECT_TRUE(is_said);
}

TEST_F(DavosScene, TrafficIsAnAircraftEach) {
    const Layer& traffic = layer("traffic");
    std::set<std::string> names;
    for (std::uint32_t n = 0; n < traffic.entry->feature_count; ++n) names.insert(std::string(traffic.name_of(n)));
    EXPECT_EQ(names.size(), 2u);
    EXPECT_EQ(names.count("HBKRA"), 1u);
    EXPECT_EQ(traffic.entry->position_accuracy_m, 100);
    std::int64_t latest_ns = 0;
    for (const scene::ScenePoint& point : traffic.points) latest_ns = std::max(latest_ns, point.time_ns);
    EXPECT_EQ(traffic.entry->data_time_ns, latest_ns);
    EXPECT_EQ(traffic.find("track")->entry->of, scene::AttributeOf::point);
}

TEST_F(DavosScene, WeatherHasItsTimesLevelsAndQuality) {
    const Layer &wind = layer("wind"), &radar = layer("radar");
    EXPECT_EQ(wind.entry->grid.times, 7u);
    EXPECT_EQ(wind.levels_m.size(), 6u);
    EXPECT_EQ(wind.entry->valid_until_ns, wind.times_ns[6] + std::int64_t{3600} * 1'000'000'000);
    EXPECT_FALSE(wind.find("east")->uncertainty(0).is_known()) << "nothing is said of it";
    std::size_t known = 0;
    const Attribute& echoes = *radar.find("reflectivity");
    for (std::size_t n = 0; n < echoes.values.size(); ++n) known += echoes.uncertainty(n).is_known() ? 1 : 0;
    EXPECT_GT(known, echoes.values.size() / 4);
    EXPECT_LT(known, echoes.values.size() / 2) << "the composite states -9999000 where it has no quality, which is none";
}

}  // namespace
}  // namespace tedavis::test_scene
