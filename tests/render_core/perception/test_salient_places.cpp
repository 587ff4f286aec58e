#include "render_core/perception/salient_places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/render_core/perception/held_saliency.hpp"

namespace tedavis::perception::test_salient_places {
namespace {

struct PlaceMap {
    PlaceMap(int width_, int height_, int level_)
        : width(width_), height(height_), level(level_), values(pixels_of(width, height)) {}
    float& at(int x, int y) { return values[pixels_of(width, y) + static_cast<std::size_t>(x)]; }
    [[nodiscard]] SaliencyMap map() const {
        return {{values.data(), values.size()}, width, height, level, SaliencyScale::per_picture, true};
    }
    int width, height, level;
    std::vector<float> values;
};

TEST(SalientPlaces, ComeInTheOrderOfTheirValues) {
    PlaceMap map(40, 30, 2);
    map.at(5, 6) = 0.5f;
    map.at(30, 20) = 1.0f;
    map.at(20, 3) = 0.7f;
    const SalientPlaces places = salient_places(map.map(), 8, 10);
    ASSERT_EQ(places.size(), 3u) << "where nothing is salient is no place";
    EXPECT_EQ(places[0].x, 30.5 * 4);
    EXPECT_EQ(places[0].y, 20.5 * 4);
    EXPECT_EQ(places[1].value, 0.7f);
    EXPECT_EQ(places[2].x, 5.5 * 4);
    EXPECT_EQ(salient_places(map.map(), 8, 2).size(), 2u);
    EXPECT_EQ(salient_places(PlaceMap(8, 8, 0).map(), 8, 2).size(), 0u);
}

TEST(SalientPlaces, InhibitADiscRoundThem) {
    PlaceMap map(40, 30, 0);
    map.at(10, 10) = 1.0f;
    map.at(13, 14) = 0.9f;  // five away
    EXPECT_EQ(salient_places(map.map(), 4.99, 10).size(), 2u);
    EXPECT_EQ(salient_places(map.map(), 5, 10).size(), 1u);
    EXPECT_EQ(salient_places(map.map(), 0, 10).size(), 2u) << "at least the place itself";
}

TEST(SalientPlaces, OfEqualOnesTheUpperThenTheLeftOneComesFirst) {
    PlaceMap map(20, 20, 0);
    map.at(15, 3) = map.at(4, 3) = map.at(2, 12) = 0.5f;
    const SalientPlaces places = salient_places(map.map(), 2, 10);
    ASSERT_EQ(places.size(), 3u);
    EXPECT_EQ(places[0].x, 4.5);
    EXPECT_EQ(places[1].x, 15.5);
    EXPECT_EQ(places[2].y, 12.5);
}

TEST(SalientPlaces, AreOnlyWhereTheMaskLets) {
    PlaceMap map(20, 20, 0);
    map.at(15, 3) = 1.0f;
    map.at(4, 9) = 0.5f;
    std::vector<std::uint8_t> mask(400, 1);
    mask[pixels_of(20, 3) + 15] = 0;
    const SalientPlaces places = salient_places(map.map(), 2, 10, {mask.data(), mask.size()});
    ASSERT_EQ(places.size(), 1u);
    EXPECT_EQ(places[0].x, 4.5);
    EXPECT_EQ(salient_places(map.map(), 2, 10, {mask.data(), 399}).size(), 0u) << "a mask of another map";
}

/// As it is defined: sorted once, and taken unless a place before inhibits it.
TEST(SalientPlaces, AreThoseOfTheSortedMap) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        PlaceMap map(31, 23, 1);
        for (std::size_t n = 0; n < map.values.size(); ++n)
            map.values[n] = static_cast<float>(test_support::scrambled(static_cast<std::uint32_t>(n), seed, 5) % 50) / 49;
        std::vector<std::size_t> order(map.values.size());
        for (std::size_t n = 0; n < order.size(); ++n) order[n] = n;
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return map.values[a] > map.values[b]; });
        std::vector<std::pair<double, double>> expected;
        const double radius = 3 + seed;
        for (const std::size_t n : order) {
            const double x = 2 * (static_cast<double>(n % 31) + 0.5), y = 2 * (static_cast<double>(n / 31) + 0.5);
            const bool is_near = std::any_of(expected.begin(), expected.end(),
                                             [&](const auto& p) { return std::hypot(p.first - x, p.second - y) <= radius; });
            if (map.values[n] > 0 && !is_near) expected.emplace_back(x, y);
        }
        const SalientPlaces places = salient_places(map.map(), radius, kMaxSalientPlaces);
        ASSERT_EQ(places.size(), std::min(expected.size(), kMaxSalientPlaces));
        for (std::size_t n = 0; n < places.size(); ++n) EXPECT_EQ(std::make_pair(places[n].x, places[n].y), expected[n]);
    }
}

TEST(SalientPlaces, OneOddDiskAmongEqualsIsTheFirst) {
    const auto is_within = [](int x, int y, int of_x, int of_y) { return std::hypot(x - of_x, y - of_y) <= 7; };
    const test_support::SyntheticPicture picture(240, 180, [&](int x, int y) {
        if (is_within(x, y, 150, 110)) return test_support::Rgb{230, 60, 40};
        const bool is_disk = is_within(x % 40, y % 40, 30, 30) && x / 40 * 40 + 30 != 150;
        return is_disk ? test_support::Rgb{60, 120, 200} : test_support::Rgb{40, 40, 40};
    });
    test_support::HeldSaliency saliency(240, 180);
    const test_support::HeldMap held = saliency.of(picture.view());
    const SaliencyMap map{
        {held.values.data(), held.values.size()}, held.width, held.height, held.level, SaliencyScale::per_picture, true};
    const SalientPlaces places = salient_places(map, kFocusShare * 180, 3);
    ASSERT_GE(places.size(), 2u);
    EXPECT_LT(std::hypot(places[0].x - 150, places[0].y - 110), 12);
    EXPECT_GT(std::hypot(places[1].x - 150, places[1].y - 110), 30) << "the next one is elsewhere";
}

}  // namespace
}  // namespace tedavis::perception::test_salient_places
