#include "host_sim/palette_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_palette_picture {
namespace {

/// A sky that grows lighter downwards, and a small red square.
RgbaPicture sky_with_a_square() {
    RgbaPicture picture{160, 120, {}};
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            const bool is_square = x >= 80 && x < 84 && y >= 60 && y < 64;
            const auto light = static_cast<std::uint8_t>(y + x / 2);
            picture.pixels.insert(picture.pixels.end(),
                                  {is_square ? std::uint8_t{250} : light, is_square ? std::uint8_t{10} : light,
                                   is_square ? std::uint8_t{20} : std::uint8_t{200}, 255});
        }
    return picture;
}

RgbaPicture shown(const PalettePicture& picture) {
    const test_support::TemporaryFolder folder;
    return read_png(folder.write("palette.png", encode_palette_png(picture)));
}

double rms(const RgbaPicture& a, const RgbaPicture& b) {
    double sum = 0;
    for (std::size_t n = 0; n < a.pixels.size(); ++n) sum += std::pow(a.pixels[n] - b.pixels[n], 2);
    return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

TEST(PalettePicture, OfFewColorsIsThePictureItself) {
    RgbaPicture picture{16, 16, {}};
    for (int n = 0; n < 256; ++n)
        picture.pixels.insert(picture.pixels.end(), {static_cast<std::uint8_t>(n), static_cast<std::uint8_t>(255 - n), 7, 255});
    const PalettePicture reduced = with_palette(view_of(picture));
    EXPECT_EQ(reduced.colors.size(), 256u);
    EXPECT_EQ(shown(reduced).pixels, picture.pixels);
    EXPECT_NE(shown(with_palette(view_of(picture), 255)).pixels, picture.pixels) << "control";
    RgbaPicture grey{3, 2, std::vector<std::uint8_t>(24, 255)};
    EXPECT_EQ(with_palette(view_of(grey)).colors.size(), 1u);
}

TEST(PalettePicture, EachColorIsTheMeanOfWhatItStandsFor) {
    const RgbaPicture picture = sky_with_a_square();
    const PalettePicture reduced = with_palette(view_of(picture), 24);
    EXPECT_EQ(reduced.colors.size(), 24u);
    for (std::size_t place = 0; place < reduced.colors.size(); ++place)
        for (std::size_t c = 0; c < 3; ++c) {
            double sum = 0, count = 0;
            for (std::size_t n = 0; n < reduced.pixels.size(); ++n) {
                if (reduced.pixels[n] != place) continue;
                sum += picture.pixels[4 * n + c];
                count += 1;
            }
            ASSERT_GT(count, 0) << place;
            EXPECT_NEAR(reduced.colors[place][c], sum / count, 0.5) << place;
        }
}

TEST(PalettePicture, KeepsSmallThingsAndLosesLess) {
    const RgbaPicture picture = sky_with_a_square();
    const RgbaPicture of_eight = shown(with_palette(view_of(picture), 8));
    const std::uint8_t* square = &of_eight.pixels[(62u * 160 + 82) * 4];
    EXPECT_EQ(std::vector<int>(square, square + 3), (std::vector<int>{250, 10, 20}));
    EXPECT_LT(rms(picture, shown(with_palette(view_of(picture)))), 1.0);
    EXPECT_GT(rms(picture, of_eight), 3.0) << "control";
}

TEST(PalettePicture, TakesRowsInAnyOrder) {
    const RgbaPicture picture = sky_with_a_square();
    RgbaPicture turned{picture.width, picture.height, {}};
    for (std::uint32_t y = picture.height; y-- > 0;)
        turned.pixels.insert(turned.pixels.end(), &picture.pixels[std::size_t{y} * 640],
                             &picture.pixels[std::size_t{y} * 640] + 640);
    const std::string bytes = encode_palette_png(with_palette(view_of(picture)));
    EXPECT_EQ(bytes, encode_palette_png(with_palette({turned.pixels.data(), turned.width, turned.height, true})));
    EXPECT_NE(bytes, encode_palette_png(with_palette(view_of(turned)))) << "control";
}

}  // namespace
}  // namespace tedavis::host_sim::test_palette_picture
