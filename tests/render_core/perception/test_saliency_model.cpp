#include "render_core/perception/saliency_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/saliency.hpp>
#include <string>
#include <vector>

#include "tests/render_core/perception/held_saliency.hpp"
#include "tests/support/files/hard_case.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/perception/golden_pictures.hpp"
#include "tests/support/perception/itti_reference.hpp"
#include "tests/support/perception/rank_correlation.hpp"

namespace tedavis::perception::test_saliency_model {
namespace {

using test_support::checkerboard;
using test_support::flat_picture;
using test_support::HeldMap;
using test_support::HeldSaliency;
using test_support::itti_reference;
using test_support::landscape;
using test_support::NamedPicture;
using test_support::noise_picture;
using test_support::rank_correlation;
using test_support::Rgb;
using test_support::saliency_of;
using test_support::SyntheticPicture;

/// Disks on a grid of cells of 64 pixels; the one at (column, row) has another colour or size.
SyntheticPicture disks(const Rgb& odd_color, double odd_radius, int column, int row) {
    return {384, 256, [=](int x, int y) {
                const bool is_odd = x / 64 == column && y / 64 == row;
                const double across = x % 64 - 31.5, down = y % 64 - 31.5, radius = is_odd ? odd_radius : 10;
                if (across * across + down * down > radius * radius) return Rgb{90, 90, 90};
                return is_odd ? odd_color : Rgb{200, 60, 60};
            }};
}

/// Thirty: of the display, and by formula.
const std::vector<NamedPicture>& pictures() {
    static const std::vector<NamedPicture> all = [] {
        std::vector<NamedPicture> list = test_support::golden_pictures(test_support::source_dir());
        list.resize(std::min<std::size_t>(list.size(), 20), list.front());
        for (std::uint32_t seed = 0; seed < 4; ++seed)
            list.push_back({"landscape " + std::to_string(seed), landscape(256, 192, seed)});
        list.push_back({"another colour", disks({60, 200, 60}, 10, 4, 1)});
        list.push_back({"another size", disks({200, 60, 60}, 22, 1, 2)});
        list.push_back({"another lightness", disks({255, 190, 190}, 10, 2, 2)});
        list.push_back({"noise", noise_picture(200, 150, 3)});
        list.push_back({"board", checkerboard(256, 192, 24)});
        list.push_back({"dot", SyntheticPicture(256, 192, [](int x, int y) {
                            return std::abs(x - 70) < 4 && std::abs(y - 100) < 4 ? Rgb{255, 255, 0} : Rgb{20, 30, 60};
                        })});
        return list;
    }();
    return all;
}

double largest_difference(const HeldMap& map, const test_support::Field& reference) {
    double most = 0;
    for (std::size_t n = 0; n < map.values.size(); ++n)
        most = std::max(most, std::fabs(static_cast<double>(map.values[n]) - reference.values[n]));
    return most;
}

TEST(SaliencyModel, IsTheReferenceModelInDouble) {
    ASSERT_EQ(pictures().size(), 30u);
    for (const NamedPicture& of : pictures())
        for (const SaliencyScale scale : {SaliencyScale::per_picture, SaliencyScale::fixed}) {
            const test_support::Field reference = itti_reference(of.picture.view(), {scale == SaliencyScale::fixed});
            const HeldMap map = saliency_of(of.picture, 0, scale);
            ASSERT_EQ(map.width, reference.width);
            ASSERT_EQ(map.height, reference.height);
            EXPECT_LE(largest_difference(map, reference), 2e-3) << of.name;
            EXPECT_GE(rank_correlation(map.values, reference.values), 0.9999) << of.name;
        }
}

// Negative control: the comparison tells every part of the model.
TEST(SaliencyModel, IsNoOtherModel) {
    const SyntheticPicture picture = disks({60, 200, 60}, 10, 4, 1);
    const HeldMap map = saliency_of(picture);
    test_support::ReferenceOptions options[3];
    options[0].without_entropy = true;
    options[1].without_colors = true;
    options[2].wave_px = 6;
    for (const test_support::ReferenceOptions& other : options)
        EXPECT_LT(rank_correlation(map.values, itti_reference(picture.view(), other).values), 0.999);
}

TEST(SaliencyModel, ACoarserStartChangesLittle) {
    double mean_1 = 0, mean_2 = 0, fixed_2 = 0;
    for (const NamedPicture& of : pictures()) {
        const HeldMap full = saliency_of(of.picture, 0), fixed = saliency_of(of.picture, 0, SaliencyScale::fixed);
        const double rank_1 = rank_correlation(full.values, saliency_of(of.picture, 1).values);
        const double rank_2 = rank_correlation(full.values, saliency_of(of.picture, 2).values);
        const double rank_fixed = rank_correlation(fixed.values, saliency_of(of.picture, 2, SaliencyScale::fixed).values);
        RecordProperty(of.name, std::to_string(rank_1) + ' ' + std::to_string(rank_2) + ' ' + std::to_string(rank_fixed));
        EXPECT_GE(rank_1, 0.85) << of.name;  // the least are those of white noise
        EXPECT_GE(rank_2, 0.7) << of.name;
        EXPECT_GE(rank_fixed, 0.7) << of.name;
        mean_1 += rank_1 / 30;
        mean_2 += rank_2 / 30;
        fixed_2 += rank_fixed / 30;
    }
    EXPECT_GE(mean_1, 0.995);
    EXPECT_GE(mean_2, 0.97);
    EXPECT_GE(fixed_2, 0.98);
}

/// OpenCV's map at the size of ours.
template <class Model>
std::vector<float> opencv_map(const SyntheticPicture& picture, const HeldMap& ours) {
    cv::Mat rgb(picture.height, picture.width, CV_8UC3), bgr, map;
    std::copy(picture.pixels.begin(), picture.pixels.end(), rgb.data);
    cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
    EXPECT_TRUE(Model::create()->computeSaliency(bgr, map));
    map.convertTo(map, CV_32F);
    cv::resize(map, map, cv::Size(ours.width, ours.height), 0, 0, cv::INTER_AREA);
    return {map.begin<float>(), map.end<float>()};
}

// OpenCV has no Itti; other models share the direction only: README.md says where they part.
TEST(SaliencyModel, AgreesWithOpenCvsModelsOnTheWhole) {
    double fine_grained = 0, residual = 0;
    for (const NamedPicture& of : pictures()) {
        const HeldMap map = saliency_of(of.picture);
        const double fine = rank_correlation(map.values, opencv_map<cv::saliency::StaticSaliencyFineGrained>(of.picture, map));
        const double spectral =
            rank_correlation(map.values, opencv_map<cv::saliency::StaticSaliencySpectralResidual>(of.picture, map));
        RecordProperty(of.name + " fine-grained", std::to_string(fine));
        RecordProperty(of.name + " spectral residual", std::to_string(spectral));
        fine_grained += fine / 30;
        residual += spectral / 30;
    }
    EXPECT_GE(fine_grained, 0.35);
    EXPECT_GE(residual, 0.15);
}

constexpr Rgb kFlatColors[] = {{0, 0, 0}, {255, 255, 255}, {128, 128, 128}, {10, 200, 90}};

/// Pixels of a map that are not exactly 0; those that are no number among them.
template <class Number>
std::int64_t not_zero(const std::vector<Number>& values) {
    return static_cast<std::int64_t>(values.size()) - std::count(values.begin(), values.end(), Number{0});
}

// Negative control: a map that is divided by its largest value, whatever that is, is 0/0 or rounding raised to 1.
TEST(SaliencyModel, WithoutItsGuardFlatPicturesWouldBeSalient) {
    std::int64_t ours = 0, naive = 0, no_numbers = 0;
    test_support::ReferenceOptions without;
    without.without_guard = true;
    for (const Rgb color : kFlatColors) {
        const SyntheticPicture picture = flat_picture(200, 150, color);
        ours += not_zero(saliency_of(picture).values);
        const std::vector<double> divided = itti_reference(picture.view(), without).values;
        naive += not_zero(divided);
        no_numbers += std::count_if(divided.begin(), divided.end(), [](double value) { return std::isnan(value); });
        EXPECT_GT(not_zero(divided), 0) << int{color[0]} << ' ' << int{color[1]};
        EXPECT_EQ(not_zero(itti_reference(picture.view()).values), 0) << "the guard alone makes the difference";
    }
    EXPECT_EQ(ours, 0);
    EXPECT_GT(no_numbers, 0);
    test_support::record_worst("A42", static_cast<double>(ours));
    test_support::record_control("A42", static_cast<double>(naive));
}

TEST(SaliencyModel, FlatPicturesHaveNothingSalient) {
    for (const Rgb color : kFlatColors)
        for (const int start_level : {0, 1, 2})
            for (const SaliencyScale scale : {SaliencyScale::per_picture, SaliencyScale::fixed}) {
                const HeldMap map = saliency_of(flat_picture(200, 150, color), start_level, scale);
                EXPECT_FALSE(map.has_salient);
                EXPECT_EQ(map.values, std::vector<float>(map.values.size(), 0));
            }
}

TEST(SaliencyModel, OneOddDiskAmongEqualsIsTheMaximum) {
    struct Odd {
        Rgb color;
        double radius;
        int column, row;
    };
    for (const Odd& odd : {Odd{{60, 200, 60}, 10, 4, 1},
                           {{60, 60, 220}, 10, 1, 1},
                           {{60, 200, 60}, 10, 0, 0},
                           {{255, 220, 60}, 10, 2, 3},
                           {{200, 60, 60}, 24, 3, 2}})
        for (const int start_level : {0, 2})
            for (const SaliencyScale scale : {SaliencyScale::per_picture, SaliencyScale::fixed}) {
                const auto [x, y] = saliency_of(disks(odd.color, odd.radius, odd.column, odd.row), start_level, scale).most();
                EXPECT_EQ(x / 16, odd.column) << start_level;
                EXPECT_EQ(y / 16, odd.row) << start_level;
            }
    const HeldMap equal = saliency_of(disks({200, 60, 60}, 10, 0, 0));
    EXPECT_GT(equal.at(5 * 16 + 8, 3 * 16 + 8), 0.5) << "without an odd one all count alike";
}

TEST(SaliencyModel, OneBrightDotIsTheMaximum) {
    for (const auto& [dot_x, dot_y] : {std::pair{200, 100}, {0, 0}, {318, 239}, {7, 150}})
        for (const int start_level : {0, 1, 2}) {
            const SyntheticPicture picture(320, 240, [&, x_ = dot_x, y_ = dot_y](int x, int y) {
                return x == x_ && y == y_ ? Rgb{255, 255, 255} : Rgb{0, 0, 0};
            });
            const auto [x, y] = saliency_of(picture, start_level).most();
            const int column = dot_x / 4, row = dot_y / 4;
            EXPECT_NEAR(x, column, 1) << start_level;
            EXPECT_NEAR(y, row, 1) << start_level;
        }
}

/// Of a map that is turned or mirrored with its picture.
double largest_difference(const HeldMap& map, const HeldMap& changed, bool is_turned) {
    double most = 0;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            most = std::max<double>(most, std::fabs(map.at(x, y) - (is_turned ? changed.at(map.height - 1 - y, x)
                                                                              : changed.at(map.width - 1 - x, y))));
    return most;
}

// To rounding where no level has a part of a pixel; counts above half a maximum may change by a pixel.
TEST(SaliencyModel, TurnsAndMirrorsWithThePicture) {
    const SyntheticPicture picture = landscape(512, 256, 5);
    for (const int start_level : {0, 2}) {
        const HeldMap map = saliency_of(picture, start_level);
        EXPECT_LE(largest_difference(map, saliency_of(picture.mirrored(), start_level), false), 1e-3);
        EXPECT_LE(largest_difference(map, saliency_of(picture.turned(), start_level), true), 1e-3);
        EXPECT_GT(largest_difference(map, map, false), 0.1) << "which the comparison can tell";
    }
}

TEST(SaliencyModel, AnySizeWorksAndGivesTheSameInLargerMemory) {
    HeldSaliency large(640, 480);
    const std::pair<int, int> sizes[] = {{1, 1},    {2, 3},   {1, 480}, {640, 1},   {31, 31},
                                         {32, 400}, {63, 64}, {64, 63}, {640, 480}, {639, 479}};
    for (const auto& [width, height] : sizes)
        for (const int start_level : {0, 1, 2}) {
            const SyntheticPicture picture = landscape(width, height, 3);
            const HeldMap map = large.of(picture.view(), start_level);
            EXPECT_EQ(map.values, saliency_of(picture, start_level).values) << width << 'x' << height;
            EXPECT_EQ(map.values, large.of(picture.view(), start_level).values) << "twice the same";
            EXPECT_EQ(map.level, saliency_level(width, height));
            EXPECT_EQ(map.width, level_side(width, map.level));
            for (const float value : map.values) ASSERT_TRUE(value >= 0 && value <= 1);
        }
    const HeldMap one = large.of(flat_picture(1, 1, {250, 3, 9}).view());
    EXPECT_EQ(one.values, std::vector<float>{0});
    EXPECT_FALSE(one.has_salient);
}

TEST(SaliencyModel, LargePicturesOfOddSizeAreFiniteAndFindTheDot) {
    const SyntheticPicture picture(1919, 1079, [](int x, int y) {
        return (x - 1500) * (x - 1500) + (y - 300) * (y - 300) < 400 ? Rgb{250, 240, 40} : Rgb{60, 80, 100};
    });
    HeldSaliency held(1919, 1079, 2);
    const HeldMap map = held.of(picture.view(), 2);
    EXPECT_EQ(map.width, 480);
    EXPECT_EQ(map.height, 270);
    EXPECT_NEAR(map.most().first, 375, 6);
    EXPECT_NEAR(map.most().second, 75, 6);
    for (const float value : map.values) ASSERT_TRUE(std::isfinite(value));
}

// The fixed scale compares pictures; a picture's own does not.
TEST(SaliencyModel, TheFixedScaleTellsFaintFromStrong) {
    const auto spot = [](std::uint8_t level, SaliencyScale scale) {
        const SyntheticPicture picture(256, 256, [=](int x, int y) {
            return (x - 128) * (x - 128) + (y - 128) * (y - 128) < 300 ? Rgb{level, level, level} : Rgb{0, 0, 0};
        });
        const HeldMap map = saliency_of(picture, 0, scale);
        return map.at(map.most().first, map.most().second);
    };
    EXPECT_FLOAT_EQ(spot(60, SaliencyScale::per_picture), 1);
    EXPECT_FLOAT_EQ(spot(255, SaliencyScale::per_picture), 1);
    EXPECT_LT(spot(60, SaliencyScale::fixed), 0.6 * spot(255, SaliencyScale::fixed));
    EXPECT_GT(spot(255, SaliencyScale::fixed), 0.5);
}

TEST(SaliencyModel, RefusesWhatItCannotDo) {
    HeldSaliency held(100, 80, 1);
    const SyntheticPicture picture = noise_picture(100, 80, 1);
    EXPECT_EQ(held.model.map(SaliencyScale::per_picture).width, 0) << "nothing was looked at";
    EXPECT_FALSE(held.model.look(picture.view(), 0)) << "below the start level of start()";
    EXPECT_FALSE(held.model.look(picture.view(), 3));
    EXPECT_FALSE(held.model.look(noise_picture(101, 80, 1).view(), 1));
    EXPECT_FALSE(held.model.look({}, 1));
    EXPECT_TRUE(held.model.look(picture.view(), 1));
    EXPECT_FALSE(held.model.look({}, 1));
    EXPECT_FALSE(held.model.map(SaliencyScale::fixed).has_salient) << "and nothing of the picture before";
}

TEST(SaliencyModel, TakesTheMemoryThatItSays) {
    for (const int start_level : {0, 1, 2}) {
        std::vector<unsigned char> block(SaliencyModel::bytes(300, 50, start_level));
        base::Arena arena(block.data(), block.size()), short_arena(block.data(), block.size() - 256);
        SaliencyModel model;
        EXPECT_FALSE(model.start(short_arena, 300, 50, start_level));
        EXPECT_TRUE(model.start(arena, 300, 50, start_level));
        EXPECT_LE(arena.use().capacity - arena.use().in_use, 128u);
        EXPECT_FALSE(model.start(arena, 300, 50, 3));
        EXPECT_FALSE(model.start(arena, 0, 50, 0));
    }
}

}  // namespace
}  // namespace tedavis::perception::test_saliency_model
