#include "render_core/perception/edge_detector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "tests/support/files/hard_case.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/perception/golden_pictures.hpp"
#include "tests/support/perception/held_edges.hpp"

namespace tedavis::perception::test_edge_detector {
namespace {

using test_support::checkerboard;
using test_support::density_of;
using test_support::edges_of;
using test_support::flat_picture;
using test_support::HeldEdges;
using test_support::landscape;
using test_support::noise_picture;
using test_support::Rgb;
using test_support::SyntheticPicture;

/// OpenCV's detector on each channel, and the maximum of the three.
std::vector<std::uint8_t> edges_of_opencv(const PictureView& picture, const CannySettings& settings) {
    cv::Mat all = cv::Mat::zeros(picture.height, picture.width, CV_8U);
    for (int c = 0; c < 3; ++c) {
        cv::Mat channel(picture.height, picture.width, CV_8U), edges;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) channel.at<std::uint8_t>(y, x) = picture.row(y)[picture.channels * x + c];
        if (settings.sigma > 0)
            cv::GaussianBlur(channel, channel, cv::Size(0, 0), settings.sigma, settings.sigma, cv::BORDER_REPLICATE);
        cv::Canny(channel, edges, settings.low, settings.high, 3, true);
        all |= edges;
    }
    return {all.begin<std::uint8_t>(), all.end<std::uint8_t>()};
}

double share_that_differs(const std::vector<std::uint8_t>& one, const std::vector<std::uint8_t>& other) {
    std::size_t count = 0;
    for (std::size_t n = 0; n < one.size(); ++n) count += one[n] != other[n] ? 1 : 0;
    return static_cast<double>(count) / static_cast<double>(one.size());
}

constexpr double kAgreement = 0.005;  // the issue's: ties and borders

TEST(EdgeDetector, AgreesWithOpenCv) {
    for (const CannySettings settings : {CannySettings{}, {1.4, 40, 90}, {0, 100, 300}, {2.2, 20, 60}, {0.6, 0, 500}})
        for (std::uint32_t seed = 1; seed < 7; ++seed) {
            const SyntheticPicture picture = seed % 2 == 0 ? landscape(320, 217, seed) : noise_picture(201, 160, seed);
            const std::vector<std::uint8_t> edges = edges_of(picture, settings);
            EXPECT_LE(share_that_differs(edges, edges_of_opencv(picture.view(), settings)), kAgreement)
                << settings.sigma << ' ' << seed;
        }
}

TEST(EdgeDetector, AgreesWithOpenCvOnPicturesOfTheDisplay) {
    const std::vector<test_support::NamedPicture> pictures = test_support::golden_pictures(test_support::source_dir());
    EXPECT_GE(pictures.size(), 10u);
    for (const test_support::NamedPicture& of : pictures)
        EXPECT_LE(share_that_differs(edges_of(of.picture), edges_of_opencv(of.picture.view(), {})), kAgreement) << of.name;
}

// Negative control: what is compared depends on every setting, and on all three channels.
TEST(EdgeDetector, OtherSettingsAreOtherEdges) {
    const SyntheticPicture picture = noise_picture(320, 217, 4);
    const std::vector<std::uint8_t> edges = edges_of(picture);
    EXPECT_LE(share_that_differs(edges, edges_of_opencv(picture.view(), {})), kAgreement);
    for (const CannySettings settings : {CannySettings{1, 35, 170}, {1, 70, 340}, {1.5, 70, 170}})
        EXPECT_GT(share_that_differs(edges, edges_of_opencv(picture.view(), settings)), kAgreement);
    const SyntheticPicture grey(320, 217, [&](int x, int y) {
        return Rgb{picture.at(x, y)[0], picture.at(x, y)[0], picture.at(x, y)[0]};
    });
    EXPECT_GT(share_that_differs(edges, edges_of(grey)), kAgreement);
}

TEST(EdgeDetector, FlatPicturesHaveNoEdges) {
    for (const Rgb color : {Rgb{0, 0, 0}, {255, 255, 255}, {128, 128, 128}, {255, 0, 3}}) {
        EXPECT_EQ(density_of(flat_picture(64, 64, color)), 0);
        EXPECT_EQ(density_of(flat_picture(64, 64, color), {0, 0, 0}), 0) << "whatever the thresholds";
    }
    EXPECT_EQ(density_of(noise_picture(64, 64, 3, 128, 2)), 0) << "nor does noise of one level";
}

/// The naive form: thresholds are shares of the picture's own gradients, and beyond its borders the picture is black.
std::int64_t edges_by_share(const SyntheticPicture& picture) {
    cv::Mat red(picture.height, picture.width, CV_8U), wide, dx, dy, edges;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) red.at<std::uint8_t>(y, x) = picture.at(x, y)[0];
    cv::copyMakeBorder(red, wide, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    cv::Sobel(wide, dx, CV_16S, 1, 0);
    cv::Sobel(wide, dy, CV_16S, 0, 1);
    std::vector<int> gradients;
    for (int y = 0; y < wide.rows; ++y)
        for (int x = 0; x < wide.cols; ++x)
            gradients.push_back(std::abs(dx.at<std::int16_t>(y, x)) + std::abs(dy.at<std::int16_t>(y, x)));
    std::sort(gradients.begin(), gradients.end());
    const double high = gradients[gradients.size() * 9 / 10];
    cv::Canny(dx, dy, edges, 0.4 * high, high);
    return std::count(edges.begin<std::uint8_t>(), edges.end<std::uint8_t>(), kEdge);
}

TEST(EdgeDetector, ThresholdsByShareWouldFindEdgesInFlatPictures) {
    std::int64_t ours = 0, naive = 0;
    for (const SyntheticPicture& picture :
         {flat_picture(64, 64, {128, 128, 128}), flat_picture(64, 64, {255, 255, 255}), noise_picture(64, 64, 3, 128, 2)}) {
        const std::vector<std::uint8_t> edges = edges_of(picture);
        ours = std::max<std::int64_t>(ours, std::count(edges.begin(), edges.end(), kEdge));
        EXPECT_GT(edges_by_share(picture), 100) << "control";
        naive = std::max(naive, edges_by_share(picture));
    }
    EXPECT_EQ(ours, 0);
    test_support::record_worst("A40", static_cast<double>(ours));
    test_support::record_control("A40", static_cast<double>(naive));
}

TEST(EdgeDetector, AStepIsOneEdgeInEachRow) {
    for (const double sigma : {0.0, 1.0, 2.0}) {
        const SyntheticPicture step(40, 30, [](int x, int) { return x < 17 ? Rgb{20, 20, 20} : Rgb{200, 200, 200}; });
        const std::vector<std::uint8_t> edges = edges_of(step, {sigma, 20, 40});
        for (std::size_t y = 0; y < 30; ++y) {
            EXPECT_EQ(std::count(edges.begin() + 40 * y, edges.begin() + 40 * (y + 1), kEdge), 1);
            EXPECT_TRUE(edges[40 * y + 16] == kEdge || edges[40 * y + 17] == kEdge);
        }
    }
}

TEST(EdgeDetector, AColorAloneCounts) {
    for (std::size_t c = 0; c < 3; ++c) {
        const SyntheticPicture step(40, 30, [c](int x, int) {
            Rgb color{100, 100, 100};
            color[c] = x < 17 ? 20 : 200;
            return color;
        });
        EXPECT_NEAR(density_of(step), 1.0 / 38, 1e-12);
    }
}

// Away from corners a board of squares of s pixels has one edge pixel a row and a column every s: 2/s - 1/s^2 of all, but that
// edges part at the corners, where four squares meet and no gradient is, by some pixels that a blur of one pixel reaches.
TEST(EdgeDetector, ACheckerboardHasTheDensityOfItsLines) {
    for (const int side : {16, 32, 64}) {
        const double s = side, lines = 2 / s - 1 / (s * s);
        EXPECT_NEAR(density_of(checkerboard(12 * side + 2, 12 * side + 2, side)), lines, 8 / (s * s) + 0.1 * lines) << side;
    }
    EXPECT_EQ(density_of(checkerboard(64, 64, 1)), 0) << "a board of single pixels is blurred to grey";
}

TEST(EdgeDetector, BrighterByAConstantIsTheSame) {
    const SyntheticPicture dark = noise_picture(150, 90, 9, 10, 150);
    const SyntheticPicture bright(150, 90, [&](int x, int y) {
        Rgb color = dark.at(x, y);
        for (std::uint8_t& level : color) level = static_cast<std::uint8_t>(level + 60);
        return color;
    });
    EXPECT_EQ(edges_of(dark), edges_of(bright));
}

/// Share of edge pixels without one among the pixel and its neighbours in the other.
double share_without_partner(const std::vector<std::uint8_t>& one, const std::vector<std::uint8_t>& other, int width,
                             int height) {
    std::size_t edges = 0, alone = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (one[pixels_of(width, y) + static_cast<std::size_t>(x)] == 0) continue;
            bool has_partner = false;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
                    has_partner |= other[pixels_of(width, v) + static_cast<std::size_t>(u)] != 0;
            ++edges;
            alone += has_partner ? 0 : 1;
        }
    return edges == 0 ? 0 : static_cast<double>(alone) / static_cast<double>(edges);
}

// Gradients are the same to the bit; where two pixels of an edge are equal, the left or upper one is chosen, so that edges move
// by a pixel.
TEST(EdgeDetector, TurnsAndMirrorsWithThePicture) {
    const SyntheticPicture picture = landscape(211, 170, 6);
    const std::vector<std::uint8_t> edges = edges_of(picture);
    SyntheticPicture mirrored = picture.mirrored(), turned = picture.turned();
    const auto as_picture = [](const std::vector<std::uint8_t>& bytes, int width, int height) {
        return SyntheticPicture(width, height, [&](int x, int y) {
            const std::uint8_t level = bytes[pixels_of(width, y) + static_cast<std::size_t>(x)];
            return Rgb{level, level, level};
        });
    };
    const auto red = [](const SyntheticPicture& of) {
        std::vector<std::uint8_t> bytes;
        for (std::size_t n = 0; n < of.pixels.size(); n += 3) bytes.push_back(of.pixels[n]);
        return bytes;
    };
    const std::vector<std::uint8_t> expected_mirrored = red(as_picture(edges, 211, 170).mirrored());
    const std::vector<std::uint8_t> expected_turned = red(as_picture(edges, 211, 170).turned());
    EXPECT_LE(share_without_partner(edges_of(mirrored), expected_mirrored, 211, 170), 0.005);
    EXPECT_LE(share_without_partner(expected_mirrored, edges_of(mirrored), 211, 170), 0.005);
    EXPECT_LE(share_without_partner(edges_of(turned), expected_turned, 170, 211), 0.005);
    EXPECT_LE(share_without_partner(expected_turned, edges_of(turned), 170, 211), 0.005);
    EXPECT_NEAR(density_of(mirrored), density_of(picture), 0.01 * density_of(picture));
    EXPECT_NEAR(density_of(turned), density_of(picture), 0.01 * density_of(picture));
    EXPECT_GT(share_without_partner(edges, expected_mirrored, 211, 170), 0.1) << "which the comparison can tell";
}

TEST(EdgeDetector, AnySizeWorksAndGivesTheSameInLargerMemory) {
    HeldEdges large(400, 300);
    const std::vector<std::pair<int, int>> sizes = {{1, 1},  {2, 3},     {1, 40},    {40, 1}, {16, 16},
                                                    {17, 5}, {400, 300}, {399, 299}, {3, 2}};
    for (const auto& [width, height] : sizes) {
        const SyntheticPicture picture = noise_picture(width, height, 7);
        const std::vector<std::uint8_t> edges = large.of(picture.view());
        EXPECT_EQ(edges, edges_of(picture)) << width << 'x' << height;
        EXPECT_EQ(edges, large.of(picture.view())) << "twice the same";
        EXPECT_EQ(edges, edges_of_opencv(picture.view(), {})) << width << 'x' << height;
    }
}

TEST(EdgeDetector, PicturesOfOddSizeAgreeToo) {
    const SyntheticPicture picture = landscape(1919, 1079, 8);
    EXPECT_LE(share_that_differs(edges_of(picture), edges_of_opencv(picture.view(), {})), kAgreement);
}

// In noise everything hangs together, and more branches wait than there is room for.
TEST(EdgeDetector, WhatFindsNoRoomToWaitIsConnectedAll) {
    const SyntheticPicture picture = noise_picture(600, 500, 2);
    const CannySettings settings{0.6, 0, 600};
    const std::vector<std::uint8_t> edges = edges_of(picture, settings);
    EXPECT_GT(std::count(edges.begin(), edges.end(), kEdge), 20'000);
    EXPECT_EQ(edges, edges_of_opencv(picture.view(), settings));
}

TEST(EdgeDetector, ReadsFourChannelsAndRowsFromBelow) {
    const SyntheticPicture picture = landscape(100, 60, 2);
    std::vector<std::uint8_t> upside_down(pixels_of(110, 60) * 4, 200);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 100; ++x) {
            const Rgb color = picture.at(x, y);
            std::copy(color.begin(), color.end(), upside_down.begin() + (59 - y) * 440 + 4 * x);
            upside_down[pixels_of(440, 59 - y) + 4 * static_cast<std::size_t>(x) + 3] = static_cast<std::uint8_t>(x * y);
        }
    HeldEdges held(100, 60);
    EXPECT_EQ(held.of({upside_down.data() + 59 * 440, 100, 60, 4, -440}), edges_of(picture));
}

TEST(EdgeDetector, RefusesWhatItCannotDo) {
    const SyntheticPicture picture = noise_picture(20, 10, 1);
    HeldEdges held(20, 10);
    for (const CannySettings settings : {CannySettings{-1, 70, 170}, {4, 70, 170}, {1, 170, 70}, {1, -1, 70}})
        EXPECT_TRUE(held.detector.detect(picture.view(), settings).empty());
    EXPECT_TRUE(held.detector.detect({}, {}).empty());
    EXPECT_TRUE(held.detector.detect(noise_picture(21, 10, 1).view(), {}).empty()) << "larger than at start";
    PictureView two = picture.view();
    two.channels = 2;
    EXPECT_TRUE(held.detector.detect(two, {}).empty());
    EXPECT_EQ(held.detector.detect(picture.view(), {}).size(), 200u) << "control";
}

/// The same to the byte, however many rows come at once.
TEST(EdgeDetector, TakesAPictureInParts) {
    for (const CannySettings settings : {CannySettings{}, {0, 40, 90}, {3, 10, 30}}) {
        const SyntheticPicture picture = landscape(150, 61, 3);
        const std::vector<std::uint8_t> whole = edges_of(picture, settings);
        HeldEdges held(150, 61);
        static_cast<void>(held.of(noise_picture(149, 60, 5).view()));  // which leaves no trace
        for (const int rows : {1, 2, 7, 16, 60, 61}) {
            ASSERT_TRUE(held.detector.begin(150, 61, settings));
            for (int top = 0; top < 61; top += rows) {
                EXPECT_TRUE(held.detector.finish().empty()) << "rows are missing";
                PictureView part = picture.view();
                part.pixels = part.row(top);
                part.height = std::min(rows, 61 - top);
                EXPECT_TRUE(held.detector.add_rows(part));
            }
            const base::Span<const std::uint8_t> found = held.detector.finish();
            EXPECT_EQ(std::vector<std::uint8_t>(found.begin(), found.end()), whole) << rows;
        }
    }
}

TEST(EdgeDetector, RefusesRowsThatAreNotThePictures) {
    const SyntheticPicture picture = noise_picture(20, 10, 1), wider = noise_picture(21, 3, 1), more = noise_picture(20, 11, 1);
    HeldEdges held(30, 20);
    EXPECT_FALSE(held.detector.add_rows(picture.view())) << "none has begun";
    EXPECT_TRUE(held.detector.finish().empty());
    ASSERT_TRUE(held.detector.begin(20, 10, {}));
    EXPECT_FALSE(held.detector.add_rows(wider.view()));
    EXPECT_FALSE(held.detector.add_rows(more.view()));
    EXPECT_TRUE(held.detector.add_rows(picture.view())) << "control";
    const base::Span<const std::uint8_t> found = held.detector.finish();
    EXPECT_EQ(std::vector<std::uint8_t>(found.begin(), found.end()), edges_of(picture)) << "what was refused left no trace";
    EXPECT_FALSE(held.detector.add_rows(picture.view())) << "it is over";
    EXPECT_TRUE(held.detector.finish().empty());
}

TEST(EdgeDetector, TakesLessMemoryForNarrowBlurs) {
    std::vector<unsigned char> block(EdgeDetector::bytes(300, 200, 1));
    EXPECT_LT(block.size(), EdgeDetector::bytes(300, 200));
    base::Arena arena(block.data(), block.size());
    EdgeDetector detector;
    ASSERT_TRUE(detector.start(arena, 300, 200, 1));
    EXPECT_LE(arena.use().capacity - arena.use().in_use, 128u);
    const SyntheticPicture picture = landscape(300, 200, 4);
    EXPECT_TRUE(detector.detect(picture.view(), {1.4, 70, 170}).empty()) << "wider than at start";
    const base::Span<const std::uint8_t> found = detector.detect(picture.view(), {});
    EXPECT_EQ(std::vector<std::uint8_t>(found.begin(), found.end()), edges_of(picture));
}

TEST(EdgeDetector, TakesTheMemoryThatItSays) {
    std::vector<unsigned char> block(EdgeDetector::bytes(300, 200));
    base::Arena arena(block.data(), block.size()), short_arena(block.data(), block.size() - 256);
    EdgeDetector detector;
    EXPECT_FALSE(detector.start(short_arena, 300, 200));
    EXPECT_TRUE(detector.start(arena, 300, 200));
    EXPECT_LE(arena.use().capacity - arena.use().in_use, 128u);
    EXPECT_FALSE(detector.start(arena, 0, 5));
    EXPECT_FALSE(detector.start(arena, 5, kMaxPictureSide + 1));
}

}  // namespace
}  // namespace tedavis::perception::test_edge_detector
