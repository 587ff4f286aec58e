#include "host_sim/tracing/traced_data.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/trace.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::host_sim::test_traced_data {
namespace {

/// A grid over the west of the terrain; its values rise to the east, and doubt to the south.
class TracedDataTest : public ::testing::Test {
protected:
    TracedDataTest() : ground(files.terrain, alone()) {
        const earth::Geodetic upper = at(0, 0), lower = at(ground.columns() - 1.0, ground.rows() - 1.0);
        LayerDraft layer = test_support::small_grid();
        layer.grid = {upper.longitude_rad,
                      upper.latitude_rad,
                      (lower.longitude_rad - upper.longitude_rad) / 6,
                      (upper.latitude_rad - lower.latitude_rad) / 2,
                      4,
                      3,
                      1,
                      1};
        layer.levels_m = {1000};
        layer.times_ns = {0};
        AttributeDraft& values = layer.attributes[0];
        values.values.clear();
        values.uncertainties.clear();
        values.states.clear();
        for (int n = 0; n < 12; ++n) {
            const int row = n / 4;
            values.values.push_back(260 + 10.0f * static_cast<float>(n % 4));
            values.uncertainties.push_back(scene::Uncertainty::from_level(0.5 * row));
            values.states.push_back(scene::ValueState::valid);
        }
        SceneDraft draft = test_support::small_scene();
        draft.layers = {layer};
        write(draft, "data.sdb");
    }
    void write(const SceneDraft& draft, const std::string& name) const {
        const std::vector<unsigned char> bytes = sdb_bytes(draft);
        write_file_atomically(files.folder.file(name), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    earth::Geodetic at(double column, double row) const { return earth::from_ecef(ground.space().position({column, row, 0})); }
    static base::Workers& alone() {
        static base::SerialWorkers workers;
        return workers;
    }
    RgbaPicture draw(const std::string& scene, nlohmann::json* json = nullptr) const {
        TraceOptions options;
        options.terrain.database = files.terrain;
        options.scene = scene;
        options.plan.width = 160;
        options.plan.height = 120;
        options.plan.rounds = 1;
        options.output = files.folder.file("picture.png");
        const auto run = test_support::run_command([&](Console& console) { return run_trace(options, console); }, true);
        if (json != nullptr) *json = run.json();
        return read_png(options.output);
    }

    test_support::FlownFiles files;
    TracedGround ground;
};

TEST_F(TracedDataTest, SamplesTheFieldAndLeavesOutWhatItDoesNotKnow) {
    const TracedData data(ground, files.folder.file("data.sdb"), "", {});
    EXPECT_EQ(data.name(), "air.temperature");
    EXPECT_EQ(data.unit(), "K");
    EXPECT_EQ(data.lowest(), 260);
    EXPECT_EQ(data.highest(), 290);
    EXPECT_NEAR(data.share(), 0.5, 0.02);
    raytrace::TraceLook look;
    data.show(look);
    const double quarter = 0.25 * (ground.columns() - 1), middle = 0.5 * (ground.rows() - 1);
    EXPECT_NEAR(raytrace::value_at(look.values, quarter, middle), 275, 0.5);  // half of the grid's way, in the lattice's angles
    EXPECT_NEAR(raytrace::value_at(look.uncertainties, quarter, middle), 0.5, 0.02);
    EXPECT_TRUE(std::isnan(raytrace::value_at(look.values, 3 * quarter, middle)));
}

TEST_F(TracedDataTest, ColorsTheGroundWhereThereAreDataAndNowhereElse) {
    nlohmann::json json;
    const RgbaPicture without = draw(""), with = draw(files.folder.file("data.sdb"), &json);
    EXPECT_EQ(json.at("data").at("quantity"), "air.temperature");
    const auto colored = [](const RgbaPicture& picture, std::uint32_t from, std::uint32_t to) {
        std::size_t count = 0;
        for (std::uint32_t n = 70 * 160; n < 120 * 160; ++n) {  // ground
            const std::uint8_t* rgb = &picture.pixels[4 * std::size_t{n}];
            const auto [least, most] = std::minmax({rgb[0], rgb[1], rgb[2]});
            count += n % 160 >= from && n % 160 < to && most - least > 40 ? 1 : 0;
        }
        return count;
    };
    EXPECT_GT(colored(with, 0, 60), 200u);   // the west: the eye looks north
    EXPECT_EQ(colored(with, 100, 160), 0u);  // grey, so that no hue of the ground is taken for a value
    EXPECT_GT(colored(without, 0, 160), 0u);
}

TEST_F(TracedDataTest, SaysWhatASceneLacks) {
    const std::string scene = files.folder.file("data.sdb");
    test_support::expect_user_error([&] { TracedData(ground, scene, "snow", {}); }, "air.temperature");
    SceneDraft points = test_support::small_scene();
    points.layers = {test_support::small_points()};
    write(points, "points.sdb");
    test_support::expect_user_error([&] { TracedData(ground, files.folder.file("points.sdb"), "", {}); },
                                    "no quantity on a grid");
    test_support::expect_user_error([&] { TracedData(ground, files.terrain, "", {}); }, files.terrain);
}

}  // namespace
}  // namespace tedavis::host_sim::test_traced_data
