#include "host_sim/replay/ledger_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_ledger_report {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<LedgerPrice> prices() {
    LedgerPrice air;
    air.effect = "aerial_perspective";
    air.fates = {{display::EffectState::replaced, "haze", "the device lacks ES 3", 40},
                 {display::EffectState::skipped, "", "it cannot be seen", 2}};
    air.saved = {3.25, 0.5};
    air.difference = {1.5, 20, 0.25};
    air.worst_frame = 7;
    air.intended = air.shown = {1, 1, {1, 2, 3, 255}};
    LedgerPrice all = air;
    all.effect.clear();
    all.fates.clear();
    return {air, all};
}

TEST(LedgerReport, SaysWhatEachEffectCostAndWhy) {
    std::vector<LedgerSample> samples(2);
    samples[1].frame = 41;
    const auto json = nlohmann::json::parse(ledger_json(prices(), samples, "es2-small"));
    EXPECT_EQ(json["device"], "es2-small");
    EXPECT_THAT(json["frames"], ElementsAre(0, 41));
    const auto air = json["effects"][0];
    EXPECT_EQ(air["effect"], "aerial_perspective");
    EXPECT_EQ(air["fates"][0]["replaced_by"], "haze");
    EXPECT_EQ(air["fates"][0]["frames"], 40);
    EXPECT_EQ(air["fates"][1]["state"], "skipped");
    EXPECT_FALSE(air["fates"][1].contains("replaced_by"));
    EXPECT_EQ(air["ms_saved"], 3.25);
    EXPECT_EQ(air["delta_e_max"], 20);
    EXPECT_EQ(air["edge_difference"], 0.25);
    EXPECT_EQ(json["effects"].size(), 1u);
    EXPECT_EQ(json["all"]["worst_frame"], 7);
    const std::string text = ledger_text(prices());
    EXPECT_THAT(text, HasSubstr("haze: the device lacks ES 3; nothing: it cannot be seen"));
    EXPECT_THAT(text, HasSubstr("3.25"));
}

TEST(LedgerReport, PicturesOfAnEarlierRunAreGone) {
    const test_support::TemporaryFolder folder;
    write_ledger(folder.path(), "{}", prices());
    std::vector<LedgerPrice> later = prices();
    later[0].effect = "haze";
    write_ledger(folder.path(), "{}\n", later);
    EXPECT_EQ(folder.read("ledger.json"), "{}\n");
    for (const char* name : {"haze_intended.png", "haze_shown.png", "all_intended.png", "all_shown.png"})
        EXPECT_EQ(read_png(folder.path() + "/ledger/" + name).pixels, later[0].shown.pixels);
    EXPECT_TRUE(folder.read("ledger/aerial_perspective_shown.png").empty());
}

}  // namespace
}  // namespace tedavis::host_sim::test_ledger_report
