#include "render_core/terrain/attribute_map.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tedavis::terrain::test_attribute_map {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

TEST(AttributeMap, EveryCodeThatIsWrittenComesBack) {
    for (int c = 0; c < 256; ++c) {
        const auto code = static_cast<std::uint8_t>(c);
        EXPECT_EQ(encode_unit(decode_unit(code)), code);
        EXPECT_EQ(encode_light(decode_light(code)), code);
        EXPECT_EQ(encode_horizon(decode_horizon_sine(code)), code);
        if (c == 0) continue;
        EXPECT_EQ(encode_signed(decode_signed(code)), code);
        EXPECT_EQ(encode_signed_root(decode_signed_root(code)), code);
        EXPECT_EQ(encode_openness(decode_openness_rad(code)), code);
        EXPECT_EQ(encode_relief(decode_relief_m(code)), code);
    }
    EXPECT_EQ(decode_signed(0), -1) << "never written";
}

TEST(AttributeMap, ValuesComeBackWithinHalfTheStatedStep) {
    for (int n = -2000; n <= 2000; ++n) {
        const float value = static_cast<float>(n) / 2000, size = std::fabs(value);
        EXPECT_NEAR(decode_signed(encode_signed(value)), value, 0.5 / 127 + 1e-6);
        const float step = 2 * std::sqrt(size) / 127 + 1.0f / (127 * 127);
        EXPECT_NEAR(decode_signed_root(encode_signed_root(value)), value, 0.5f * step + 1e-6f);
        EXPECT_NEAR(decode_relief_m(encode_relief(1000 * value)), 1000 * value, 500 * step + 1e-3f);
        EXPECT_NEAR(decode_openness_rad(encode_openness(1.5708f * (1 + value))), 1.5708f * (1 + value),
                    1.5708f * 0.5f * step + 1e-6f);
        EXPECT_NEAR(decode_unit(encode_unit(size)), size, 0.5 / 255 + 1e-6);
        EXPECT_NEAR(decode_light(encode_light(1.25f * size)), 1.25f * size, 0.0025);
        const float horizon_step = 2 * std::sqrt(size) / 255 + 1.0f / (255 * 255);
        EXPECT_NEAR(decode_horizon_sine(encode_horizon(size)), size, 0.5f * horizon_step + 1e-6f);
    }
    EXPECT_NE(decode_signed(encode_signed(0.003f)), 0.003f) << "eight bits do lose something";
}

TEST(AttributeMap, CodesGrowWithTheirValuesAndEndsAndMiddlesAreExact) {
    for (float value = -1.2f; value < 1.2f; value += 0.0007f) {
        EXPECT_LE(encode_signed(value), encode_signed(value + 0.0007f));
        EXPECT_LE(encode_signed_root(value), encode_signed_root(value + 0.0007f));
        EXPECT_LE(encode_unit(value), encode_unit(value + 0.0007f));
        EXPECT_EQ(encode_signed(-value), 256 - encode_signed(value));
    }
    EXPECT_EQ(decode_signed(encode_signed(0)), 0);
    EXPECT_EQ(decode_signed(encode_signed(-1)), -1);
    EXPECT_EQ(decode_unit(encode_unit(1)), 1);
    EXPECT_EQ(encode_openness(static_cast<float>(base::kPi / 2)), 128);
    EXPECT_EQ(encode_openness(static_cast<float>(base::kPi)), 255);
}

TEST(AttributeMap, WhatIsNoNumberOrBeyondTheRangeIsDefined) {
    EXPECT_EQ(encode_unit(kNan), 0);
    EXPECT_EQ(encode_unit(kInfinity), 255);
    EXPECT_EQ(encode_unit(-kInfinity), 0);
    EXPECT_EQ(encode_signed(kNan), 128);
    EXPECT_EQ(encode_signed(kInfinity), 255);
    EXPECT_EQ(encode_signed(-1e30f), 1);
    EXPECT_EQ(encode_signed_root(kNan), 128);
    EXPECT_EQ(encode_horizon(-0.3f), 0);
    EXPECT_EQ(encode_horizon(kNan), 0);
    EXPECT_EQ(encode_relief(-5000), 1);
}

TEST(AttributeMap, SlopesComeFromNormals) {
    for (const float slope_deg : {0.0f, 5.0f, 20.0f, 45.0f, 60.0f}) {
        const auto slope = static_cast<float>(base::radians(static_cast<double>(slope_deg)));
        const std::uint8_t east = encode_signed(-0.6f * std::sin(slope)), north = encode_signed(0.8f * std::sin(slope));
        EXPECT_NEAR(decode_slope_rad(east, north), slope, 0.5 / 127 * 1.42 / std::cos(static_cast<double>(slope)));
    }
    EXPECT_EQ(decode_slope_rad(255, 255), static_cast<float>(base::kPi / 2)) << "no normal at all";
}

TEST(AttributeMap, ClassesStandApart) {
    for (const PostClass post : {PostClass::land, PostClass::sea, PostClass::void_, PostClass::outside}) {
        for (const int off : {-40, 0, 40}) {
            const int code = class_code(post) + off;
            if (code < 0 || code > 255) continue;
            EXPECT_EQ(class_of_code(static_cast<std::uint8_t>(code)), post);
        }
    }
    EXPECT_EQ(class_code(PostClass::void_), 170);
}

TEST(AttributeMap, DirectionsGoClockwiseFromNorth) {
    double before = -1;
    for (int k = 0; k < kHorizonDirections; ++k) {
        const double azimuth = horizon_azimuth_rad(k, 20, 31);
        EXPECT_GT(azimuth, before);
        before = azimuth;
    }
    EXPECT_LT(before, 2 * base::kPi);
    EXPECT_DOUBLE_EQ(horizon_azimuth_rad(4, 20, 31), base::radians(90));
    EXPECT_DOUBLE_EQ(horizon_azimuth_rad(2, 30, 30), base::radians(45));
    EXPECT_DOUBLE_EQ(horizon_azimuth_rad(2, 15, 30), std::atan(0.5)) << "equal angles only on square cells";
    EXPECT_DOUBLE_EQ(horizon_azimuth_rad(13, 30, 30), base::radians(270) + std::atan(0.5));
}

TEST(AttributeMap, AnAzimuthLiesBetweenTwoDirections) {
    for (double azimuth_deg = -400; azimuth_deg < 800; azimuth_deg += 3.7) {
        const HorizonBracket bracket = bracket_azimuth(base::radians(azimuth_deg), 20, 31);
        EXPECT_EQ(bracket.second, (bracket.first + 1) % kHorizonDirections);
        EXPECT_GE(bracket.weight, 0);
        EXPECT_LE(bracket.weight, 1);
        const double begin = horizon_azimuth_rad(bracket.first, 20, 31), end = horizon_azimuth_rad(bracket.second, 20, 31);
        const double between = begin + bracket.weight * std::fmod(end - begin + 2 * base::kPi, 2 * base::kPi);
        EXPECT_NEAR(std::cos(between - base::radians(azimuth_deg)), 1, 1e-12);
    }
    EXPECT_EQ(bracket_azimuth(base::radians(90), 20, 31).first, 4);
    EXPECT_NEAR(bracket_azimuth(base::radians(90), 20, 31).weight, 0, 1e-12);
}

}  // namespace
}  // namespace tedavis::terrain::test_attribute_map
