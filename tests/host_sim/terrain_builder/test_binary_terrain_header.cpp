#include "host_sim/terrain_builder/binary_terrain_header.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_binary_terrain_header {
namespace {

/// Bytes as the format's description lays them out.
std::string header(char version, bool external_projection, const char (&scale)[5]) {
    std::string bytes(256, '\0');
    bytes.replace(0, 10, std::string("binterr1.") + version);
    bytes[60] = external_projection ? 1 : 0;
    bytes.replace(62, 4, std::string(scale, 4));
    return bytes;
}

TEST(BinaryTerrainHeader, GivesScaleAndProjectionFile) {
    const test_support::TemporaryFolder folder;
    const auto read = [&](const std::string& bytes) { return read_binary_terrain_header(folder.write("a.bt", bytes)); };
    const auto halves = read(header('3', true, "\0\0\0\x3f"));
    ASSERT_TRUE(halves);
    EXPECT_EQ(halves->metres_per_unit, 0.5);
    EXPECT_TRUE(halves->projection_file_needed);
    const auto metres = read(header('3', false, "\0\0\0\0"));
    ASSERT_TRUE(metres);
    EXPECT_EQ(metres->metres_per_unit, 1) << "zero means metres";
    EXPECT_FALSE(metres->projection_file_needed);
    EXPECT_EQ(read(header('0', true, "\0\0\0\x3f"))->metres_per_unit, 1) << "version 1.0 has no such field";
    EXPECT_EQ(read(header('3', false, "\0\0\xc0\x7f"))->metres_per_unit, 1) << "no number";
    EXPECT_FALSE(read(header('3', true, "\0\0\0\x3f").substr(0, 65)));
    EXPECT_FALSE(read("something else entirely, and long enough to be read as a header of such a file"));
    EXPECT_FALSE(read_binary_terrain_header(folder.file("none.bt")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_binary_terrain_header
