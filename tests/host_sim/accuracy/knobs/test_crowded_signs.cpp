#include "host_sim/accuracy/knobs/crowded_signs.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace tedavis::host_sim::test_crowded_signs {
namespace {

draw::SignBox box_at(double x, double y, double name_px) {
    draw::SignBox box;
    box.middle = {static_cast<float>(x), static_cast<float>(y)};
    box.half_px = 8;
    box.gap_px = 4;
    box.foot_px = 20;
    box.name_width_px = static_cast<float>(name_px);
    box.name_height_px = 15;
    return box;
}

using Rooms = std::vector<std::optional<draw::Rect>>;

Rooms rooms_of(const draw::SignBox& box) {
    Rooms rooms = {std::nullopt};
    for (std::uint8_t stem = 0; stem < draw::kSignStems; ++stem)
        for (const draw::SignSide side : draw::kNameSides) {
            const draw::Rect room = box.raised(stem, CrowdedSigns::kInterval.text_px).with(side);
            if (CrowdedSigns::kInterval.screen.contains(room)) rooms.emplace_back(room);
        }
    return rooms;
}

bool fit(const std::optional<draw::Rect>& a, const std::optional<draw::Rect>& b) {
    return !a || !b || !draw::LabelPlanner::with_margin(*a, CrowdedSigns::kInterval.text_px).overlaps(*b);
}

/// Of three signs, by all combinations of all places.
std::uint32_t most_of_three(const std::vector<draw::SignBox>& boxes) {
    const Rooms first = rooms_of(boxes[0]), second = rooms_of(boxes[1]), third = rooms_of(boxes[2]);
    std::uint32_t most = 0;
    for (const auto& a : first)
        for (const auto& b : second)
            for (const auto& c : third)
                if (fit(a, b) && fit(a, c) && fit(b, c))
                    most = std::max(most, static_cast<std::uint32_t>(a.has_value()) + static_cast<std::uint32_t>(b.has_value()) +
                                              static_cast<std::uint32_t>(c.has_value()));
    return most;
}

TEST(CrowdedSigns, FindsAsManyNamesAsAllCombinationsHave) {
    SeededRandom numbers(5);
    std::uint32_t fewest = 3, most = 0;
    for (int n = 0; n < 60; ++n) {
        std::vector<draw::SignBox> boxes;
        for (int k = 0; k < 3; ++k)
            boxes.push_back(box_at(numbers.between(20, 200), numbers.between(15, 60), numbers.between(100, 190)));
        const std::uint32_t found = CrowdedSigns(boxes).most_names();
        EXPECT_EQ(found, most_of_three(boxes)) << n;
        fewest = std::min(fewest, found);
        most = std::max(most, found);
    }
    EXPECT_LT(fewest, most) << "control: crowds of more than one kind";
}

TEST(CrowdedSigns, WhatHasNoRoomOnTheScreenHasNoName) {
    EXPECT_EQ(CrowdedSigns({box_at(110, 60, 400)}).most_names(), 0u);
    EXPECT_EQ(CrowdedSigns({box_at(110, 60, 40)}).most_names(), 1u) << "control";
}

}  // namespace
}  // namespace tedavis::host_sim::test_crowded_signs
