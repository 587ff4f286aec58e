// Every technique over the real data round Davos: the sheet that shows them is drawn, small, and every picture shows its data.
#include <gtest/gtest.h>

#include "host_sim/commands/sheet.hpp"
#include "host_sim/commands/sheet_plan.hpp"
#include "tests/real/davos_files.hpp"
#include "tests/support/programs/command_run.hpp"

namespace tedavis::test_davos_sheet {
namespace {

TEST(DavosSheet, EveryPictureShowsItsData) {
    const test_support::DavosFiles davos;
    host_sim::SheetOptions options;
    options.sheet = davos.folder.file("sheets/data-techniques.toml");
    options.output = davos.folder.file("out");
    options.picture.size = host_sim::PictureSize{160, 120};
    const auto told = test_support::run_command([&](host_sim::Console& console) { return run_sheet(options, console); }, true);
    ASSERT_EQ(told.code, 0) << told.notes;
    const auto json = told.json();
    EXPECT_EQ(json.at("pictures").size(), host_sim::read_sheet_plan(options.sheet).picture_count());
    std::string before;  // the hash of the picture before
    for (const auto& picture : json.at("pictures")) {
        const std::string title = picture.at("title"), hash = picture.at("hash");
        const bool is_second = title.find(", all detail") != std::string::npos;
        EXPECT_TRUE(!is_second || hash != before) << title << ": little detail looks otherwise";
        before = hash;
        std::uint64_t shown = 0;
        for (const auto& count : picture.at("data"))
            shown += count.at("drawn").get<std::uint64_t>() + count.at("aggregated").get<std::uint64_t>();
        EXPECT_TRUE(picture.at("data").empty() || shown > 0) << title;
        EXPECT_EQ(picture.at("flags").dump().find("data.missing"), std::string::npos) << picture.at("title");
        EXPECT_EQ(picture.at("flags").dump().find("terrain.outside"), std::string::npos) << picture.at("title");
    }
}

}  // namespace
}  // namespace tedavis::test_davos_sheet
