// What a file must do as a ByteSource stands in tests/contracts; here is what only files do.
#include "platform/files/file_byte_source.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

namespace tedavis::platform {
namespace {

std::string refusal(const char* path) {
    const auto file = open_file(path);
    return file.ok() ? "" : std::string(file.error().sentence.view());
}

TEST(FileByteSource, RefusesInOneSentence) {
    EXPECT_EQ(refusal("/nonexistent/x.tdb"), "file '/nonexistent/x.tdb' cannot be read: No such file or directory");
    EXPECT_EQ(refusal("/tmp"), "file '/tmp' cannot be read: it is not a regular file; name one");
    EXPECT_NE(refusal("/dev/null"), "");
}

TEST(FileByteSource, APipeDoesNotHangTheProgram) {
    const std::string path = "/tmp/tedavis_pipe_" + std::to_string(getpid());
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    EXPECT_NE(refusal(path.c_str()).find("not a regular file"), std::string::npos);
    std::remove(path.c_str());
}

TEST(FileByteSource, AFileThatShrinksGivesFailedReads) {
    char name[] = "/tmp/tedavis_shrink_XXXXXX";
    const int descriptor = mkstemp(name);
    ASSERT_EQ(ftruncate(descriptor, 1000), 0);
    auto file = open_file(name);
    ASSERT_TRUE(file.ok());
    char bytes[100];
    EXPECT_TRUE(file.value().read(900, bytes, 100));
    ASSERT_EQ(ftruncate(descriptor, 950), 0);
    EXPECT_FALSE(file.value().read(900, bytes, 100));
    EXPECT_TRUE(file.value().read(800, bytes, 100));
    close(descriptor);
    std::remove(name);
}

TEST(FileByteSource, MovesWithItsDescriptor) {
    char name[] = "/tmp/tedavis_move_XXXXXX";
    const int descriptor = mkstemp(name);
    ASSERT_EQ(write(descriptor, "abc", 3), 3);
    close(descriptor);
    auto opened = open_file(name);
    ASSERT_TRUE(opened.ok());
    FileByteSource file(std::move(opened.value()));
    char byte = '\0';
    EXPECT_TRUE(file.read(1, &byte, 1));
    EXPECT_EQ(byte, 'b');
    EXPECT_FALSE(opened.value().read(0, &byte, 1));
    std::remove(name);
}

}  // namespace
}  // namespace tedavis::platform
