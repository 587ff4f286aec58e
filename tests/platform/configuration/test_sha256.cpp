#include "platform/configuration/sha256.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/files/memory_bytes.hpp"

namespace tedavis::platform::test_sha256 {
namespace {

std::string of_pieces(const std::string& text, std::size_t piece) {
    Sha256 sha;
    for (std::size_t at = 0; at < text.size(); at += piece) sha.add(text.data() + at, std::min(piece, text.size() - at));
    return std::string(hex_of(sha.digest()).view());
}

// FIPS 180-4 and its examples (NIST, "SHA256.pdf"; the million letters of FIPS 180-2).
TEST(Sha256, GivesThePublishedDigests) {
    EXPECT_EQ(of_pieces("abc", 3), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(of_pieces("", 1), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(of_pieces("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq", 7),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(of_pieces(std::string(1'000'000, 'a'), 4099), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, ASourceIsReadToItsEnd) {
    for (const std::size_t size : {0, 1, 65'535, 65'536, 65'537, 200'000}) {
        std::string text(size, '\0');
        for (std::size_t n = 0; n < size; ++n) text[n] = static_cast<char>(n * 31 + n / 255);
        const std::vector<std::uint8_t> bytes(text.begin(), text.end());
        test_support::MemoryBytes source(bytes);
        Sha256Digest digest{};
        ASSERT_TRUE(hash_source(source, digest));
        EXPECT_EQ(hex_of(digest).view(), of_pieces(text, 1000));
    }
}

}  // namespace
}  // namespace tedavis::platform::test_sha256
