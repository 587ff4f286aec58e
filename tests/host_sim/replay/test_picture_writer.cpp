#include "host_sim/replay/picture_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/input_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_picture_writer {
namespace {

RgbaPicture picture(int number) {
    RgbaPicture made;
    made.width = 40;
    made.height = 30;
    for (std::uint32_t n = 0; n < made.width * made.height * 4; ++n)
        made.pixels.push_back(static_cast<std::uint8_t>(n * static_cast<std::uint32_t>(number + 3) >> 3));
    return made;
}

class PictureWriterFiles : public ::testing::Test {
protected:
    [[nodiscard]] std::string path(int number) const { return folder_.file(std::to_string(number) + ".png"); }
    test_support::TemporaryFolder folder_;
};

TEST_F(PictureWriterFiles, HaveTheBytesThatWritePngGives) {
    PictureWriter writer;
    for (int n = 0; n < 20; ++n) {
        RgbaPicture shown = picture(n);
        writer.add(path(n), view_of(shown));
        shown.pixels.assign(shown.pixels.size(), 0);  // the next frame is drawn over it
    }
    writer.finish();
    for (int n = 0; n < 20; ++n) EXPECT_EQ(read_file(path(n)), encode_png(view_of(picture(n)))) << n;
}

TEST_F(PictureWriterFiles, APictureFromBelowIsUpright) {
    const RgbaPicture shown = picture(1);
    PictureWriter writer;
    writer.add(path(1), {shown.pixels.data(), shown.width, shown.height, true});
    writer.finish();
    EXPECT_EQ(read_file(path(1)), encode_png({shown.pixels.data(), shown.width, shown.height, true}));
}

TEST_F(PictureWriterFiles, AreWrittenWithoutAnEndThatIsAskedFor) {
    {
        PictureWriter writer;
        for (int n = 0; n < 4; ++n) writer.add(path(n), view_of(picture(n)));
    }
    for (int n = 0; n < 4; ++n) EXPECT_TRUE(std::filesystem::exists(path(n))) << n;
}

TEST_F(PictureWriterFiles, AFailureIsReportedAndNothingIsWrittenAfterIt) {
    PictureWriter writer;
    writer.add(path(0), view_of(picture(0)));
    writer.add(folder_.file("missing/1.png"), view_of(picture(1)));
    test_support::expect_user_error([&] { writer.finish(); }, "missing/1.png");
    test_support::expect_user_error([&] { writer.add(path(2), view_of(picture(2))); }, "missing/1.png");
    EXPECT_TRUE(std::filesystem::exists(path(0)));
    EXPECT_FALSE(std::filesystem::exists(path(2)));
}

TEST_F(PictureWriterFiles, AFailureEndsTheWaitForRoom) {
    PictureWriter writer;
    test_support::expect_user_error(
        [&] {
            for (std::size_t n = 0; n < 10 * PictureWriter::kMaxWaiting; ++n)
                writer.add(folder_.file("missing/1.png"), view_of(picture(1)));
        },
        "missing/1.png");
}

}  // namespace
}  // namespace tedavis::host_sim::test_picture_writer
