#include "host_sim/input_file.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_input_file {
namespace {

void write_gzip(const std::string& path, const std::string& content) {
    gzFile file = gzopen(path.c_str(), "wb");
    ASSERT_EQ(gzwrite(file, content.data(), static_cast<unsigned>(content.size())), static_cast<int>(content.size()));
    gzclose(file);
}

TEST(InputFile, ReadsBytesAsTheyAre) {
    const test_support::TemporaryFolder folder;
    const std::string bytes("a\0b\r\n", 5);
    EXPECT_EQ(read_file(folder.write("a", bytes)), bytes);
    EXPECT_EQ(read_file(folder.write("empty", "")), "");
}

TEST(InputFile, UnpacksByContentNotByName) {
    const test_support::TemporaryFolder folder;
    const std::string text(300'000, 'z');
    write_gzip(folder.file("plain_name.txt"), text);
    EXPECT_EQ(read_file_unpacked(folder.file("plain_name.txt")), text);
    EXPECT_EQ(read_file_unpacked(folder.write("named.gz", "not packed")), "not packed");
}

TEST(InputFile, RefusesATruncatedStream) {
    const test_support::TemporaryFolder folder;
    std::string text;
    for (int i = 0; i < 20'000; ++i) text += std::to_string(i * 7919 % 10007) + ",";
    write_gzip(folder.file("whole"), text);
    const std::string packed = folder.read("whole");
    for (const std::size_t length : {packed.size() - 1, packed.size() - 9, packed.size() / 2, std::size_t{20}}) {
        folder.write("cut", packed.substr(0, length));
        test_support::expect_user_error([&] { (void)read_file_unpacked(folder.file("cut")); }, "break off or are damaged");
    }
}

TEST(InputFile, RefusesADamagedStream) {
    const test_support::TemporaryFolder folder;
    write_gzip(folder.file("whole"), "the quick brown fox jumps over the lazy dog");
    std::string packed = folder.read("whole");
    packed[packed.size() - 6] = static_cast<char>(packed[packed.size() - 6] ^ 1);  // in the checksum
    folder.write("bad", packed);
    test_support::expect_user_error([&] { (void)read_file_unpacked(folder.file("bad")); }, "damaged");
}

TEST(InputFile, BoundsTheUnpackedSize) {
    const test_support::TemporaryFolder folder;
    write_gzip(folder.file("bomb"), std::string(100'000, ' '));
    test_support::expect_user_error([&] { (void)read_file_unpacked(folder.file("bomb"), 99'999); }, "more than 99999 bytes");
    EXPECT_EQ(read_file_unpacked(folder.file("bomb"), 100'000).size(), 100'000u);
}

TEST(InputFile, NamesWhatIsMissing) {
    const test_support::TemporaryFolder folder;
    test_support::expect_user_error([&] { (void)read_file(folder.file("none")); }, "none: no such file");
    test_support::expect_user_error([&] { (void)read_file_unpacked(folder.path()); }, "is a folder");
}

TEST(InputFile, RefusesDevicesWithoutAnEnd) {
    test_support::expect_user_error([] { (void)read_file("/dev/zero"); }, "/dev/zero: is a device");
    test_support::expect_user_error([] { (void)read_file_unpacked("/dev/zero"); }, "is a device");
}

TEST(InputFile, AnOutputMayNotReplaceAnInput) {
    const test_support::TemporaryFolder folder;
    const std::string input = folder.write("a", "x");
    require_other_file(folder.file("b"), {input});
    test_support::expect_user_error(
        [&] {
            require_other_file(folder.path() + "/./a", {folder.file("c"), input});
        },
        "is also an input");
}

TEST(InputFile, ALogReplacesLogsOnly) {
    const test_support::TemporaryFolder folder;
    for (const char* const other :
         {"(a note)\n", "(12) can0", "1780322400.0 can0", "(.5) x", "(5.) x", "(5.5)x", "(1780322400.000000"}) {
        folder.write("mine.log", other);
        test_support::expect_user_error([&] { require_replaceable_log(folder.file("mine.log")); },
                                        "mine.log: is there already and is no candump log");
        EXPECT_EQ(folder.read("mine.log"), other);
    }
    folder.write("own.log", "(1780322400.000000) can0 137#0902000000000000\n");
    folder.write("short.log", "(0.0) v 1#");
    folder.write("empty.log", "");
    for (const char* const name : {"own.log", "short.log", "empty.log", "none.log"})
        EXPECT_NO_THROW(require_replaceable_log(folder.file(name))) << name;
}

TEST(InputFile, AnOutputReplacesItsOwnKindOnly) {
    const test_support::TemporaryFolder folder;
    const auto require = [&](const char* name) { require_replaceable(folder.file(name), "MAGIC", "such database"); };
    for (const char* const other : {"lon,lat\n1,2\n", "MAGI", "magic..", " MAGIC"}) {
        folder.write("mine.csv", other);
        test_support::expect_user_error([&] { require("mine.csv"); }, "mine.csv: is there already and is no such database");
        EXPECT_EQ(folder.read("mine.csv"), other);
    }
    folder.write("own", "MAGIC and more");
    folder.write("empty", "");
    for (const char* const replaceable : {"own", "empty", "none"}) EXPECT_NO_THROW(require(replaceable)) << replaceable;
    EXPECT_NO_THROW(require_replaceable(folder.path(), "MAGIC", "such database")) << "the writer says what a folder is";
}

}  // namespace
}  // namespace tedavis::host_sim::test_input_file
