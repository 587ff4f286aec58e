#include "host_sim/pack/packed_designs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "host_sim/input_file.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_packed_designs {
namespace {

using ::testing::ElementsAre;

const std::string kPalette = test_support::source_file("configs/palettes/grey.toml");

struct Packed {
    test_support::TemporaryFolder folder;
    PackedFiles files;

    Packed() {
        for (const char* name : {"own", "own/sub", "short", "palettes", "near"})
            std::filesystem::create_directory(folder.file(name));
        folder.write("palettes/mine.toml", kPalette);
        folder.write("near/by.toml", kPalette);
    }
    std::vector<std::string> places(const std::string& design, const DesignFolders& folders) {
        files.clear();
        PackedDesigns designs(folders, files);
        EXPECT_EQ(designs.add(folder.write("own/main.toml", design)), "design/main.toml");
        std::vector<std::string> found;
        for (const PackedFile& file : files) found.push_back(file.path);
        std::sort(found.begin(), found.end());
        return found;
    }
    [[nodiscard]] DesignFolders folders(bool has_designs) const {
        return {false, has_designs ? folder.file("short/") : "", folder.file("palettes/")};
    }
};

TEST(PackedDesigns, NamesStayRightAtTheirPlaces) {
    Packed packed;
    packed.folder.write("own/sub/base.toml", "name = 'base'\n[terrain]\npalette = '../../near/by.toml'\n");
    EXPECT_THAT(packed.places("name = 'main'\nbased_on = 'sub/base.toml'\n", packed.folders(false)),
                ElementsAre("design/main.toml", "design/sub/base.toml", "near/by.toml"));
    packed.folder.write("own/beside.toml", "name = 'beside'\n[terrain]\npalette = 'mine'\n");
    const std::string short_base = "name = 'main'\nbased_on = 'beside'\n";
    EXPECT_THAT(packed.places(short_base, packed.folders(false)),
                ElementsAre("design/beside.toml", "design/main.toml", "palettes/mine.toml"));
    packed.folder.write("short/beside.toml", "name = 'other'\n");
    EXPECT_THAT(packed.places(short_base, packed.folders(true)), ElementsAre("design/main.toml", "designs/beside.toml"));
    EXPECT_THAT(packed.places("name = 'main'\n[phases]\ncruise = 'beside'\n", packed.folders(true)),
                ElementsAre("design/main.toml", "designs/beside.toml"));
}

TEST(PackedDesigns, NamesThatNoPackCanKeepAreRefused) {
    Packed packed;
    const auto refused = [&](const std::string& palette, const std::string& words) {
        const std::string file = packed.folder.write("own/main.toml", "name = 'main'\n[terrain]\npalette = '" + palette + "'\n");
        PackedFiles files;
        test_support::expect_user_error([&] { static_cast<void>(PackedDesigns(packed.folders(false), files).add(file)); }, words);
    };
    refused(packed.folder.file("near/by.toml"), "holds on this machine alone");
    refused("../../" + std::filesystem::path(packed.folder.path()).filename().string() + "/near/by.toml",
            "more than one folder above");
    refused("absent", "absent.toml");
}

}  // namespace
}  // namespace tedavis::host_sim::test_packed_designs
