#include "platform/programs/program_folder.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::platform::test_program_folder {
namespace {

constexpr std::uint64_t kKey = 0x0123456789abcdefu;
constexpr unsigned char kBinary[] = {1, 2, 3, 250, 0, 7};

std::string file_bytes(std::uint64_t key) {
    unsigned char header[kProgramHeaderBytes];
    write_program_header(key, {0x8e60, kBinary}, header);
    std::string bytes(reinterpret_cast<const char*>(header), sizeof header);
    return bytes.append(reinterpret_cast<const char*>(kBinary), sizeof kBinary);
}

struct ProgramFolderTest : testing::Test {
    void write(const std::string& bytes) { folder.write("0123456789abcdef.program", bytes); }
    bool finds(std::uint64_t key) {
        auto opened = open_program_folder(folder.path());
        return opened.ok() && opened.value().find(key, program);
    }
    test_support::TemporaryFolder folder;
    base::StoredProgram program;
};

TEST_F(ProgramFolderTest, GivesBackWhatWasWritten) {
    EXPECT_EQ(program_file_name(kKey).view(), "0123456789abcdef.program");
    write(file_bytes(kKey));
    auto opened = open_program_folder(folder.path());
    ASSERT_TRUE(opened.ok());
    ASSERT_TRUE(opened.value().find(kKey, program));
    EXPECT_EQ(program.format, 0x8e60u);
    ASSERT_EQ(program.binary.size(), sizeof kBinary);
    EXPECT_TRUE(std::equal(program.binary.begin(), program.binary.end(), kBinary));
    EXPECT_FALSE(opened.value().find(kKey + 1, program)) << "no such file";
}

TEST_F(ProgramFolderTest, TakesNoDamagedProgram) {
    const std::string whole = file_bytes(kKey);
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 4);
        write(damaged);
        EXPECT_FALSE(finds(kKey)) << at;
        write(whole.substr(0, at));
        EXPECT_FALSE(finds(kKey)) << at;
    }
    write(file_bytes(kKey + 1));
    EXPECT_FALSE(finds(kKey)) << "renamed";
    write(whole);
    EXPECT_TRUE(finds(kKey));
}

TEST_F(ProgramFolderTest, SaysWhereThereIsNoFolder) {
    const auto missing = open_program_folder(folder.file("none"));
    ASSERT_FALSE(missing.ok());
    EXPECT_NE(missing.error().message.view().find("no folder of programs; make it with"), std::string_view::npos);
    EXPECT_FALSE(open_program_folder(std::string(2000, 'a')).ok());
    EXPECT_FALSE(ProgramFolder().find(kKey, program));
    EXPECT_TRUE(ProgramFolder().room(4).empty());
    EXPECT_FALSE(ProgramFolder().keep(kKey, "terrain", program));
}

}  // namespace
}  // namespace tedavis::platform::test_program_folder
