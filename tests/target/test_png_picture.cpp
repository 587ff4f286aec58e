#include "target/png_picture.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "host_sim/png_file.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::target::test_png_picture {
namespace {

/// Read by libpng, which knows nothing of the writer.
host_sim::RgbaPicture read_back(std::uint32_t width, std::uint32_t height, const std::vector<std::uint8_t>& pixels) {
    std::vector<std::uint8_t> file(png_bytes(width, height));
    write_png(width, height, {pixels.data(), pixels.size()}, {file.data(), file.size()});
    const test_support::TemporaryFolder folder;
    return host_sim::read_png(folder.write("p.png", std::string(file.begin(), file.end())));
}

TEST(PngPicture, IsReadByLibpngPixelByPixel) {
    std::mt19937 random(7);
    // One pixel, odd edges, and more than one stored block, with a block's end within a pixel.
    for (const auto& [width, height] : {std::pair{1u, 1u}, {17u, 5u}, {21845u % 16384u, 3u}, {640u, 480u}}) {
        std::vector<std::uint8_t> pixels(std::size_t{4} * width * height);
        for (std::uint8_t& byte : pixels) byte = static_cast<std::uint8_t>(random());
        const host_sim::RgbaPicture read = read_back(width, height, pixels);
        ASSERT_EQ(read.width, width);
        ASSERT_EQ(read.height, height);
        std::size_t wrong = 0;
        for (std::uint32_t row = 0; row < height; ++row)
            for (std::uint32_t column = 0; column < width; ++column)
                for (int channel = 0; channel < 3; ++channel) {
                    const std::size_t from_below = 4 * (std::size_t{height - 1 - row} * width + column) + channel;
                    const std::size_t from_above = 4 * (std::size_t{row} * width + column) + channel;
                    wrong += read.pixels[from_above] != pixels[from_below] ? 1 : 0;
                }
        EXPECT_EQ(wrong, 0u) << width << " x " << height;
    }
}

}  // namespace
}  // namespace tedavis::target::test_png_picture
