#include "platform/files/file_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::platform::test_file_text {
namespace {

using ::testing::HasSubstr;

TEST(FileText, HoldsTheWholeFileAndOutlivesTheMove) {
    const test_support::TemporaryFolder folder;
    const std::string content("a\0b\n", 4);
    auto text = read_file_text(folder.write("x", content).c_str());
    ASSERT_TRUE(text.ok());
    const FileText moved = std::move(text.value());
    EXPECT_EQ(moved.view(), content);
    EXPECT_EQ(read_file_text(folder.write("empty", "").c_str()).value().view(), "");
}

TEST(FileText, RefusesWhatIsNoConfiguration) {
    const test_support::TemporaryFolder folder;
    const auto message = [](const std::string& path) { return std::string(read_file_text(path.c_str()).error().message.view()); };
    EXPECT_THAT(message(folder.file("absent")), HasSubstr(folder.file("absent")));
    EXPECT_THAT(message(folder.path()), HasSubstr(folder.path())) << "a folder";
    EXPECT_THAT(message(folder.write("big", std::string(kMaxFileTextBytes + 1, ' '))), HasSubstr("larger than 1 MiB"));
    EXPECT_TRUE(read_file_text(folder.write("full", std::string(kMaxFileTextBytes, ' ')).c_str()).ok());
}

}  // namespace
}  // namespace tedavis::platform::test_file_text
