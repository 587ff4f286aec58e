#include "render_core/base/hash.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <string>
#include <vector>

namespace tedavis::base::test_hash {
namespace {

std::uint64_t fnv(const std::string& text) {
    Fnv1a64 hash;
    hash.add(text.data(), text.size());
    return hash.value();
}

TEST(Fnv1a64, agrees_with_the_published_test_vectors) {
    EXPECT_EQ(fnv(""), 0xcbf29ce484222325u);
    EXPECT_EQ(fnv("a"), 0xaf63dc4c8601ec8cu);
    EXPECT_EQ(fnv("foobar"), 0x85944171f73967e8u);
}

TEST(Fnv1a64, pieces_make_no_difference) {
    const std::string text = "one skyline, two pixels";
    for (std::size_t cut = 0; cut <= text.size(); ++cut) {
        Fnv1a64 hash;
        hash.add(text.data(), cut);
        hash.add(text.data() + cut, text.size() - cut);
        EXPECT_EQ(hash.value(), fnv(text));
    }
}

TEST(Fnv1a64, integers_are_added_as_little_endian_bytes) {
    Fnv1a64 hash;
    hash.add_u32_little_endian(0x04030201u);
    EXPECT_EQ(hash.value(), fnv("\x01\x02\x03\x04"));
}

TEST(FrameHash, covers_size_and_rows_top_first) {
    const std::vector<std::uint8_t> rows = {1, 2, 3, 4, 5, 6, 7, 8};  // two rows of one pixel
    EXPECT_EQ(frame_hash(rows.data(), 1, 2, false), fnv(std::string("\x01\0\0\0\x02\0\0\0\x01\x02\x03\x04\x05\x06\x07\x08", 16)));
    EXPECT_EQ(frame_hash(rows.data(), 1, 2, true), fnv(std::string("\x01\0\0\0\x02\0\0\0\x05\x06\x07\x08\x01\x02\x03\x04", 16)));
    EXPECT_NE(frame_hash(rows.data(), 2, 1, false), frame_hash(rows.data(), 1, 2, false)) << "the shape counts";
}

/// The definition, bit by bit, without a table.
std::uint32_t crc32_by_definition(const std::string& text) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const char c : text)
        for (int bit = 0; bit < 8; ++bit) {
            const std::uint32_t in = (static_cast<unsigned char>(c) >> bit) & 1u;
            crc = (crc >> 1) ^ (((crc ^ in) & 1u) != 0 ? 0xEDB88320u : 0u);
        }
    return ~crc;
}

TEST(Crc32, agrees_with_the_check_value_and_the_definition) {
    EXPECT_EQ(crc32("123456789", 9), 0xCBF43926u);
    EXPECT_EQ(crc32("", 0), 0u);
    std::mt19937 random(11);
    for (int length = 0; length < 200; ++length) {
        std::string text;
        for (int i = 0; i < length; ++i) text += static_cast<char>(random());
        ASSERT_EQ(crc32(text.data(), text.size()), crc32_by_definition(text));
    }
}

TEST(Crc32, continues_where_it_stopped) {
    const std::string text = "chunk after chunk";
    for (std::size_t cut = 0; cut <= text.size(); ++cut)
        EXPECT_EQ(crc32(text.data() + cut, text.size() - cut, crc32(text.data(), cut)), crc32(text.data(), text.size()));
}

TEST(Crc32, finds_every_single_flipped_bit) {
    std::string text(1024, '\0');
    std::mt19937 random(12);
    for (char& c : text) c = static_cast<char>(random());
    const std::uint32_t whole = crc32(text.data(), text.size());
    for (std::size_t bit = 0; bit < text.size() * 8; ++bit) {
        text[bit / 8] = static_cast<char>(text[bit / 8] ^ (1 << (bit % 8)));
        ASSERT_NE(crc32(text.data(), text.size()), whole) << "bit " << bit;
        text[bit / 8] = static_cast<char>(text[bit / 8] ^ (1 << (bit % 8)));
    }
}

}  // namespace
}  // namespace tedavis::base::test_hash
