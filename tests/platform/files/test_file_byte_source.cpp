// What a file must do as a ByteSource stands in tests/contracts; here is what only files do.
#include "platform/files/file_byte_source.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <utility>

namespace tedavis::platform::test_file_byte_source {
namespace {

std::string write_file(const std::string& content) {
    std::string name = testing::TempDir() + "tedavis_file_" + std::to_string(getpid());
    std::ofstream(name, std::ios::binary) << content;
    return name;
}

std::string refusal(const char* path) {
    const auto file = open_file(path);
    return file.ok() ? "" : std::string(file.error().message.view());
}

TEST(FileByteSource, RefusesInOneSentence) {
    EXPECT_EQ(refusal("/nonexistent/x.tdb"), "/nonexistent/x.tdb: cannot be read (No such file or directory); check the path");
    EXPECT_EQ(refusal("/tmp"), "/tmp: is not a regular file; name one");
    EXPECT_NE(refusal("/dev/null"), "");
}

TEST(FileByteSource, APipeDoesNotHangTheProgram) {
    const std::string path = testing::TempDir() + "tedavis_pipe_" + std::to_string(getpid());
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    EXPECT_NE(refusal(path.c_str()).find("not a regular file"), std::string::npos);
    std::remove(path.c_str());
}

TEST(FileByteSource, AFileThatShrinksGivesFailedReads) {
    const std::string name = write_file(std::string(1000, 'x'));
    auto file = open_file(name.c_str());
    ASSERT_TRUE(file.ok());
    char bytes[100];
    EXPECT_TRUE(file.value().read(900, bytes, 100));
    ASSERT_EQ(truncate(name.c_str(), 950), 0);
    EXPECT_FALSE(file.value().read(900, bytes, 100));
    EXPECT_TRUE(file.value().read(800, bytes, 100));
    std::remove(name.c_str());
}

TEST(FileByteSource, MovesWithItsDescriptor) {
    const std::string name = write_file("abc");
    auto opened = open_file(name.c_str());
    ASSERT_TRUE(opened.ok());
    FileByteSource file(std::move(opened.value()));
    char byte = '\0';
    EXPECT_TRUE(file.read(1, &byte, 1));
    EXPECT_EQ(byte, 'b');
    EXPECT_FALSE(opened.value().read(0, &byte, 1));
    std::remove(name.c_str());
}

}  // namespace
}  // namespace tedavis::platform::test_file_byte_source
