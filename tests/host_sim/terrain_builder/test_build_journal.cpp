#include "host_sim/terrain_builder/build_journal.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_build_journal {
namespace {

BuildRecord record_of(std::uint32_t stage, std::uint32_t next) {
    BuildRecord record;
    record.stage = stage;
    record.next = next;
    record.end = 1234567890123;
    record.statistics = {-3, 4807, 10, 2};
    return record;
}

void expect_equal(const BuildRecord& a, const BuildRecord& b) {
    EXPECT_EQ(a.stage, b.stage);
    EXPECT_EQ(a.next, b.next);
    EXPECT_EQ(a.end, b.end);
    EXPECT_EQ(a.statistics.min_height_m, b.statistics.min_height_m);
    EXPECT_EQ(a.statistics.max_height_m, b.statistics.max_height_m);
    EXPECT_EQ(a.statistics.valid_posts, b.statistics.valid_posts);
    EXPECT_EQ(a.statistics.void_posts, b.statistics.void_posts);
}

TEST(BuildJournal, TheLastRecordCounts) {
    const test_support::TemporaryFolder place;
    const std::string folder = place.file("w");
    {
        BuildJournal journal(folder, 77);
        EXPECT_FALSE(journal.resumes());
        expect_equal(journal.last(), BuildRecord());
        journal.append(record_of(1, 5));
        journal.append(record_of(2, 9));
    }
    const BuildJournal again(folder, 77);
    EXPECT_TRUE(again.resumes());
    expect_equal(again.last(), record_of(2, 9));
}

TEST(BuildJournal, AHalfWrittenRecordDoesNotCount) {
    const test_support::TemporaryFolder place;
    const std::string folder = place.file("w"), file = folder + "/journal";
    {
        BuildJournal journal(folder, 77);
        journal.append(record_of(1, 5));
        journal.append(record_of(2, 9));
    }
    std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);
    {
        BuildJournal again(folder, 77);
        expect_equal(again.last(), record_of(1, 5));
        again.append(record_of(3, 1));
    }
    expect_equal(BuildJournal(folder, 77).last(), record_of(3, 1));
}

TEST(BuildJournal, ADamagedRecordEndsIt) {
    const test_support::TemporaryFolder place;
    {
        BuildJournal journal(place.file("w"), 77);
        journal.append(record_of(1, 5));
        journal.append(record_of(2, 9));
    }
    std::string bytes = place.read("w/journal");
    bytes[2 * bytes.size() / 3 + 1] = static_cast<char>(bytes[2 * bytes.size() / 3 + 1] ^ 4);
    place.write("w/journal", bytes);
    expect_equal(BuildJournal(place.file("w"), 77).last(), record_of(1, 5));
}

TEST(BuildJournal, AnotherKeyOrAnotherFolderStartsEmpty) {
    const test_support::TemporaryFolder place;
    const std::string folder = place.file("w");
    { BuildJournal(folder, 77).append(record_of(1, 5)); }
    std::ofstream(folder + "/posts") << "old";
    {
        const BuildJournal other(folder, 78);
        EXPECT_FALSE(other.resumes());
        EXPECT_FALSE(std::filesystem::exists(folder + "/posts")) << "what was made from other sources";
    }
    EXPECT_FALSE(BuildJournal(folder, 77).resumes());
    std::ofstream(folder + "/journal") << "no journal at all, but longer than a record of one is by some bytes";
    EXPECT_FALSE(BuildJournal(folder, 77).resumes());
}

}  // namespace
}  // namespace tedavis::host_sim::test_build_journal
