#include "host_sim/written_files.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_written_files {
namespace {

TEST(WrittenFiles, GoUnlessKept) {
    const test_support::TemporaryFolder place;
    const std::string other = place.write("other", "x");
    for (const bool is_kept : {true, false}) {
        {
            WrittenFiles files;
            files.add(place.file("never written"));
            files.add(place.file("a"));
            (void)place.write("a", "x");
            if (is_kept) files.keep();
        }
        EXPECT_EQ(place.entries(), is_kept ? 2u : 1u);
    }
}

TEST(WrittenFiles, WhatWasThereBeforeComesBackUnlessKept) {
    const test_support::TemporaryFolder place;
    (void)place.write("old", "before");
    {
        WrittenFiles files;
        files.add_new(place.file("old"));
        files.add_new(place.file("new"));
        (void)place.write("old", "replaced");
        (void)place.write("new", "now");
    }
    EXPECT_EQ(place.entries(), 1u);
    EXPECT_EQ(place.read("old"), "before");
    {
        WrittenFiles files;
        files.add_new(place.file("old"));
        (void)place.write("old", "replaced");
        files.add_new(place.file("old"));
        files.keep();
    }
    EXPECT_EQ(place.entries(), 1u);
    EXPECT_EQ(place.read("old"), "replaced");
}

}  // namespace
}  // namespace tedavis::host_sim::test_written_files
