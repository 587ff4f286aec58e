#include "host_sim/terrain_builder/attributes/attribute_maps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/terrain/attribute_terrain.hpp"
#include "tests/support/terrain/fractal_square.hpp"

namespace tedavis::host_sim::test_attribute_maps {
namespace {

using terrain::AttributeChannel;
using terrain::kHorizonDirections;
using terrain::PostClass;
using test_support::make_tile;
using test_support::post_of;

const test_support::FractalSquare& fractal() {
    static const test_support::FractalSquare terrain = test_support::fractal_square(161, 5);
    return terrain;
}

/// Posts of the fractal, the inner post (0,0) at its (column, row), with voids and sea here and there.
AttributeTile fractal_tile(int columns, int rows, int column, int row) {
    AttributeTile tile = make_tile(columns, rows, 60, 60, [&](int i, int j) {
        return fractal().at(static_cast<std::uint32_t>(column + i), static_cast<std::uint32_t>(row + j));
    });
    for (int j = -kAttributeApron; j < rows + kAttributeApron; ++j) {
        for (int i = -kAttributeApron; i < columns + kAttributeApron; ++i) {
            const int x = column + i, y = row + j, mark = (x * 7919 + y * 104729) % 97;
            PostClass& post = tile.post_class[post_of(tile, i, j)];
            if (mark < 3 || (x > 70 && x < 76 && y > 60 && y < 64)) post = PostClass::void_;
            if (mark == 50) post = PostClass::sea;
            if (mark == 60) post = PostClass::outside;
        }
    }
    return tile;
}

/// Far horizons of a level above that covers the fractal, its inner post (0,0) at the fractal's post (32,32).
FarHorizons fractal_far() {
    FarHorizons far;
    far.columns = far.rows = 49;
    for (int j = -kFarMargin; j < far.rows + kFarMargin; ++j) {
        for (int i = -kFarMargin; i < far.columns + kFarMargin; ++i) {
            FarLines lines;
            for (std::size_t k = 0; k < kHorizonDirections; ++k) {
                lines.intercept[k] = 0.25f + 0.15f * std::sin(0.31f * static_cast<float>(i) + static_cast<float>(k)) +
                                     0.1f * std::cos(0.17f * static_cast<float>(j));
                lines.per_m[k] = 1e-4f * static_cast<float>(1 + k % 3);
            }
            far.lines.push_back(lines);
            far.known.push_back((i * 31 + j * 17) % 23 == 0 ? 0.0f : 1.0f);
        }
    }
    return far;
}

bool same(const AttributeMaps& a, const AttributeMaps& b) { return a.rgba == b.rgba && a.horizon == b.horizon; }

std::uint8_t code(const AttributeMaps& maps, AttributeChannel channel, int column, int row) {
    const auto c = static_cast<std::size_t>(channel);
    return maps.rgba[c / 4][4 * static_cast<std::size_t>(row * maps.columns + column) + c % 4];
}

TEST(AttributeMaps, LevelOpenGroundIsCodedWithoutError) {
    const AttributeTile tile = make_tile(6, 5, 20, 30, [](int, int) { return 411.7; });
    const FixedLight light;
    const AttributeMaps maps = make_attributes(tile, light, {}, false).maps;
    const double level = light.direct * std::sin(light.elevation_rad) + light.sky;
    for (int row = 0; row < 5; ++row) {
        for (int column = 0; column < 6; ++column) {
            const auto at = [&](AttributeChannel channel) { return code(maps, channel, column, row); };
            EXPECT_EQ(terrain::decode_slope_rad(at(AttributeChannel::normal_east), at(AttributeChannel::normal_north)), 0);
            EXPECT_EQ(terrain::decode_unit(at(AttributeChannel::sky_view)), 1);
            EXPECT_EQ(terrain::decode_signed_root(at(AttributeChannel::curvature)), 0);
            EXPECT_NEAR(terrain::decode_light(at(AttributeChannel::light)), level, 0.0025);
            EXPECT_EQ(terrain::decode_openness_rad(at(AttributeChannel::openness_above)), static_cast<float>(base::kPi / 2));
            EXPECT_EQ(terrain::decode_openness_rad(at(AttributeChannel::openness_below)), static_cast<float>(base::kPi / 2));
            EXPECT_EQ(terrain::decode_relief_m(at(AttributeChannel::local_relief)), 0);
            EXPECT_EQ(terrain::decode_unit(at(AttributeChannel::aperture_radius)), 0);
            EXPECT_EQ(at(AttributeChannel::post_class), 0);
        }
    }
    for (const auto& plane : maps.horizon) EXPECT_EQ(plane, std::vector<std::uint8_t>(9, 0));
}

// What stands in a post without a height must not be seen anywhere.
TEST(AttributeMaps, TheMarksOfVoidsChangeNoByte) {
    const FarHorizons above = fractal_far();
    const FarView view{&above, 1.75, 0.25};
    AttributeTile tile = fractal_tile(37, 30, 50, 45);
    const TileAttributes first = make_attributes(tile, {}, view, true);
    for (const float mark :
         {-32768.0f, std::numeric_limits<float>::quiet_NaN(), 32767.0f, -3.4e38f, std::numeric_limits<float>::infinity()}) {
        for (std::size_t n = 0; n < tile.height_m.size(); ++n)
            if (tile.post_class[n] > PostClass::sea) tile.height_m[n] = mark;
        const TileAttributes marked = make_attributes(tile, {}, view, true);
        EXPECT_TRUE(same(marked.maps, first.maps)) << mark;
        bool equal = marked.far->known == first.far->known;
        for (std::size_t n = 0; n < first.far->lines.size(); ++n)
            equal = equal && marked.far->lines[n].intercept == first.far->lines[n].intercept &&
                    marked.far->lines[n].per_m == first.far->lines[n].per_m;
        EXPECT_TRUE(equal) << mark;
    }
    tile.height_m[post_of(tile, 11, 12)] += 300;
    ASSERT_EQ(tile.post_class[post_of(tile, 11, 12)], PostClass::land);
    EXPECT_FALSE(same(make_attributes(tile, {}, view, true).maps, first.maps)) << "a height is seen";
}

TEST(AttributeMaps, PostsWithoutHeightAreAsLevelGround) {
    const AttributeTile tile = fractal_tile(37, 30, 50, 45);
    const FixedLight light;
    const AttributeFields fields = measure_attributes(HeightPlanes(tile), light, {});
    int voids = 0;
    for (int row = 0; row < tile.rows; ++row) {
        for (int column = 0; column < tile.columns; ++column) {
            const PostClass post = tile.post_class[post_of(tile, column, row)];
            EXPECT_EQ(fields.at(AttributeChannel::post_class, column, row), terrain::class_code(post));
            if (post <= PostClass::sea) continue;
            ++voids;
            EXPECT_EQ(fields.at(AttributeChannel::normal_east, column, row), 0);
            EXPECT_EQ(fields.at(AttributeChannel::sky_view, column, row), 1);
            EXPECT_EQ(fields.at(AttributeChannel::curvature, column, row), 0);
            EXPECT_EQ(fields.at(AttributeChannel::local_relief, column, row), 0);
            EXPECT_NEAR(fields.at(AttributeChannel::light, column, row), light.direct * std::sin(light.elevation_rad) + light.sky,
                        1e-6);
        }
    }
    EXPECT_GT(voids, 30);
}

/// The tile a quarter turn clockwise: what lay north lies east.
AttributeTile turned(const AttributeTile& tile) {
    AttributeTile result = tile;
    const auto side = static_cast<std::size_t>(tile.full_columns());
    for (std::size_t j = 0; j < side; ++j) {
        for (std::size_t i = 0; i < side; ++i) {
            result.height_m[i * side + side - 1 - j] = tile.height_m[j * side + i];
            result.post_class[i * side + side - 1 - j] = tile.post_class[j * side + i];
        }
    }
    return result;
}

FarHorizons turned(const FarHorizons& far) {
    FarHorizons result = far;
    for (int j = -kFarMargin; j < far.rows + kFarMargin; ++j) {
        for (int i = -kFarMargin; i < far.columns + kFarMargin; ++i) {
            const std::size_t from = far.at(i, j), to = far.at(far.rows - 1 - j, i);
            result.known[to] = far.known[from];
            for (std::size_t k = 0; k < kHorizonDirections; ++k) {
                result.lines[to].intercept[(k + 4) % kHorizonDirections] = far.lines[from].intercept[k];
                result.lines[to].per_m[(k + 4) % kHorizonDirections] = far.lines[from].per_m[k];
            }
        }
    }
    return result;
}

TEST(AttributeMaps, AQuarterTurnTurnsEveryMapExactly) {
    constexpr int kSide = 33;
    const AttributeTile tile = fractal_tile(kSide, kSide, 50, 45);
    const FarHorizons above = fractal_far(), above_turned = turned(above);
    const double column = 1.75, row = 0.25;
    FixedLight light;
    light.azimuth_rad = base::radians(315);
    const TileAttributes plain = make_attributes(tile, light, {&above, column, row}, true);
    light.azimuth_rad = base::radians(45);
    const TileAttributes other =
        make_attributes(turned(tile), light, {&above_turned, above.rows - 1 - row - (kSide - 1) / 2.0, column}, true);
    const auto expect = [&](AttributeChannel to, AttributeChannel from, int sign) {
        for (int j = 0; j < kSide; ++j)
            for (int i = 0; i < kSide; ++i) {
                const int before = code(plain.maps, from, i, j);
                ASSERT_EQ(code(other.maps, to, kSide - 1 - j, i), sign > 0 ? before : 256 - before)
                    << "channel " << static_cast<int>(from) << " at " << i << "," << j;
            }
    };
    expect(AttributeChannel::normal_east, AttributeChannel::normal_north, 1);
    expect(AttributeChannel::normal_north, AttributeChannel::normal_east, -1);
    expect(AttributeChannel::aperture_east, AttributeChannel::aperture_north, 1);
    expect(AttributeChannel::aperture_north, AttributeChannel::aperture_east, -1);
    for (const AttributeChannel channel :
         {AttributeChannel::sky_view, AttributeChannel::curvature, AttributeChannel::light, AttributeChannel::openness_above,
          AttributeChannel::local_relief, AttributeChannel::post_class, AttributeChannel::aperture_radius,
          AttributeChannel::openness_below})
        expect(channel, channel, 1);
    const int half = (kSide + 1) / 2;
    for (std::size_t k = 0; k < kHorizonDirections; ++k)
        for (int j = 0; j < half; ++j)
            for (int i = 0; i < half; ++i)
                ASSERT_EQ(other.maps.horizon[(k + 4) % 16][static_cast<std::size_t>(i * half + half - 1 - j)],
                          plain.maps.horizon[k][static_cast<std::size_t>(j * half + i)]);
}

TEST(AttributeMaps, TilesSideBySideAreOneTile) {
    const FarHorizons above = fractal_far();
    const TileAttributes whole = make_attributes(fractal_tile(50, 22, 40, 50), {}, {&above, 3.75, 8.75}, true);
    const TileAttributes west = make_attributes(fractal_tile(26, 22, 40, 50), {}, {&above, 3.75, 8.75}, true),
                         east = make_attributes(fractal_tile(24, 22, 66, 50), {}, {&above, 16.75, 8.75}, true);
    for (int row = 0; row < 22; ++row) {
        for (int column = 0; column < 50; ++column) {
            const TileAttributes& part = column < 26 ? west : east;
            const int there = column < 26 ? column : column - 26;
            for (int c = 0; c < terrain::kAttributeChannels; ++c)
                ASSERT_EQ(code(whole.maps, static_cast<AttributeChannel>(c), column, row),
                          code(part.maps, static_cast<AttributeChannel>(c), there, row))
                    << c << " at " << column << "," << row;
            ASSERT_EQ(whole.far->lines[whole.far->at(column, row)].intercept,
                      part.far->lines[part.far->at(there, row)].intercept);
        }
    }
}

TEST(AttributeMaps, LightWithoutBounceAndSkyIsLambertsCosine) {
    const AttributeTile tile =
        make_tile(24, 20, 20, 25, [](int i, int j) { return 300 + 6 * std::sin(0.3 * i) + 5 * std::cos(0.2 * j + 0.1 * i); });
    FixedLight light;
    light.elevation_rad = base::radians(45);
    light.albedo = light.sky = 0;
    light.direct = 1;
    const HeightPlanes planes(tile);
    const AttributeFields fields = measure_attributes(planes, light, {});
    light.albedo = 0.25;
    const AttributeFields bounced = measure_attributes(planes, light, {});
    bool brighter = false;
    for (int row = 0; row < tile.rows; ++row) {
        for (int column = 0; column < tile.columns; ++column) {
            const long double e = fields.at(AttributeChannel::normal_east, column, row),
                              n = fields.at(AttributeChannel::normal_north, column, row), up = std::sqrt(1 - e * e - n * n);
            const long double lambert = 0.5L * (n - e) + std::sqrt(0.5L) * up;  // from the north-west, 45 degrees high
            const float plain = fields.at(AttributeChannel::light, column, row);
            EXPECT_NEAR(plain, static_cast<double>(lambert), 1e-5);
            EXPECT_GE(bounced.at(AttributeChannel::light, column, row), plain);
            brighter = brighter || bounced.at(AttributeChannel::light, column, row) > plain + 1e-4f;
        }
    }
    EXPECT_TRUE(brighter);
}

TEST(AttributeMaps, ValuesKeepToTheirRanges) {
    const AttributeTile tile = fractal_tile(40, 40, 60, 60);
    const AttributeFields fields = measure_attributes(HeightPlanes(tile), {}, {});
    const auto range = [&](AttributeChannel channel) {
        const auto& values = fields.channel[static_cast<std::size_t>(channel)];
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        return std::pair(*low, *high);
    };
    EXPECT_GE(range(AttributeChannel::sky_view).first, 0);
    EXPECT_LE(range(AttributeChannel::sky_view).second, 1);
    EXPECT_LE(range(AttributeChannel::light).second, terrain::kBrightestLight);
    EXPECT_GT(range(AttributeChannel::openness_above).first, 0);
    EXPECT_LT(range(AttributeChannel::openness_above).second, 3.15f);
    EXPECT_LT(range(AttributeChannel::curvature).first, 0);
    EXPECT_GT(range(AttributeChannel::curvature).second, 0);
    for (const auto& plane : fields.horizon_sine)
        for (const float sine : plane) ASSERT_TRUE(sine >= 0 && sine <= 1);
}

}  // namespace
}  // namespace tedavis::host_sim::test_attribute_maps
