#include "host_sim/replay/video_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/calendar_time.hpp"
#include "tests/support/files/read_film.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_video_file {
namespace {

using test_support::psnr_db;
using ::testing::HasSubstr;

/// Between what encoding costs and what the next picture differs by; both are measured below.
constexpr double kSame_db = 32;

/// Smooth colors with a bright square that moves 8 pixels a picture.
RgbaPicture picture_at(std::uint32_t n, std::uint32_t width = 96, std::uint32_t height = 64) {
    RgbaPicture picture{width, height, {}};
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const bool in_square = x / 16 == n % 5 && y / 16 == 1;
            const std::uint32_t red = in_square ? 250 : 60 + x / 2, green = in_square ? 240 : 40 + y, blue = 120;
            for (const std::uint32_t value : {red, green, blue, 255u}) picture.pixels.push_back(static_cast<std::uint8_t>(value));
        }
    return picture;
}

struct Made {
    test_support::TemporaryFolder folder;

    [[nodiscard]] VideoSettings settings(const std::string& name = "film.mp4") const {
        VideoSettings s;
        s.path = folder.file(name);
        s.width = 96;
        s.height = 64;
        s.step_s = 0.04;
        s.title = "cruise, my.log, not for navigation";
        s.begin = base::Time{1'780'322'520'000'000'000};
        return s;
    }
    void write(const VideoSettings& s, std::uint32_t pictures = 9) const {
        VideoFile video(s);
        for (std::uint32_t n = 0; n < pictures; ++n) video.add(view_of(picture_at(n, s.width, s.height)));
        EXPECT_EQ(video.pictures(), pictures);
        video.commit();
    }
};

void expect_same_pictures(const test_support::ReadFilm& film) {
    for (const std::size_t n : {0u, 4u, 8u}) {
        EXPECT_GT(psnr_db(film.pictures.at(n), picture_at(static_cast<std::uint32_t>(n))), kSame_db) << n;
        EXPECT_LT(psnr_db(film.pictures.at(n), picture_at(static_cast<std::uint32_t>(n + 1))), kSame_db - 8)
            << "control: the next picture is another one";
    }
}

TEST(VideoFile, IsReadBackWithItsPicturesAndItsRate) {
    const Made made;
    made.write(made.settings());
    const auto film = test_support::read_film(made.settings().path);
    ASSERT_EQ(film.pictures.size(), 9u);
    EXPECT_EQ(film.rate_num, 25);
    EXPECT_EQ(film.rate_den, 1);
    EXPECT_NEAR(film.duration_s, 9 * 0.04, 0.002);
    for (std::size_t n = 0; n < 9; ++n) EXPECT_NEAR(film.times_s[n], 0.04 * static_cast<double>(n), 1e-4);
    EXPECT_EQ(film.pictures[0].width, 96u);
    EXPECT_EQ(film.pictures[0].height, 64u);
    expect_same_pictures(film);
}

TEST(VideoFile, SaysTheTimeOfTheFlightAndWhatItMayNotBeUsedFor) {
    const Made made;
    made.write(made.settings());
    auto film = test_support::read_film(made.settings().path);
    EXPECT_EQ(film.metadata["title"], "cruise, my.log, not for navigation");
    EXPECT_THAT(film.metadata["creation_time"], HasSubstr("2026-06-01T14:02:00"));
    EXPECT_EQ(film.metadata["date"], utc_text(made.settings().begin));
    EXPECT_THAT(film.metadata["comment"], HasSubstr("2026-06-01T14:02:00Z. Not for navigation"));
}

TEST(VideoFile, WithoutH264ItIsMpeg4) {
    const Made made;
    VideoSettings s = made.settings();
    s.encoders = {"no_such_encoder", "mpeg4"};
    made.write(s);
    const auto film = test_support::read_film(s.path);
    EXPECT_EQ(film.codec, "mpeg4");
    EXPECT_EQ(film.pictures.size(), 9u);
    EXPECT_EQ(film.rate_num, 25 * film.rate_den);
    expect_same_pictures(film);
}

TEST(VideoFile, RatesAreRational) {
    const Made made;
    for (const auto& [step_s, num, den] : {std::tuple<double, int, int>{1 / 30.0, 30, 1},
                                           {0.033333333, 30, 1},
                                           {1001 / 30'000.0, 30'000, 1001},
                                           {10, 1, 10},
                                           {0.3, 10, 3}})
        for (const char* encoder : {"libx264", "mpeg4"}) {
            VideoSettings s = made.settings();
            s.step_s = step_s;
            s.encoders = {encoder};
            made.write(s, 3);
            const auto film = test_support::read_film(s.path);
            EXPECT_EQ(film.pictures.size(), 3u) << step_s;
            EXPECT_EQ(film.rate_num * den, film.rate_den * num) << step_s << encoder;
        }
}

TEST(VideoFile, EqualPicturesGiveEqualBytesInAnyOrderOfRows) {
    const Made made;
    made.write(made.settings("first.mp4"));
    made.write(made.settings("second.mp4"));
    EXPECT_EQ(made.folder.read("first.mp4"), made.folder.read("second.mp4"));
    VideoFile turned(made.settings("third.mp4"));
    for (std::uint32_t n = 0; n < 9; ++n) {
        const RgbaPicture upside_down = upright({picture_at(n).pixels.data(), 96, 64, true});
        turned.add({upside_down.pixels.data(), 96, 64, true});
    }
    turned.commit();
    EXPECT_EQ(made.folder.read("first.mp4"), made.folder.read("third.mp4"));
    made.write(made.settings("shorter.mp4"), 8);
    EXPECT_NE(made.folder.read("first.mp4"), made.folder.read("shorter.mp4")) << "control";
}

TEST(VideoFile, WithoutCommitNothingAppears) {
    const Made made;
    {
        VideoFile video(made.settings());
        video.add(view_of(picture_at(0)));
    }
    EXPECT_TRUE(std::filesystem::is_empty(made.folder.path()));
}

void refused(const VideoSettings& s, const std::string& words) {
    test_support::expect_user_error([&] { VideoFile video(s); }, words);
    EXPECT_FALSE(std::filesystem::exists(s.path));
}

TEST(VideoFile, RefusesWhatCannotBeAFilm) {
    const Made made;
    VideoSettings s = made.settings();
    s.encoders = {"no_such_encoder", "nor_this"};
    refused(s, "film.mp4: the installed libavcodec has no encoder for it (no_such_encoder, nor_this); install");
    s = made.settings();
    s.width = 97;
    refused(s, "pictures of 97x64 have an odd side; say --size 98x64");
    s = made.settings();
    s.step_s = 0;
    refused(s, "film.mp4: no film has a picture each 0.0");
    refused(made.settings("film.avi"), "film.avi: a film is written as MP4; give --video a name that ends in .mp4");
    refused(made.settings("none/film.mp4"), "none/film.mp4: cannot be written (No such file or directory); check the folder");
}

TEST(VideoFile, AFullDiskIsSaidAndLeavesNothing) {
    const Made made;
    ASSERT_TRUE(std::filesystem::exists("/dev/full"));
    std::filesystem::create_symlink("/dev/full", made.folder.file("film.mp4.part"));
    test_support::expect_user_error([&] { made.write(made.settings(), 3); },
                                    "film.mp4: could not be written to its end; check the free space");
    EXPECT_FALSE(std::filesystem::exists(made.settings().path));
}

}  // namespace
}  // namespace tedavis::host_sim::test_video_file
