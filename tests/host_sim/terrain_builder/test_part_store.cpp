#include "host_sim/terrain_builder/part_store.hpp"

#include <gtest/gtest.h>

#include <string>

#include "render_core/base/hash.hpp"

namespace tedavis::host_sim::test_part_store {
namespace {

TEST(PartStore, ChecksumsAreThoseOfTheDisplay) {
    std::string bytes;
    for (int n = 0; n < 1000; ++n) {
        EXPECT_EQ(checksum(bytes.data(), bytes.size()), base::crc32(bytes.data(), bytes.size()));
        bytes.push_back(static_cast<char>(n * 37 + 11));
    }
    EXPECT_EQ(checksum("123456789", 9), 0xCBF43926u) << "the check value of ISO 3309's polynomial";
}

}  // namespace
}  // namespace tedavis::host_sim::test_part_store
