#include "bus/canaerospace/data_type.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace tedavis::bus::test_data_type {
namespace {

/// Lengths as the standard's table of types lists them.
constexpr std::uint8_t kBytes[kDataTypeCount] = {0, 4, 4, 4, 4, 4, 2, 2, 2, 1, 1, 1, 4, 4, 4, 4,
                                                 4, 4, 2, 2, 2, 4, 4, 1, 2, 4, 3, 3, 3, 3, 4, 4};

TEST(DataType, LengthsOfAllTypes) {
    for (std::uint8_t code = 0; code < kDataTypeCount; ++code) {
        EXPECT_TRUE(type_layout(code).known);
        EXPECT_EQ(type_layout(code).bytes, kBytes[code]) << int{code};
    }
    for (int code = kDataTypeCount; code < 256; ++code) EXPECT_FALSE(type_layout(static_cast<std::uint8_t>(code)).known);
}

TEST(DataType, EveryPayloadOfEveryTypeGoesRound) {
    std::mt19937 random(7);
    for (std::uint8_t code = 0; code < kDataTypeCount; ++code)
        for (int i = 0; i < 2000; ++i) {
            std::uint8_t bytes[4];
            for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
            TypedValue value;
            ASSERT_TRUE(decode_value(code, bytes, 4, value));
            if (std::isnan(value.real)) continue;  // the bits of a NaN need not survive
            std::uint8_t back[4] = {};
            ASSERT_EQ(encode_value(value, back), kBytes[code]);
            ASSERT_EQ(std::memcmp(bytes, back, kBytes[code]), 0) << int{code};
        }
}

TEST(DataType, TooFewBytesAreRefusedMoreAreIgnored) {
    const std::uint8_t bytes[8] = {};
    TypedValue value;
    for (std::uint8_t code = 1; code < kDataTypeCount; ++code) {
        EXPECT_FALSE(decode_value(code, bytes, kBytes[code] - 1u, value));
        EXPECT_TRUE(decode_value(code, bytes, 8, value));
    }
    EXPECT_TRUE(decode_value(0, bytes, 0, value));
    EXPECT_FALSE(decode_value(32, bytes, 8, value));
    EXPECT_FALSE(decode_value(200, bytes, 8, value));
}

TEST(DataType, SignsAndByteOrder) {
    const std::uint8_t bytes[4] = {0xFF, 0xFE, 0x80, 0x01};
    TypedValue value;
    ASSERT_TRUE(decode_value(3, bytes, 4, value));
    EXPECT_EQ(value.parts[0], -98303);
    ASSERT_TRUE(decode_value(4, bytes, 4, value));
    EXPECT_EQ(value.parts[0], 0xFFFE8001);
    ASSERT_TRUE(decode_value(6, bytes, 4, value));
    EXPECT_EQ(value.parts[0], -2);
    ASSERT_TRUE(decode_value(12, bytes, 4, value));
    EXPECT_EQ(value.parts[1], -32767);
    ASSERT_TRUE(decode_value(15, bytes, 4, value));
    EXPECT_EQ(value.parts[2], -128);
    ASSERT_TRUE(decode_value(16, bytes, 4, value));
    EXPECT_EQ(value.parts[2], 128);
    ASSERT_TRUE(decode_value(1, bytes, 4, value));
    EXPECT_EQ(value.parts[0], -1);
    EXPECT_EQ(value.parts[2], -32767);
}

TEST(DataType, Short2Scaling) {
    const std::uint8_t bytes[4] = {0x40, 0x00, 0x05, 0xDC};  // 16384 of full scale 1500: the standard's 750 K
    TypedValue value;
    ASSERT_TRUE(decode_value(12, bytes, 4, value));
    EXPECT_NEAR(number_of(value), 750.02, 0.005);
    EXPECT_NEAR(number_of(short2_of(-89.5, 128)), -89.5, 128.0 / 32767 / 2);
    EXPECT_EQ(number_of(short2_of(500, 128)), 128) << "saturates";
}

TEST(DataType, WhatIsNoNumberSaysSo) {
    TypedValue value;
    const std::uint8_t bytes[4] = {1, 2, 3, 4};
    for (const std::uint8_t code : {0, 1, 15, 16, 18, 22, 23, 30, 31}) {
        ASSERT_TRUE(decode_value(code, bytes, 4, value));
        EXPECT_TRUE(std::isnan(number_of(value))) << int{code};
    }
}

TEST(DataType, HalvesOfADouble) {
    for (const double number : {47.2602, -180.0, 0.0, -0.0, 1e-300, std::numeric_limits<double>::infinity()}) {
        std::uint32_t high = 0;
        std::uint32_t low = 0;
        split_double(number, high, low);
        EXPECT_EQ(double_from_halves(high, low), number);
    }
    EXPECT_NEAR(double_from_halves(0x4047A14E, 0x3BCD35A8), 47.2602, 1e-12);
}

}  // namespace
}  // namespace tedavis::bus::test_data_type
