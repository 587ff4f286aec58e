#include "platform/configuration/minisign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::platform::test_minisign {
namespace {

using ::testing::HasSubstr;

// Written by minisign 0.11 of Debian 12: `minisign -G -W`, `minisign -S -t 'for the tests'`, and with -l the older kind.
const std::string kContent = "title = \"a pack\"\n";
const std::string kKey =
    "untrusted comment: minisign public key C659D84D2214F1ED\nRWTt8RQiTdhZxqxF1UvwXA/qhYVP8iYP+yUVxVPP7tPIyykCczHCU+pM\n";
const std::string kSignature =
    "untrusted comment: signature from minisign secret key\n"
    "RUTt8RQiTdhZxvZ6yG67Ovp0w/UhsA5tdTQLgiOmKqZgGpJXEDe/fLUEXf86eF5H0R/5AQ6ABNZVx87Xd1Un4VLCIGy4yw7k8Qk=\n"
    "trusted comment: for the tests\n"
    "np8WancocKYc8GY0pc1L/83+7rvfNBTFRxGlnKI1VF6wog9T1/QmQmGK234/wGPu1Y+LsNLsE662GIpvtO6BDw==\n";
const std::string kOlderKind =
    "untrusted comment: signature from minisign secret key\n"
    "RWTt8RQiTdhZxs4XdsgCi+hLt/VDr1cqqjCsfPy37yD6mWc20HRkZawf8OX1Et1FjsFanZ9kbwwFttfe+Z6vNIz7rX2L2XsFwg8=\n"
    "trusted comment: timestamp:1795999558\tfile:pack.toml\n"
    "AsTqiPLgdtibmF7wtemhpVMJKdqO7v+DsdZQDtgx870Fpxn5gsq4D+eFdxdBewBjSYrujvnHgK8rJwRniQHWDw==\n";

struct Signed {
    test_support::TemporaryFolder folder;

    std::string check(const std::string& content, const std::string& signature, const std::string& key = kKey) {
        const std::string file = folder.write("pack.toml", content), public_key = folder.write("pack.pub", key);
        folder.write("pack.toml.minisig", signature);
        return std::string(verify_minisign(content, file, public_key.c_str()).message.view());
    }
};

TEST(Minisign, AcceptsWhatMinisignSigned) { EXPECT_EQ(Signed().check(kContent, kSignature), ""); }

TEST(Minisign, EachChangedBitOfTheContentIsFound) {
    Signed files;
    for (std::size_t bit = 0; bit < 8 * kContent.size(); ++bit) {
        std::string changed = kContent;
        changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
        EXPECT_THAT(files.check(changed, kSignature), HasSubstr("is not what was signed")) << "bit " << bit;
    }
}

/// All but the untrusted comment, whose name says it.
TEST(Minisign, EachChangedByteOfTheSignatureIsRefused) {
    Signed files;
    for (std::size_t n = kSignature.find('\n'); n < kSignature.size() - 1; ++n) {
        std::string changed = kSignature;
        changed[n] = changed[n] == 'A' ? 'B' : 'A';
        EXPECT_NE(files.check(kContent, changed), "") << "byte " << n;
    }
    std::string comment = kSignature;
    comment.replace(comment.find("for the"), 7, "for All");
    EXPECT_THAT(files.check(kContent, comment), HasSubstr("its comment was changed"));
    comment = kSignature;
    comment.replace(0, 10, "UNTRUSTED ");
    EXPECT_EQ(files.check(kContent, comment), "") << "control: this line is not signed";
}

TEST(Minisign, OtherKeysKindsAndFilesAreSentences) {
    Signed files;
    std::string other = kKey;
    other.replace(other.find("RWTt8R") + 4, 2, "9S");
    EXPECT_THAT(files.check(kContent, kSignature, other), HasSubstr("is of another key"));
    EXPECT_THAT(files.check(kContent, kOlderKind), HasSubstr("kind without a hash"));
    EXPECT_THAT(files.check(kContent, "none"), HasSubstr("no signature of minisign"));
    EXPECT_THAT(files.check(kContent, kSignature, "none"), HasSubstr("no public key of minisign"));
    const test_support::TemporaryFolder bare;
    const std::string file = bare.write("pack.toml", kContent), key = bare.write("pack.pub", kKey);
    EXPECT_THAT(verify_minisign(kContent, file, key.c_str()).message.c_str(), HasSubstr("pack.toml: is not signed"));
    EXPECT_THAT(verify_minisign(kContent, file, bare.file("absent.pub").c_str()).message.c_str(), HasSubstr("absent.pub"));
}

}  // namespace
}  // namespace tedavis::platform::test_minisign
