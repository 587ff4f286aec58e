#include "platform/programs/new_program_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::platform::test_new_program_folder {
namespace {

using ::testing::HasSubstr;

constexpr unsigned char kBinary[] = {9, 8, 7, 0, 255};

struct NewProgramFolderTest : testing::Test {
    static bool keep(NewProgramFolder& programs, std::uint64_t key) {
        const base::Span<unsigned char> room = programs.room(sizeof kBinary);
        if (room.size() != sizeof kBinary) return false;
        std::memcpy(room.data(), kBinary, sizeof kBinary);
        return programs.keep(key, "terrain", {0x8e60, room});
    }
    [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(folder.file(name)); }
    test_support::TemporaryFolder folder;
    const std::string path = folder.file("sc2.programs");
};

TEST_F(NewProgramFolderTest, WhatWasKeptIsFoundByTheReader) {
    NewProgramFolder programs;
    ASSERT_EQ(programs.open(path).message.view(), "");
    EXPECT_TRUE(keep(programs, 17));
    EXPECT_TRUE(keep(programs, 18));
    EXPECT_TRUE(keep(programs, 17)) << "again";
    EXPECT_EQ(programs.programs(), 2u);
    EXPECT_FALSE(has("sc2.programs")) << "not before it is whole";
    ASSERT_EQ(programs.commit().message.view(), "");
    EXPECT_FALSE(has("sc2.programs.part"));
    auto reader = open_program_folder(path);
    ASSERT_TRUE(reader.ok());
    base::StoredProgram found;
    for (const std::uint64_t key : {17u, 18u}) {
        ASSERT_TRUE(reader.value().find(key, found));
        EXPECT_EQ(found.format, 0x8e60u);
        EXPECT_TRUE(std::equal(found.binary.begin(), found.binary.end(), std::begin(kBinary), std::end(kBinary)));
    }
    EXPECT_FALSE(reader.value().find(19, found));
}

TEST_F(NewProgramFolderTest, NothingIsLeftOfWhatIsNotCommitted) {
    {
        NewProgramFolder programs;
        ASSERT_FALSE(programs.open(path));
        EXPECT_TRUE(keep(programs, 1));
        EXPECT_TRUE(has("sc2.programs.part"));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(NewProgramFolderTest, WhatIsThereIsNeverReplaced) {
    folder.write("sc2.programs", "mine");
    NewProgramFolder programs;
    EXPECT_EQ(std::string(programs.open(path).message.view()), path + ": is there already; remove it or name another folder");
    folder.write("other.part", "mine");
    NewProgramFolder other;
    EXPECT_THAT(std::string(other.open(folder.file("other")).message.view()), HasSubstr("other.part: is there already"));
    EXPECT_TRUE(has("other.part"));
}

TEST_F(NewProgramFolderTest, AFolderThatCannotBeMadeIsSaid) {
    NewProgramFolder programs;
    EXPECT_THAT(std::string(programs.open(folder.file("none/x")).message.view()),
                HasSubstr("none/x: cannot be made (No such file or directory); check the folder above it"));
    NewProgramFolder longer;
    EXPECT_THAT(std::string(longer.open(std::string(1020, 'x')).message.view()), HasSubstr("longer than 1018 bytes"));
}

TEST_F(NewProgramFolderTest, ABinaryThatCannotBeWrittenIsRefused) {
    NewProgramFolder programs;
    ASSERT_FALSE(programs.open(path));
    EXPECT_TRUE(programs.room(kMaxProgramBytes + 1).empty());
    std::filesystem::remove_all(path + ".part");
    EXPECT_FALSE(keep(programs, 1));
}

}  // namespace
}  // namespace tedavis::platform::test_new_program_folder
