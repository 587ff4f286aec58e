#include "render_core/raytrace/picture/choose_settings.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <vector>

namespace tedavis::raytrace {
namespace {

constexpr std::uint32_t kRegions = 300, kLevels = 3;

/// A machine whose regions cost what it says, with noise, and more as it becomes warm.
class SyntheticMachine {
public:
    explicit SyntheticMachine(std::uint32_t seed) : random_(seed) {}
    static constexpr float kTrue[kLevels][kRegionKinds] = {
        {0.01f, 0.04f, 0.05f, 0.06f}, {0.01f, 0.15f, 0.12f, 0.11f}, {0.01f, 1.6f, 0.9f, 0.7f}};

    double draw(const std::vector<RegionView>& regions, const std::vector<std::uint8_t>& levels, TraceCosts& costs) {
        double sum[kLevels][kRegionKinds] = {}, all = 0;
        std::uint32_t count[kLevels][kRegionKinds] = {};
        for (std::size_t n = 0; n < regions.size(); ++n) {
            const auto kind = static_cast<std::size_t>(regions[n].kind);
            const double ms = kTrue[levels[n]][kind] * heat * std::uniform_real_distribution<double>(0.9, 1.1)(random_);
            sum[levels[n]][kind] += ms;
            ++count[levels[n]][kind];
            all += ms;
        }
        for (std::uint32_t level = 0; level < kLevels; ++level)
            for (std::uint32_t kind = 0; kind < kRegionKinds; ++kind)
                if (count[level][kind] > 0)
                    costs.measure(level, static_cast<RegionKind>(kind),
                                  static_cast<float>(sum[level][kind] / count[level][kind]));
        return all;
    }
    double heat = 1;

private:
    std::mt19937 random_;
};

class ChooseSettings : public ::testing::Test {
protected:
    ChooseSettings() : memory_(SettingsChooser::bytes_needed(kRegions)), levels_(kRegions) {
        base::Arena arena(memory_.data(), memory_.size());
        EXPECT_TRUE(chooser_.start(kRegions, arena));
        std::mt19937 random(4);
        for (std::uint32_t n = 0; n < kRegions; ++n) {
            const auto kind = static_cast<RegionKind>(n * kRegionKinds / kRegions);  // sky above, near below
            const float nearness = static_cast<float>(kind) / 3;
            regions_.push_back({kind, nearness * std::uniform_real_distribution<float>(0.2f, 1)(random)});
        }
        limits_.levels = kLevels;
        limits_.error[0] = 0.1f;
        limits_.error[1] = 0.04f;
        limits_.deadline_ms = 60;
    }
    /// Wrong by a factor, as before anything is measured.
    static TraceCosts guessed(float factor) {
        TraceCosts costs;
        for (std::uint32_t level = 0; level < kLevels; ++level)
            for (std::uint32_t kind = 0; kind < kRegionKinds; ++kind)
                costs.expect(level, static_cast<RegionKind>(kind), factor * SyntheticMachine::kTrue[level][kind]);
        return costs;
    }
    std::vector<unsigned char> memory_;
    std::vector<std::uint8_t> levels_;
    SettingsChooser chooser_;
    std::vector<RegionView> regions_;
    ChoiceLimits limits_;
};

TEST_F(ChooseSettings, KeepsTheDeadlineOnceItHasMeasured) {
    SyntheticMachine machine(1);
    TraceCosts costs = guessed(0.4f);
    double worst = 0, least = 1e9;
    for (int frame = 0; frame < 200; ++frame) {
        const Choice choice = chooser_.choose(regions_, costs, limits_, levels_);
        EXPECT_TRUE(choice.keeps_deadline);
        const double ms = machine.draw(regions_, levels_, costs);
        if (frame < 5) continue;
        worst = std::max(worst, ms);
        least = std::min(least, ms);
    }
    EXPECT_LE(worst, limits_.deadline_ms * 1.05);
    EXPECT_GE(least, limits_.deadline_ms * 0.7);  // what there is, is used
    // A machine that becomes slower is followed within a few pictures.
    machine.heat = 1.6;
    int late = 0;
    for (int frame = 0; frame < 40; ++frame) {
        chooser_.choose(regions_, costs, limits_, levels_);
        late += machine.draw(regions_, levels_, costs) > limits_.deadline_ms * 1.05 ? 1 : 0;
    }
    EXPECT_LE(late, 12);
    EXPECT_GE(late, 1);
}

TEST_F(ChooseSettings, WithoutMeasurementsTheDeadlineBreaks) {
    SyntheticMachine machine(1);
    const TraceCosts guess = guessed(0.4f);
    TraceCosts ignored = guess;
    chooser_.choose(regions_, guess, limits_, levels_);
    EXPECT_GT(machine.draw(regions_, levels_, ignored), limits_.deadline_ms * 1.5);
}

TEST_F(ChooseSettings, NearAndLitRegionsComeFirst) {
    const TraceCosts costs = guessed(1);
    chooser_.choose(regions_, costs, limits_, levels_);
    std::uint32_t sums[kRegionKinds] = {}, pairs = 0;
    for (std::uint32_t n = 0; n < kRegions; ++n) sums[static_cast<std::size_t>(regions_[n].kind)] += levels_[n];
    EXPECT_EQ(sums[0], 0U);
    EXPECT_LE(sums[1], sums[2]);
    EXPECT_LT(sums[2], sums[3]);
    for (std::uint32_t a = 0; a < kRegions; ++a)
        for (std::uint32_t b = 0; b < kRegions; ++b) {
            if (regions_[a].kind != regions_[b].kind || regions_[a].weight <= regions_[b].weight) continue;
            ++pairs;
            EXPECT_GE(levels_[a], levels_[b]);
        }
    EXPECT_GT(pairs, 1000U);
}

TEST_F(ChooseSettings, AQualityIsReachedAtTheLeastCost) {
    const TraceCosts costs = guessed(1);
    limits_.deadline_ms = 0;
    limits_.most_error = 0;
    const Choice best = chooser_.choose(regions_, costs, limits_, levels_);
    EXPECT_NEAR(best.error, 0, 1e-6);
    double before = best.cost_ms;
    for (const float wanted : {0.01f, 0.03f, 0.06f, 0.2f}) {
        limits_.most_error = wanted;
        std::fill(levels_.begin(), levels_.end(), std::uint8_t{0});
        const Choice choice = chooser_.choose(regions_, costs, limits_, levels_);
        EXPECT_LE(choice.error, wanted);
        EXPECT_LT(choice.cost_ms, before);
        EXPECT_NEAR(choice.cost_ms, costs.sum(regions_, levels_), 1e-3);
        before = choice.cost_ms;
    }
    EXPECT_EQ(std::accumulate(levels_.begin(), levels_.end(), 0), 0);
}

TEST_F(ChooseSettings, DoesNotFlickerWhereWeightsAndCostsTremble) {
    const auto changes_with = [&](float hysteresis) {
        limits_.hysteresis = hysteresis;
        SyntheticMachine machine(7);
        TraceCosts costs = guessed(1);
        std::mt19937 random(3);
        std::fill(levels_.begin(), levels_.end(), std::uint8_t{0});
        std::size_t changes = 0;
        for (int frame = 0; frame < 100; ++frame) {
            std::vector<RegionView> trembling = regions_;
            for (RegionView& region : trembling) region.weight *= std::uniform_real_distribution<float>(0.97f, 1.03f)(random);
            const std::vector<std::uint8_t> last = levels_;
            chooser_.choose(trembling, costs, limits_, levels_);
            machine.draw(trembling, levels_, costs);
            for (std::uint32_t n = 0; n < kRegions && frame > 10; ++n) changes += last[n] != levels_[n] ? 1 : 0;
        }
        return changes;
    };
    const std::size_t steady = changes_with(0.15f), flickering = changes_with(0);
    EXPECT_LT(steady, 100U);
    EXPECT_GT(flickering, 5 * steady + 100);
}

TEST_F(ChooseSettings, IsTheSameForTheSameInputAndSaysWhatCannotBe) {
    const TraceCosts costs = guessed(1);
    std::vector<std::uint8_t> again(kRegions);
    chooser_.choose(regions_, costs, limits_, levels_);
    chooser_.choose(regions_, costs, limits_, again);
    EXPECT_EQ(levels_, again);
    chooser_.choose(regions_, costs, limits_, again);  // a choice stays as it is
    EXPECT_LE(std::inner_product(levels_.begin(), levels_.end(), again.begin(), 0, std::plus<>(),
                                 [](std::uint8_t a, std::uint8_t b) { return a > b ? 1 : 0; }),
              0);
    limits_.deadline_ms = 5;
    const Choice impossible = chooser_.choose(regions_, costs, limits_, levels_);
    EXPECT_FALSE(impossible.keeps_deadline);
    EXPECT_EQ(std::accumulate(levels_.begin(), levels_.end(), 0), 0);
    SettingsChooser none;
    base::Arena small(memory_.data(), 8);
    EXPECT_FALSE(none.start(kRegions, small));
}

}  // namespace
}  // namespace tedavis::raytrace
