#include "host_sim/pack/write_pack.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "host_sim/input_file.hpp"
#include "platform/configuration/pack_check.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_write_pack {
namespace {

using test_support::expect_user_error;
using ::testing::HasSubstr;

const PackProgress kNoProgress = [](std::uint64_t, std::uint64_t) {};

struct Sources {
    test_support::TemporaryFolder folder;
    std::string place = folder.file("pack");
    PackContents contents;

    explicit Sources(const std::string& text = "one") {
        contents.title = "a \"title\"";
        contents.config_text = "title = 'x'\n";
        contents.config_origin = "/etc/board.toml";
        contents.files = {{folder.write("one.toml", text), "a/one.toml", "of \"him\"", "", "2026-12-01"},
                          {folder.write("two.tdb", std::string(3'000'000, 'z')), "a/b/two.tdb", "", "", ""}};
    }
    [[nodiscard]] PackSettings settings(bool replaces = false) const { return {place, replaces, "2026-11-01", "2026-12-28", ""}; }
    platform::CheckedPack write(bool replaces = false, const PackProgress& progress = kNoProgress) const {
        return write_pack(contents, settings(replaces), progress);
    }
};

TEST(WritePack, IsAsItsManifestSays) {
    const Sources sources;
    const platform::CheckedPack found = sources.write();
    const auto pack = platform::check_pack(sources.place, nullptr);
    ASSERT_TRUE(pack.ok()) << pack.error().message.view();
    EXPECT_EQ(found.folder.view(), pack.value().folder.view());
    EXPECT_EQ(found.bytes, pack.value().bytes);
    EXPECT_EQ(pack.value().title.view(), "a \"title\"");
    EXPECT_EQ(pack.value().files, 3u);
    EXPECT_EQ(pack.value().valid_from.view(), "2026-11-01");
    EXPECT_EQ(pack.value().valid_until.view(), "2026-12-01") << "the file's is earlier";
    EXPECT_EQ(read_file(sources.place + "/a/b/two.tdb"), std::string(3'000'000, 'z'));
    const std::string manifest = read_file(sources.place + "/pack.toml");
    EXPECT_THAT(manifest, HasSubstr("origin = \"" + sources.folder.file("one.toml") + "\""));
    EXPECT_THAT(manifest, HasSubstr("origin = \"/etc/board.toml\""));
    EXPECT_THAT(manifest, HasSubstr("made_by = \"tedavis "));
    EXPECT_EQ(sources.folder.entries(), 3u) << "nothing is left beside it";
}

TEST(WritePack, AnEarlierPackIsReplacedOnlyWhereAsked) {
    const Sources sources;
    sources.write();
    expect_user_error([&] { sources.write(); }, "replace it with --replace");
    sources.folder.write("one.toml", "another");
    sources.write(true);
    EXPECT_EQ(read_file(sources.place + "/a/one.toml"), "another");
    EXPECT_EQ(sources.folder.entries(), 3u) << "the earlier one is gone";
}

TEST(WritePack, WhatIsNoPackIsNeverReplaced) {
    const Sources sources;
    std::filesystem::create_directory(sources.place);
    std::filesystem::create_directory(sources.place + "/pictures");
    expect_user_error([&] { sources.write(true); }, "is there and no pack");
    EXPECT_TRUE(std::filesystem::exists(sources.place + "/pictures"));
    PackSettings elsewhere = sources.settings();
    elsewhere.folder = sources.folder.file("absent/pack");
    expect_user_error([&] { write_pack(sources.contents, elsewhere, kNoProgress); }, "make it first");
    elsewhere.folder = sources.folder.file("one.toml");
    expect_user_error([&] { write_pack(sources.contents, elsewhere, kNoProgress); }, "is there and no pack");
}

/// Other tools have files of this name, too.
TEST(WritePack, AFolderIsReplacedOnlyWhereAllOfItIsAPacks) {
    const Sources sources;
    std::filesystem::create_directory(sources.place);
    sources.folder.write("pack/pack.toml", "[package]\nname = 'of another tool'\n");
    sources.folder.write("pack/thesis.tex", "years of work");
    expect_user_error([&] { sources.write(true); }, "is not replaced, for it is no sound pack");
    EXPECT_EQ(sources.folder.read("pack/thesis.tex"), "years of work");
    std::filesystem::remove_all(sources.place);
    sources.write();
    sources.folder.write("pack/a/notes.txt", "x");
    expect_user_error([&] { sources.write(true); }, "a/notes.txt: is not listed");
    EXPECT_EQ(sources.folder.read("pack/a/notes.txt"), "x");
    std::filesystem::remove(sources.place + "/a/notes.txt");
    sources.folder.write("pack/a/one.toml", "changed");
    sources.write(true);
    EXPECT_EQ(sources.folder.read("pack/a/one.toml"), "one") << "control: a damaged pack is replaced";
}

TEST(WritePack, WhatComesWhileItIsWrittenStays) {
    const Sources sources;
    const PackProgress make_folder = [&](std::uint64_t, std::uint64_t) {
        std::filesystem::create_directory(sources.place);
        sources.folder.write("pack/new.txt", "x");
    };
    for (const bool replaces : {false, true}) {
        expect_user_error([&] { sources.write(replaces, make_folder); }, "somebody made it while the pack was written");
        EXPECT_EQ(sources.folder.read("pack/new.txt"), "x");
        EXPECT_EQ(sources.folder.entries(), 3u) << "no part";
        std::filesystem::remove_all(sources.place);
    }
    sources.write();
    expect_user_error([&] { sources.write(true, make_folder); }, "new.txt: is not listed");
    EXPECT_EQ(sources.folder.read("pack/new.txt"), "x");
}

TEST(WritePack, AllMayReadItWhateverTheUmaskIs) {
    const Sources sources;
    const mode_t before = umask(077);
    sources.write();
    umask(before);
    for (const char* folder : {"", "/a", "/a/b"}) {
        struct stat status {};
        ASSERT_EQ(stat((sources.place + folder).c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777, 0755u) << folder;
    }
    for (const char* file : {"/pack.toml", "/config.toml", "/a/one.toml", "/a/b/two.tdb"}) {
        struct stat status {};
        ASSERT_EQ(stat((sources.place + file).c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777, 0644u) << file;
    }
}

TEST(WritePack, WholeOrNotAtAll) {
    const Sources sources;
    sources.write();
    const std::string before = read_file(sources.place + "/pack.toml");
    int calls = 0;
    const PackProgress stop = [&](std::uint64_t, std::uint64_t) {
        if (++calls == 3) throw UserError("stopped");
    };
    expect_user_error([&] { sources.write(true, stop); }, "stopped");
    std::filesystem::remove(sources.folder.file("two.tdb"));
    expect_user_error([&] { sources.write(true); }, "two.tdb: cannot be read");
    EXPECT_EQ(read_file(sources.place + "/pack.toml"), before);
    EXPECT_TRUE(platform::check_pack(sources.place, nullptr).ok());
    EXPECT_EQ(sources.folder.entries(), 2u) << "no part of the one that was stopped";
}

}  // namespace
}  // namespace tedavis::host_sim::test_write_pack
