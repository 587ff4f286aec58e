#include "host_sim/png_file.hpp"

#include <gtest/gtest.h>

#include "host_sim/user_error.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_png_file {
namespace {

RgbaPicture pattern(std::uint32_t width, std::uint32_t height) {
    RgbaPicture picture{width, height, {}};
    for (std::uint32_t i = 0; i < width * height * 4; ++i)
        picture.pixels.push_back(static_cast<std::uint8_t>(i * 2654435761u >> 24));
    return picture;
}

TEST(PngFile, KeepsEveryPixelAndAlpha) {
    const test_support::TemporaryFolder folder;
    for (const auto& [width, height] : {std::pair{1u, 1u}, std::pair{7u, 3u}, std::pair{64u, 48u}}) {
        const RgbaPicture picture = pattern(width, height);
        write_png(folder.file("a.png"), view_of(picture));
        const RgbaPicture back = read_png(folder.file("a.png"));
        EXPECT_EQ(back.width, width);
        EXPECT_EQ(back.height, height);
        EXPECT_EQ(back.pixels, picture.pixels);
    }
}

TEST(PngFile, GreyReadsBackAsGrey) {
    const test_support::TemporaryFolder folder;
    const std::vector<std::uint8_t> grey{0, 1, 2, 200, 254, 255};
    const RgbaPicture back = read_png(folder.write("grey.png", encode_grey_png({grey.data(), 3, 2})));
    ASSERT_EQ(back.pixels.size(), 24u);
    EXPECT_EQ(back.width, 3u);
    for (std::size_t n = 0; n < grey.size(); ++n)
        for (std::size_t channel = 0; channel < 3; ++channel) EXPECT_EQ(back.pixels[4 * n + channel], grey[n]);
}

TEST(PngFile, TurnsGlRowsRound) {
    const RgbaPicture picture = pattern(2, 3);
    RgbaPicture turned = picture;
    for (std::size_t y = 0; y < 3; ++y) std::copy_n(&picture.pixels[y * 8], 8, &turned.pixels[(2 - y) * 8]);
    EXPECT_EQ(encode_png({turned.pixels.data(), 2, 3, true}), encode_png(view_of(picture)));
    EXPECT_NE(encode_png(view_of(turned)), encode_png(view_of(picture)));
    EXPECT_EQ(upright({turned.pixels.data(), 2, 3, true}).pixels, picture.pixels);
    EXPECT_EQ(upright(view_of(picture)).pixels, picture.pixels);
}

TEST(PngFile, RefusesDamage) {
    const test_support::TemporaryFolder folder;
    const std::string whole = encode_png(view_of(pattern(32, 32)));
    test_support::expect_user_error([&] { (void)read_png(folder.write("none.png", "no picture")); }, "not a sound PNG");
    test_support::expect_user_error([&] { (void)read_png(folder.write("cut.png", whole.substr(0, whole.size() / 2))); },
                                    "not a sound PNG");
    test_support::expect_user_error([&] { (void)read_png(folder.file("missing.png")); }, "no such file");
    std::string flipped = whole;
    flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 4);
    test_support::expect_user_error([&] { (void)read_png(folder.write("flipped.png", flipped)); }, "not a sound PNG");
}

TEST(PngFile, ShrinksByMeansOfWholeBlocks) {
    RgbaPicture picture{5, 2, std::vector<std::uint8_t>(40, 0)};
    for (std::size_t x = 0; x < 5; ++x) picture.pixels[x * 4] = static_cast<std::uint8_t>(40 * x);  // red of the top row
    const RgbaPicture small = shrunk(view_of(picture), 3);
    ASSERT_EQ(small.width, 3u);
    ASSERT_EQ(small.height, 1u);
    EXPECT_EQ(small.pixels[0], 10);  // (0 + 40 + 0 + 0) / 4
    EXPECT_EQ(small.pixels[4], 50);  // (80 + 120) / 4
    EXPECT_EQ(small.pixels[8], 80);  // the cut block: 160 / 2
    EXPECT_EQ(shrunk(view_of(picture), 5).pixels, picture.pixels);
}

TEST(PngFile, SmallOnesKeepTheColors) {
    const test_support::TemporaryFolder folder;
    for (const bool is_grey : {false, true}) {
        RgbaPicture picture = pattern(33, 21);
        for (std::size_t at = 0; at < picture.pixels.size(); at += 4) {
            if (is_grey) picture.pixels[at + 1] = picture.pixels[at + 2] = picture.pixels[at];
            picture.pixels[at + 3] = 255;
        }
        const std::string bytes = encode_small_png(view_of(picture));
        EXPECT_EQ(read_png(folder.write("s.png", bytes)).pixels, picture.pixels);
        EXPECT_EQ(bytes[25], is_grey ? 0 : 2) << "the colour type";
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_png_file
