#include "platform/configuration/pack_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <ctime>
#include <map>
#include <string>

#include "tests/support/files/changing_file.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::platform::test_pack_check {
namespace {

using ::testing::HasSubstr;

/// Of coreutils: not ours.
std::string sha256sum(const std::string& path) {
    std::FILE* const pipe = popen(("sha256sum '" + path + "'").c_str(), "r");
    char digits[65] = "";
    EXPECT_EQ(std::fread(digits, 1, 64, pipe), 64u);
    pclose(pipe);
    return digits;
}

struct MadePack {
    test_support::TemporaryFolder folder;
    std::map<std::string, std::string> files{
        {"config.toml", "title = 'x'\n"}, {"a/one.toml", "1"}, {"a/two.tdb", std::string(70'000, 'z')}, {"empty", ""}};
    std::string head = "title = 'a pack'\nmade = 'now'\nmade_by = 'a test'\n";
    std::string of_files = "";

    MadePack() {
        mkdir(folder.file("a").c_str(), 0755);
        for (const auto& [name, text] : files) folder.write(name, text);
        write_manifest();
    }
    std::string entry(const std::string& name) const {
        return "[[file]]\npath = '" + name + "'\nbytes = " + std::to_string(files.at(name).size()) + "\nsha256 = '" +
               sha256sum(folder.file(name)) + "'\norigin = '/x'\nsources = 'y'\n";
    }
    void write_manifest(const std::string& dates_of_one = "") {
        std::string text = head;
        for (const auto& [name, content] : files) text += entry(name) + (name == "a/one.toml" ? dates_of_one : "");
        folder.write("pack.toml", text);
    }
    [[nodiscard]] base::Result<CheckedPack, ConfigError> check() const { return check_pack(folder.path(), nullptr); }
    [[nodiscard]] std::string fault() const {
        const auto pack = check();
        return pack.ok() ? "" : std::string(pack.error().message.view());
    }
};

TEST(PackCheck, ASoundPackIsAccepted) {
    const MadePack made;
    const auto pack = made.check();
    ASSERT_TRUE(pack.ok()) << pack.error().message.view();
    EXPECT_EQ(pack.value().title.view(), "a pack");
    EXPECT_EQ(pack.value().files, 4u);
    EXPECT_EQ(pack.value().bytes, 70'013u);
    EXPECT_EQ(pack.value().folder.view(), made.folder.path() + "/");
    EXPECT_FALSE(pack.value().is_signed);
    EXPECT_FALSE(confirm_pack(pack.value()));
    EXPECT_FALSE(confirm_pack({})) << "no pack";
}

TEST(PackCheck, AChangedMissingOrFurtherByteNamesItsFile) {
    const MadePack made;
    for (const auto& [name, text] : made.files) {
        if (!text.empty()) {
            std::string changed = text;
            changed[changed.size() / 2] = static_cast<char>(changed[changed.size() / 2] ^ 1);
            made.folder.write(name, changed);
            EXPECT_THAT(made.fault(), HasSubstr(made.folder.file(name) + ": was changed after packing"));
            made.folder.write(name, text.substr(1));
            EXPECT_THAT(made.fault(), HasSubstr(made.folder.file(name) + ": has "));
        }
        made.folder.write(name, text + "+");
        EXPECT_THAT(made.fault(), HasSubstr(made.folder.file(name) + ": has "));
        std::remove(made.folder.file(name).c_str());
        EXPECT_THAT(made.fault(), HasSubstr(made.folder.file(name) + ": cannot be read"));
        made.folder.write(name, text);
        EXPECT_EQ(made.fault(), "") << "control";
    }
}

TEST(PackCheck, FilesThatAreNotListedAreNamed) {
    const MadePack made;
    for (const char* name : {"more.toml", "a/more.toml", ".hidden"}) {
        made.folder.write(name, "x");
        EXPECT_THAT(made.fault(), HasSubstr(made.folder.file(name) + ": is not listed"));
        std::remove(made.folder.file(name).c_str());
    }
    mkdir(made.folder.file("b").c_str(), 0755);
    EXPECT_THAT(made.fault(), HasSubstr(made.folder.file("b") + ": is not listed"));
    rmdir(made.folder.file("b").c_str());
    made.folder.write("pack.toml.minisig", "x");
    EXPECT_EQ(made.fault(), "") << "without a key nobody looks at the signature";
}

TEST(PackCheck, FoldersOnTheWayToAFileAreLookedInto) {
    MadePack made;
    for (const char* folder : {"b", "b/c"}) mkdir(made.folder.file(folder).c_str(), 0755);
    made.files["b/c/listed"] = "x";
    made.folder.write("b/c/listed", "x");
    made.write_manifest();
    EXPECT_EQ(made.fault(), "") << "control";
    made.folder.write("b/extra", "x");
    EXPECT_THAT(made.fault(), HasSubstr(made.folder.file("b/extra") + ": is not listed"));
}

TEST(PackCheck, LinksAreRefusedEvenWhereTheBytesAreRight) {
    const MadePack made;
    const test_support::TemporaryFolder elsewhere;
    const std::string file = made.folder.file("a/one.toml");
    std::rename(file.c_str(), elsewhere.file("one.toml").c_str());
    ASSERT_EQ(symlink(elsewhere.file("one.toml").c_str(), file.c_str()), 0);
    EXPECT_THAT(made.fault(), HasSubstr(file + ": is no regular file"));
    std::remove(file.c_str());
    std::rename(elsewhere.file("one.toml").c_str(), file.c_str());
    EXPECT_EQ(made.fault(), "") << "control";
    std::rename(made.folder.file("a").c_str(), elsewhere.file("a").c_str());
    ASSERT_EQ(symlink(elsewhere.file("a").c_str(), made.folder.file("a").c_str()), 0);
    EXPECT_THAT(made.fault(), HasSubstr(made.folder.file("a") + ": is no folder"));
}

TEST(PackCheck, AListedPackHoldsNothingElse) {
    const MadePack made;
    made.folder.write("a/two.tdb", "other bytes");
    std::remove(made.folder.file("empty").c_str());
    const auto listed = list_pack(made.folder.path());
    ASSERT_TRUE(listed.ok()) << listed.error().message.view() << ": what the files hold is not read";
    EXPECT_EQ(listed.value().files, 4u);
    made.folder.write("a/notes.txt", "x");
    EXPECT_THAT(list_pack(made.folder.path()).error().message.c_str(), HasSubstr("a/notes.txt: is not listed"));
    made.folder.write("pack.toml", "[package]\nname = 'of another tool'\n");
    EXPECT_THAT(list_pack(made.folder.path()).error().message.c_str(), HasSubstr("pack.toml"));
}

TEST(PackCheck, ManifestsAreReadStrictly) {
    MadePack made;
    const std::string sound = made.folder.read("pack.toml");
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = sound;
        text.replace(text.find(from), from.size(), to);
        made.folder.write("pack.toml", text);
        return made.fault();
    };
    for (const char* path : {"/etc/passwd", "../x", "a/../../x", "", "a//b", "a/", "..", "a/.."})
        EXPECT_THAT(with("path = 'a/one.toml'", std::string("path = '") + path + "'"), HasSubstr("no path within the pack"))
            << path;
    EXPECT_THAT(with("path = 'config.toml'", "path = 'empty'"), HasSubstr("is listed twice"));
    EXPECT_THAT(with("path = 'config.toml'", "path = 'other'"), HasSubstr("lists no config.toml"));
    EXPECT_THAT(with("made_by", "made_buy = 'x'\nmade_by"), HasSubstr("made_buy"));
    EXPECT_THAT(with("bytes = 1\n", "bytes = -1\n"), HasSubstr("bytes"));
    EXPECT_THAT(with("made =", "valid_until = '2026-02-29'\nmade ="), HasSubstr("pack.toml:2"));
    std::remove(made.folder.file("pack.toml").c_str());
    EXPECT_THAT(made.fault(), HasSubstr("is no pack"));
}

TEST(PackCheck, WhatIsWrittenOrReplacedDuringTheStartIsFound) {
    const MadePack made;
    const CheckedPack pack = made.check().value();
    made.folder.write("a/one.toml", "1");
    EXPECT_THAT(confirm_pack(pack).message.c_str(), HasSubstr("replaced or changed during the start"))
        << "equal bytes, written anew";
    EXPECT_EQ(made.fault(), "");
    const CheckedPack again = made.check().value();
    EXPECT_FALSE(confirm_pack(again));
    const std::string aside = made.folder.file("a") + ".aside";
    std::rename(made.folder.file("a/one.toml").c_str(), aside.c_str());
    EXPECT_TRUE(confirm_pack(again));
}

/// Nearly each try meets a change; that one of so many does is sure.
TEST(PackCheck, WhatChangesWhileItIsReadMayPassTheNextTime) {
    constexpr int kTries = 10'000;
    const MadePack made;
    bool may_pass = false;
    {
        const test_support::ChangingFile changing(made.folder.file("a/one.toml"), "2", "1");
        for (int n = 0; n < kTries && !may_pass; ++n) {
            const auto pack = made.check();
            may_pass = !pack.ok() && pack.error().may_pass;
            if (may_pass) {
                EXPECT_THAT(pack.error().message.c_str(), HasSubstr("changed during the start"));
            }
        }
    }
    EXPECT_TRUE(may_pass);
    ASSERT_FALSE(made.check().ok());
    EXPECT_FALSE(made.check().error().may_pass) << "control: now it is wrong for good";
}

TEST(PackCheck, AFaultOfAStartIsThatThePackChangedWhereItDid) {
    const MadePack made;
    const CheckedPack pack = made.check().value();
    const base::Error fault = base::make_error("a fault");
    EXPECT_STREQ(fault_of_start(pack, fault).message.c_str(), "a fault");
    EXPECT_FALSE(fault_of_start(pack, fault).may_pass);
    EXPECT_FALSE(fault_of_start({}, fault).may_pass) << "no pack";
    made.folder.write("a/one.toml", "1");
    EXPECT_TRUE(fault_of_start(pack, fault).may_pass);
    EXPECT_THAT(fault_of_start(pack, fault).message.c_str(), HasSubstr("changed during the start"));
}

/// At noon.
base::Time noon_of(const char* day) { return start_of_day(day) + base::Duration{kUtcDay.ns / 2}; }

TEST(PackCheck, AClockThatWasNotSetTellsNoDay) {
    MadePack made;
    made.head += "valid_from = '2026-12-01'\n";
    made.write_manifest();
    const CheckedPack pack = made.check().value();
    EXPECT_EQ(words_of_age(pack, {0}).view(), "") << "1970";
    EXPECT_EQ(words_of_age(pack, noon_of("1999-12-31")).view(), "");
    EXPECT_THAT(words_of_age(pack, start_of_day("2000-01-01")).c_str(), HasSubstr("and this is 2000-01-01"));
}

TEST(PackCheck, DatesAreTheNarrowestThatAreStated) {
    MadePack made;
    made.head += "valid_from = '2026-12-01'\nvalid_until = '2026-12-28'\n";
    made.write_manifest();
    const auto words = [&](const char* day) { return std::string(words_of_age(made.check().value(), noon_of(day)).view()); };
    EXPECT_EQ(words("2026-12-01"), "");
    EXPECT_EQ(words("2026-12-28"), "") << "the last day counts";
    EXPECT_THAT(words("2026-12-29"), HasSubstr("/: was valid until 2026-12-28, and this is 2026-12-29"));
    EXPECT_THAT(words("2026-11-30"), HasSubstr(": is valid from 2026-12-01"));
    made.write_manifest("valid_until = '2026-12-10'\nvalid_from = '2020-01-01'\n");
    EXPECT_THAT(words("2026-12-11"), HasSubstr("/a/one.toml: was valid until 2026-12-10"));
    EXPECT_EQ(words("2026-12-10"), "");
    made.head = "title = 'a pack'\nmade = 'now'\nmade_by = 'a test'\n";
    made.write_manifest();
    EXPECT_EQ(words("2000-01-01"), "") << "none is stated";
}

/// What a display is started with, and what is said, turn at the same instants: those of the days by the C library's calendar.
TEST(PackCheck, ThePeriodBeginsAndEndsWhereTheWordsDo) {
    CheckedPack pack;
    EXPECT_FALSE(valid_period(pack).begin || valid_period(pack).end) << "no dates";
    pack.valid_from = "2026-02-28";
    EXPECT_FALSE(valid_period(pack).end);
    pack.valid_until = "2028-02-29";
    std::tm first{}, after{};
    first.tm_year = 126, first.tm_mon = 1, first.tm_mday = 28;
    after.tm_year = 128, after.tm_mon = 2, after.tm_mday = 1;
    const base::Time begin{timegm(&first) * 1'000'000'000}, end{timegm(&after) * 1'000'000'000};
    EXPECT_EQ(valid_period(pack).begin, begin);
    EXPECT_EQ(valid_period(pack).end, end);
    const base::Duration instant{1};
    for (const base::Time utc : {begin - instant, begin, begin + instant, end - instant, end, end + instant})
        EXPECT_EQ(words_of_age(pack, utc).empty(), base::currency_at(valid_period(pack), utc) == base::Currency::current);
    EXPECT_FALSE(words_of_age(pack, begin - instant).empty()) << "control";
    EXPECT_FALSE(words_of_age(pack, end).empty()) << "control";
}

TEST(PackCheck, AFolderMeansItsConfiguration) {
    const MadePack made;
    const std::string config = made.folder.file("config.toml");
    for (const std::string& named : {made.folder.path(), made.folder.path() + "/", config}) {
        const auto found = find_config(named.c_str(), nullptr);
        ASSERT_TRUE(found.ok()) << found.error().message.view();
        EXPECT_EQ(found.value().file.view(), config);
        EXPECT_TRUE(found.value().pack.is_pack());
    }
    const test_support::TemporaryFolder plain;
    const std::string file = plain.write("board.toml", "x");
    EXPECT_FALSE(find_config(file.c_str(), nullptr).value().pack.is_pack());
    EXPECT_EQ(find_config("/nowhere/board.toml", nullptr).value().file.view(), "/nowhere/board.toml")
        << "whoever reads it says so";
    EXPECT_THAT(find_config(plain.path().c_str(), nullptr).error().message.c_str(), HasSubstr("is no pack"));
}

/// tests/platform/configuration/test_minisign.cpp has signatures that hold.
TEST(PackCheck, WithAKeyAnUnsignedPackIsRefused) {
    const MadePack made;
    const test_support::TemporaryFolder keys;
    const std::string key = keys.write(
        "pack.pub",
        "untrusted comment: minisign public key C659D84D2214F1ED\nRWTt8RQiTdhZxqxF1UvwXA/qhYVP8iYP+yUVxVPP7tPIyykCczHCU+pM\n");
    EXPECT_THAT(check_pack(made.folder.path(), key.c_str()).error().message.c_str(), HasSubstr("pack.toml: is not signed"));
    EXPECT_TRUE(check_pack(made.folder.path(), keys.file("absent.pub").c_str()).ok()) << "no key is installed";
}

TEST(PackCheck, AKeyThatCannotBeReadIsNotAnAbsentOne) {
    const MadePack made;
    const test_support::TemporaryFolder keys;
    const auto fault = [&](const std::string& key) {
        const auto pack = check_pack(made.folder.path(), key.c_str());
        return pack.ok() ? std::string() : std::string(pack.error().message.view());
    };
    ASSERT_EQ(symlink("nowhere", keys.file("dangling.pub").c_str()), 0);
    ASSERT_EQ(symlink("loop", keys.file("loop").c_str()), 0);
    keys.write("file", "x");
    for (const char* key : {"dangling.pub", "loop", "loop/pack.pub", "file/pack.pub"})
        EXPECT_THAT(fault(keys.file(key)), HasSubstr(keys.file(key))) << key;
    EXPECT_EQ(fault(keys.file("absent.pub")), "") << "control";
    EXPECT_EQ(fault(keys.file("absent/pack.pub")), "") << "nor is its folder there";
}

TEST(PackCheck, AManifestThatCannotBeReadIsNotAnAbsentOne) {
    const test_support::TemporaryFolder plain;
    const std::string file = plain.write("board.toml", "x");
    ASSERT_TRUE(find_config(file.c_str(), nullptr).ok()) << "control";
    ASSERT_EQ(symlink("nowhere", plain.file("pack.toml").c_str()), 0);
    const auto found = find_config(file.c_str(), nullptr);
    ASSERT_FALSE(found.ok());
    EXPECT_THAT(found.error().message.c_str(), HasSubstr("pack.toml"));
    EXPECT_FALSE(find_config((file + "/board.toml").c_str(), nullptr).ok()) << "a file is no folder";
    const std::string folder = plain.path() + "/" + std::string(1010 - plain.path().size(), 'd') + "/f";
    EXPECT_THAT(find_config(folder.c_str(), nullptr).error().message.c_str(), HasSubstr("too long"))
        << "the manifest beside it could not be named";
}

}  // namespace
}  // namespace tedavis::platform::test_pack_check
