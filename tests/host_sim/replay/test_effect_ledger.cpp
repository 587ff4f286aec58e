#include "host_sim/replay/effect_ledger.hpp"

#include <gtest/gtest.h>

#include <set>

#include "render_core/display/preroll.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_effect_ledger {
namespace {

const test_support::FlownFiles& files() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

/// Two frames of the circle, flown on a device.
EffectLedger flown(const std::string& device, const std::string& design) {
    PictureOptions options = files().options("unused").picture;
    options.device = device;
    options.design = design;
    options.size = PictureSize{160, 120};
    EffectLedger ledger(options, *options.size, false, 2);
    DisplaySession session(options, false);
    FlightPlayer player({files().log, options.bus, "", "one_hot"}, session.display());
    for (std::uint64_t n = 0; n < 2; ++n) {
        const base::Time time = player.first() + base::Duration::seconds(3 + static_cast<int>(n));
        const flight::FrameInput instant = player.at(time);
        display::settle(session.display(), {instant.state, instant.phase, time});
        session.display().plan({instant.state, instant.phase, time, instant.trail});
        session.draw();
        ledger.note(session.display().record());
        ledger.take({n, time, instant.state, instant.phase, instant.legend, *instant.trail, upright(session.pixels())});
    }
    session.rest();
    return ledger;
}

const LedgerPrice* of(const std::vector<LedgerPrice>& prices, const std::string& effect) {
    for (const LedgerPrice& price : prices)
        if (price.effect == effect) return &price;
    return nullptr;
}

std::vector<LedgerPrice> prices_of(const EffectLedger& ledger) {
    return ledger.prices([](std::size_t, std::size_t) {});
}

TEST(EffectLedger, PricesWhatTheDeviceReplaces) {
    const std::vector<LedgerPrice> prices = prices_of(flown("es2-small", "effects/aerial_perspective"));
    const LedgerPrice* const air = of(prices, "aerial_perspective");
    ASSERT_NE(air, nullptr);
    ASSERT_EQ(air->fates.size(), 1u);
    EXPECT_EQ(air->fates[0].state, display::EffectState::replaced);
    EXPECT_EQ(air->fates[0].replaced_by, "haze");
    EXPECT_EQ(air->fates[0].frames, 2u);
    EXPECT_GT(air->difference.mean, 0) << "haze is not air";
    EXPECT_GE(air->difference.largest, air->difference.mean);
    EXPECT_EQ(air->intended.width, 160u);
    EXPECT_NE(air->intended.pixels, air->shown.pixels);
    const LedgerPrice* const all = of(prices, "");
    ASSERT_NE(all, nullptr);
    EXPECT_EQ(&prices.back(), all);
    EXPECT_GT(all->difference.mean, 0);
}

TEST(EffectLedger, HasNothingButTheWholeWhereNothingGivesWay) {
    const std::vector<LedgerPrice> prices = prices_of(flown("desktop", "effects/none"));
    for (const LedgerPrice& price : prices)
        EXPECT_EQ(price.difference.largest, 0) << price.effect << ": the reference shows the same as the run";
}

TEST(EffectLedger, SamplesAreSpreadOverTheRun) {
    for (const std::uint64_t frames : {0u, 1u, 7u, 8u, 9u, 400u}) {
        const EffectLedger ledger({}, {}, false, frames);
        std::set<std::uint64_t> samples;
        for (std::uint64_t n = 0; n < frames; ++n)
            if (ledger.wants(n)) samples.insert(n);
        EXPECT_EQ(samples.size(), std::min(frames, kLedgerSamples));
        if (frames > 0) {
            EXPECT_EQ(*samples.begin(), 0u);
            EXPECT_EQ(*samples.rbegin(), frames - 1);
        }
    }
    EXPECT_TRUE(prices_of(EffectLedger({}, {}, false, 0)).empty());
}

}  // namespace
}  // namespace tedavis::host_sim::test_effect_ledger
