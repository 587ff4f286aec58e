#include "host_sim/pack/sign_pack.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <cstdlib>

#include "host_sim/pack/write_pack.hpp"
#include "host_sim/user_error.hpp"
#include "platform/configuration/pack_check.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_sign_pack {
namespace {

using ::testing::HasSubstr;

/// A pack that real minisign signed, which the packages of the desk bring.
struct SignPack : testing::Test {
    void SetUp() override {
        for (const char* name : {"own", "other"}) {
            const std::string make =
                "minisign -G -W -p " + folder.file(name) + ".pub -s " + folder.file(name) + ".sec >/dev/null";
            ASSERT_EQ(std::system(make.c_str()), 0);
        }
        contents.title = "signed";
        contents.config_text = "title = 'x'\n";
        contents.config_origin = "/etc/board.toml";
    }
    [[nodiscard]] std::string fault(const std::string& key) const {
        const auto pack = platform::check_pack(place, folder.file(key).c_str());
        return pack.ok() ? "" : std::string(pack.error().message.view());
    }
    test_support::TemporaryFolder folder;
    std::string place = folder.file("pack");
    PackContents contents;
};

TEST_F(SignPack, IsAcceptedWithItsKeyAlone) {
    write_pack(contents, {place, false, "", "", folder.file("own.sec")}, [](std::uint64_t, std::uint64_t) {});
    EXPECT_EQ(fault("own.pub"), "");
    EXPECT_TRUE(platform::check_pack(place, folder.file("own.pub").c_str()).value().is_signed);
    EXPECT_THAT(fault("other.pub"), HasSubstr("another key"));
    const std::string manifest = folder.read("pack/pack.toml");
    folder.write("pack/pack.toml", manifest + " ");
    EXPECT_THAT(fault("own.pub"), HasSubstr("pack.toml: is not what was signed"));
    EXPECT_TRUE(platform::check_pack(place, nullptr).ok()) << "control: by its sums it would pass";
}

/// A program of this name that is stopped as by Ctrl-C.
TEST(SignPackStopped, IsInterruptedAndNoFault) {
    const test_support::TemporaryFolder folder;
    const std::string program = folder.write("minisign", "#!/bin/sh\nkill -INT $$\n");
    const char* const given = std::getenv("PATH");
    const std::string path = given != nullptr ? given : "";
    ASSERT_EQ(chmod(program.c_str(), 0755), 0);
    setenv("PATH", (folder.path() + ":" + path).c_str(), 1);
    EXPECT_THROW(sign_with_minisign(program, program), Interrupted);
    folder.write("minisign", "#!/bin/sh\nexit 1\n");
    EXPECT_THROW(sign_with_minisign(program, program), UserError) << "control";
    setenv("PATH", path.c_str(), 1);
}

TEST_F(SignPack, WhatCannotSignLeavesNoPack) {
    const auto refused = [&](const std::string& key, const std::string& words) {
        test_support::expect_user_error(
            [&] {
                write_pack(contents, {place, false, "", "", key}, [](std::uint64_t, std::uint64_t) {});
            },
            words);
        EXPECT_EQ(folder.entries(), 4u) << "the keys alone";
    };
    refused(folder.file("own.pub"), "does not sign with this key");
    refused(folder.file("absent.sec"), "absent.sec");
}

}  // namespace
}  // namespace tedavis::host_sim::test_sign_pack
