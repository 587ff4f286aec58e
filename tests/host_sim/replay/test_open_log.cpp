#include "host_sim/replay/open_log.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_open_log {
namespace {

std::string bytes_of(base::ByteSource& source) {
    std::string bytes(source.size(), '\0');
    EXPECT_TRUE(source.read(0, bytes.data(), bytes.size()));
    return bytes;
}

TEST(OpenLog, GivesWhatACompressedFileHoldsWhateverItsName) {
    const test_support::TemporaryFolder folder;
    const std::string text(100'000, 'z');
    gzFile file = gzopen(folder.file("packed.log").c_str(), "wb");
    ASSERT_EQ(gzwrite(file, text.data(), static_cast<unsigned>(text.size())), static_cast<int>(text.size()));
    gzclose(file);
    const auto packed = open_log(folder.file("packed.log")), plain = open_log(folder.write("plain.log.gz", "not packed"));
    EXPECT_EQ(bytes_of(*packed), text);
    EXPECT_EQ(bytes_of(*plain), "not packed");
    char one = 0;
    EXPECT_TRUE(packed->read(99'999, &one, 1));
    EXPECT_EQ(one, 'z');
    EXPECT_FALSE(packed->read(99'999, &one, 2)) << "beyond the end";
    EXPECT_FALSE(packed->read(100'001, &one, 1));
}

TEST(OpenLog, RefusesWhatCannotBeRead) {
    const test_support::TemporaryFolder folder;
    test_support::expect_user_error([&] { (void)open_log(folder.file("none.log")); }, "none.log");
    test_support::expect_user_error([&] { (void)open_log(folder.path()); }, folder.path());
    test_support::expect_user_error([&] { (void)open_log(folder.write("cut.log.gz", "\x1f\x8b\x08")); },
                                    "cut.log.gz: the compressed data break off");
    EXPECT_EQ(open_log(folder.write("empty.log", ""))->size(), 0u) << "whoever reads it says that it holds no frame";
}

}  // namespace
}  // namespace tedavis::host_sim::test_open_log
