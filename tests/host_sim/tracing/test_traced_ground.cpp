#include "host_sim/tracing/traced_ground.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/atomic_file.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::host_sim::test_traced_ground {
namespace {

std::string written(const TemporaryFolder& folder, const test_support::TdbSpec& spec) {
    const test_support::WrittenTdb tdb(spec);
    const std::string path = folder.path() + "/ground.tdb";
    write_file_atomically(path, std::string(tdb.bytes.begin(), tdb.bytes.end()));
    return path;
}

test_support::TdbSpec hills(double step_m) {
    test_support::TdbSpec spec;
    spec.columns = 70;
    spec.rows = 50;
    spec.height_m = [step_m](std::uint32_t i, std::uint32_t j) {
        return step_m * std::round(300 + 90 * std::sin(0.3 * i + 0.2 * j));
    };
    spec.measured = false;
    return spec;
}

TEST(TracedGround, KeepsWholeMetresInSixteenBits) {
    const TemporaryFolder folder;
    base::SerialWorkers workers;
    const TracedGround ground(written(folder, hills(1)), workers);
    ASSERT_TRUE(ground.is_whole());
    EXPECT_EQ(ground.bytes(), 70u * 50u * 2u);
    const auto grid = ground.grid<std::int16_t>();
    for (const auto& [i, j] : {std::pair{0u, 0u}, {69u, 49u}, {31u, 17u}})
        EXPECT_EQ(grid.posts[j * grid.stride + i], std::round(300 + 90 * std::sin(0.3 * i + 0.2 * j)));
}

TEST(TracedGround, KeepsOthersInFloats) {
    const TemporaryFolder folder;
    base::SerialWorkers workers;
    const TracedGround ground(written(folder, hills(0.25)), workers);
    ASSERT_FALSE(ground.is_whole());
    EXPECT_EQ(ground.bytes(), 70u * 50u * 4u);
    EXPECT_EQ(ground.grid<float>().posts[17 * 70 + 31], 0.25f * std::round(300 + 90 * std::sin(0.3f * 31 + 0.2f * 17)));
}

TEST(TracedGround, IsPagedWhereItTakesMoreThanItMay) {
    const TemporaryFolder folder;
    base::SerialWorkers workers;
    const std::vector<raytrace::TraceSettings> settings = {raytrace::TraceSettings()};
    const std::string whole = written(folder, hills(1));
    const std::uint64_t bytes = TracedGround(whole, workers, {1'000'000, settings}).bytes_in_memory();
    EXPECT_GT(bytes, 70u * 50u * 2u * 4 / 3) << "heights and their bounds";
    const TracedGround held(whole, workers, {bytes, settings}), paged(whole, workers, {bytes - 1, settings});
    EXPECT_FALSE(held.is_paged());
    EXPECT_TRUE(paged.is_paged());
    EXPECT_EQ(paged.bytes(), 0u);
    EXPECT_EQ(paged.bytes_in_memory(), bytes);
    // Whether heights are whole is known only when they are read: these fit two bytes each, but are floats.
    const TracedGround floats(written(folder, hills(0.25)), workers, {bytes, settings});
    EXPECT_TRUE(floats.is_paged());
    EXPECT_GT(floats.bytes_in_memory(), bytes * 3 / 2);
}

TEST(TracedGround, TellsTheHeightOfAPostWhetherPagedOrNot) {
    const TemporaryFolder folder;
    base::SerialWorkers workers;
    const std::string path = written(folder, hills(1));
    for (const std::uint64_t bytes : {std::uint64_t{1'000'000}, std::uint64_t{1}}) {
        const TracedGround ground(path, workers, {bytes, {}});
        EXPECT_EQ(ground.is_paged(), bytes == 1);
        for (const auto& [i, j] : {std::pair{0u, 0u}, {69u, 49u}, {32u, 17u}})
            EXPECT_EQ(ground.height_near({i + 0.4, j - 0.4, 0}), std::round(300 + 90 * std::sin(0.3 * i + 0.2 * j)));
        EXPECT_FALSE(ground.height_near({70, 10, 0}).has_value());
        EXPECT_FALSE(ground.height_near({std::nan(""), 10, 0}).has_value());
    }
}

TEST(TracedGround, RefusesTheWholeEarthAndDamage) {
    const TemporaryFolder folder;
    base::SerialWorkers workers;
    test_support::TdbSpec earth = test_support::whole_earth(129, 65);
    earth.height_m = [](std::uint32_t, std::uint32_t) { return 0.0; };
    earth.measured = false;
    const std::string round = written(folder, earth);
    test_support::expect_user_error([&] { const TracedGround ground(round, workers); }, "--bounds");

    const std::string path = written(folder, hills(1));
    std::string image = read_file(path);
    const test_support::WrittenTdb tdb(hills(1));
    image[tdb.entry({0, 0, 0}).payload.offset + 5] ^= 1;
    write_file_atomically(path, image);
    test_support::expect_user_error([&] { const TracedGround ground(path, workers); }, path);
}

}  // namespace
}  // namespace tedavis::host_sim::test_traced_ground
