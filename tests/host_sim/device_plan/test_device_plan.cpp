#include "host_sim/device_plan/device_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/user_error.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_device_plan {
namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;

/// A design that asks for everything, on a terrain that has it.
DeviceNeeds all_needs() {
    DeviceNeeds needs;
    needs.design = "full";
    design::TerrainStyle style;
    style.shade.baked_normals = style.shade.cast_shadows = true;
    needs.maps.add(style);
    needs.has_drape = needs.has_shadows = true;
    return needs;
}

DeviceAsk ask_for(std::uint64_t bytes) { return {"x", {640, 480}, 30, bytes, std::to_string(bytes)}; }

std::vector<effects::DeviceSettings> shipped() {
    return {test_support::shipped_device("desktop"), test_support::shipped_device("es3-mid"),
            test_support::shipped_device("es2-small")};
}

/// A start that takes three bytes a pixel off screen, where there are such pictures, and refuses what `least` says.
struct Starts {
    LineBytes least;
    int count = 0;

    StartedDevice operator()(const effects::DeviceSettings& device) {
        ++count;
        StartedDevice started;
        for (const auto& [name, bytes] : least)
            if (const base::BudgetLine* const line = device.budget.find(name); line->bytes < bytes) {
                started.shortage = base::BudgetShortage{line->name, line->bytes, line->bytes, bytes};
                return started;
            }
        started.used = device.budget;
        const std::uint64_t pixels = std::uint64_t{device.width_px} * device.height_px;
        started.used.find(effects::kRenderTargets)->use.in_use = device.capability.depth24_targets ? 3 * pixels : 100;
        return started;
    }
};

DevicePlan plan(std::uint64_t bytes, Starts starts = {}) {
    return plan_device(shipped(), ask_for(bytes), all_needs(), [&](const effects::DeviceSettings& d) { return starts(d); });
}

std::vector<std::string> given_up(const DevicePlan& plan) {
    std::vector<std::string> names;
    for (const GivenUp& one : plan.given_up) names.push_back(one.what);
    return names;
}

/// Metamorphic, over the whole range from the least memory to far more than any device has.
TEST(DevicePlanner, MoreMemoryNeverGivesFewerSlotsAndNoPlanIsLarger) {
    std::uint32_t slots = 0;
    std::size_t plans = 0;
    for (std::uint64_t bytes = 16 * kMiB; bytes < 3000 * kMiB; bytes += bytes / 16) {
        DevicePlan made;
        try {
            made = plan(bytes);
        } catch (const UserError&) {
            ASSERT_EQ(slots, 0u) << "less was enough";
            continue;
        }
        ++plans;
        EXPECT_LE(total_bytes(made.device), bytes);
        EXPECT_GE(made.device.max_chunk_slots, slots) << bytes;
        slots = made.device.max_chunk_slots;
    }
    EXPECT_EQ(slots, test_support::shipped_device("desktop").max_chunk_slots) << "of fewer pixels";
    EXPECT_GT(plans, 40u) << "control: the range is seen";
}

/// What is given up comes in one order; each later thing only where all earlier ones are gone.
TEST(DevicePlanner, GivesUpPagesThenPicturesThenSlots) {
    const std::vector<std::string> order = {"drape_pages", "attribute_pages", "off_screen_pictures", "max_chunk_slots"};
    std::size_t seen = 0;
    for (std::uint64_t bytes = 16 * kMiB; bytes < 80 * kMiB; bytes += kMiB / 2) {
        std::vector<std::string> names;
        try {
            names = given_up(plan(bytes));
        } catch (const UserError&) {
            continue;
        }
        ASSERT_LE(names.size(), order.size());
        EXPECT_EQ(names, std::vector<std::string>(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(names.size())));
        seen |= std::size_t{1} << names.size();
    }
    EXPECT_EQ(seen, 31u) << "nothing, one, two, three and all four";
}

TEST(DevicePlanner, WhatIsGivenUpSumsToTheDifference) {
    const DevicePlan small = plan(40 * kMiB), whole = plan(100 * kMiB);
    ASSERT_TRUE(whole.given_up.empty());
    ASSERT_EQ(small.shipped, whole.shipped);
    std::uint64_t sum = 0;
    for (const GivenUp& one : small.given_up) {
        sum += one.bytes;
        EXPECT_THAT(one.sentence, ::testing::HasSubstr(std::to_string(one.bytes)));
    }
    EXPECT_EQ(sum, total_bytes(whole.device) - total_bytes(small.device));
}

/// The memory that the refusal names is enough, and a mebibyte less is not.
TEST(DevicePlanner, RefusesWithTheMemoryThatIsEnough) {
    std::string message;
    try {
        static_cast<void>(plan(65536));
    } catch (const UserError& error) {
        message = error.what();
    }
    EXPECT_THAT(message, ::testing::HasSubstr(" bytes less than the least that a picture of 640x480 with the design full needs"));
    const std::size_t at = message.find("give --memory ");
    ASSERT_NE(at, std::string::npos) << message;
    const std::uint64_t enough = std::stoull(message.substr(at + 14));
    EXPECT_NO_THROW(static_cast<void>(plan(enough * kMiB)));
    EXPECT_THROW(static_cast<void>(plan((enough - 1) * kMiB)), UserError) << "control";
}

TEST(DevicePlanner, RaisesALineThatAStartRefusesAndStaysWithinTheMemory) {
    const std::uint64_t bytes = 50 * kMiB;
    const DevicePlan plain = plan(bytes), raised = plan(bytes, {{{"font_atlas", 8 * kMiB}}});
    EXPECT_EQ(raised.device.budget.find("font_atlas")->bytes, 8 * kMiB);
    EXPECT_LE(total_bytes(raised.device), bytes);
    EXPECT_LT(raised.device.max_chunk_slots, plain.device.max_chunk_slots);
}

TEST(DevicePlanner, AStartThatRefusesWhatItAskedForEndsThePlan) {
    const auto stubborn = [](const effects::DeviceSettings& device) {
        return StartedDevice{base::BudgetShortage{"staging", 0, device.budget.find("staging")->bytes, 0}, {}};
    };
    test_support::expect_user_error([&] { static_cast<void>(plan_device(shipped(), ask_for(kMiB * 64), all_needs(), stubborn)); },
                                    "the budget line 'staging' is refused");
}

TEST(DevicePlanner, ALargerPictureTakesMoreOffScreen) {
    Starts starts;
    const auto start = [&](const effects::DeviceSettings& d) { return starts(d); };
    DeviceAsk ask = ask_for(2000 * kMiB);
    const auto targets = [&] {
        return plan_device(shipped(), ask, all_needs(), start).device.budget.find(effects::kRenderTargets)->bytes;
    };
    const std::uint64_t small = targets();
    ask.size = {1280, 960};
    EXPECT_EQ(targets(), 4 * small);
}

}  // namespace
}  // namespace tedavis::host_sim::test_device_plan
