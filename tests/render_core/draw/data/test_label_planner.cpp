#include "render_core/draw/data/label_planner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <vector>

#include "render_core/flight/decision_interval.hpp"
#include "tests/render_core/draw/data/planned_labels.hpp"
#include "tests/support/files/hard_case.hpp"

namespace tedavis::draw::test_label_planner {
namespace {

using test_support::box_of;
constexpr Rect kScreen = test_support::kLabelScreen;
constexpr float kText_px = test_support::kLabelText_px;
using Feature = test_support::LabelFeature;
using Plan = test_support::PlannedLabels;

/// Places of features in rows of `across`.
float column(std::uint32_t n, std::uint32_t across) { return static_cast<float>(n % across); }
float row(std::uint32_t n, std::uint32_t across) {
    const std::uint32_t whole = n / across;
    return static_cast<float>(whole);
}

bool are_equal(const LabelPlanner& a, const LabelPlanner& b) {
    const auto first = a.labels(), second = b.labels();
    if (first.size() != second.size()) return false;
    for (std::size_t n = 0; n < first.size(); ++n) {
        const Label &x = first[n], &y = second[n];
        if (x.key != y.key || x.level != y.level || x.wanted != y.wanted || x.side != y.side || x.stem != y.stem ||
            x.age != y.age || x.is_seen != y.is_seen)
            return false;
    }
    return true;
}

TEST(LabelPlanner, FocusHasNamesTheRoundMarkersTheRestNothing) {
    Plan plan;
    plan.decide({{1, 0.9, {100, 300}}, {2, 0.3, {400, 300}}, {3, 0.1, {700, 300}}, {4, 0.9, {850, 300}, 0}});
    EXPECT_EQ(plan.of(1).level, LabelLevel::name);
    EXPECT_EQ(plan.of(2).level, LabelLevel::marker);
    EXPECT_EQ(plan.of(3).level, LabelLevel::none);
    EXPECT_EQ(plan.of(4).level, LabelLevel::marker) << "it has no name";
    EXPECT_EQ(plan.planner.suppressed(0), 2u);
    EXPECT_EQ(plan.planner.labels()[0].key, 1u);
    EXPECT_EQ(plan.planner.labels()[3].key, 3u) << "by interest";
}

TEST(LabelPlanner, WhatWarnsHasItsMarkerAndComesFirst) {
    LabelGroup warns;
    warns.is_protected = true;
    Plan plan({LabelGroup{}, warns});
    std::vector<Feature> features{{label_key(0, 1), 1.0, {500, 300}}, {label_key(1, 1), 0.0, {500, 302}}};
    plan.decide(features);
    EXPECT_EQ(plan.planner.labels()[0].key, label_key(1, 1));
    EXPECT_EQ(plan.of(label_key(1, 1)).level, LabelLevel::marker);
    // It comes later, and everything else has spent its changes: at once it is there.
    for (std::uint32_t n = 2; n < 300; ++n) features.push_back({label_key(0, n), 0.9, {column(n, 30) * 33, row(n, 30) * 70}});
    plan.decide(features);
    features.push_back({label_key(1, 2), 0.0, {300, 500}});
    plan.decide(features);
    EXPECT_EQ(plan.of(label_key(1, 2)).level, LabelLevel::marker);
}

/// Boxes of all labels that stand; none may overlap another one.
std::vector<Rect> standing(const Plan& plan, const std::vector<Feature>& features) {
    std::vector<Rect> boxes;
    for (const Label& label : plan.planner.labels()) {
        if (!label.is_seen || label.level == LabelLevel::none) continue;
        const SignBox box = box_of(features[label.key]);
        boxes.push_back(label.level == LabelLevel::name ? box.raised(label.stem, kText_px).with(label.side)
                                                        : box.with(SignSide::none));
    }
    for (std::size_t n = 0; n < boxes.size(); ++n) {
        EXPECT_TRUE(kScreen.contains(boxes[n]));
        for (std::size_t k = 0; k < n; ++k) EXPECT_FALSE(boxes[n].overlaps(boxes[k])) << n << " " << k;
    }
    return boxes;
}

TEST(LabelPlanner, NothingOverlaps) {
    Plan plan;
    std::vector<Feature> features;
    for (std::uint32_t n = 0; n < 400; ++n)
        features.push_back({n, 0.4 + 0.001 * n, {float(n * 37 % 1000), 100 + float(n * 101 % 500)}, float(30 + n % 90)});
    plan.decide(features);
    EXPECT_GT(standing(plan, features).size(), 20u);
    EXPECT_EQ(plan.planner.labels().size(), LabelPlanner::kMax);
    EXPECT_GE(plan.planner.suppressed(0), 400 - LabelPlanner::kMax) << "whom the list does not hold is counted";
}

/// A direction from one anchor to an equal one would be no number.
TEST(LabelPlanner, AHundredAtOnePlaceDoNotOverlap) {
    Plan plan;
    std::vector<Feature> features;
    for (std::uint32_t n = 0; n < 100; ++n) features.push_back({n, 0.9, {500, 300}, 60});
    for (int interval = 0; interval < 10; ++interval) {
        plan.decide(features);
        EXPECT_GE(standing(plan, features).size(), 1u);
    }
}

TEST(LabelPlanner, TheOrderOfTheOffersDoesNotMatter) {
    Plan forth, back;
    std::vector<Feature> features;
    for (std::uint32_t n = 0; n < 2000; ++n)
        features.push_back({n, 0.2 + 0.0001 * (n * 7919 % 5000), {float(n * 37 % 1000), float(n * 101 % 700)}});
    std::vector<Feature> turned(features.rbegin(), features.rend());
    for (int interval = 0; interval < 20; ++interval) {
        for (Feature& feature : features) feature.at.x += 3;
        for (Feature& feature : turned) feature.at.x += 3;
        std::rotate(turned.begin(), turned.begin() + 37 * interval, turned.end());
        forth.decide(features);
        back.decide(turned);
        ASSERT_TRUE(are_equal(forth.planner, back.planner)) << interval;
    }
}

TEST(LabelPlanner, DetailIsTheShareThatMayHaveNames) {
    LabelGroup quarter, places;
    quarter.named_share = places.named_share = 0.25;
    places.only_named = true;
    places.most = 2;
    Plan plan({quarter, places});
    std::vector<Feature> features;
    for (std::uint32_t n = 0; n < 16; ++n)
        for (const std::uint32_t group : {0u, 1u})
            features.push_back(
                {label_key(group, n), 0.9 - 0.01 * n, {60 + 120 * column(n, 8), 100 + 200 * row(n, 8) + 60 * float(group)}, 40});
    plan.decide(features);
    std::array<std::size_t, 2> named{}, marked{};
    for (const Label& label : plan.planner.labels()) {
        named[group_of(label.key)] += label.level == LabelLevel::name ? 1 : 0;
        marked[group_of(label.key)] += label.level == LabelLevel::marker ? 1 : 0;
    }
    EXPECT_EQ(named[0], 4u);
    EXPECT_EQ(marked[0], 12u);
    EXPECT_EQ(named[1], 2u) << "no more of places than that";
    EXPECT_EQ(marked[1], 0u);
}

TEST(LabelPlanner, WhatStandsStaysWhereItIs) {
    Plan plan;
    Feature one{1, 0.5, {500, 300}}, two{2, 0.6, {900, 300}};
    plan.decide({one, two});
    EXPECT_EQ(plan.of(1).side, SignSide::right);
    // From the right something of more interest takes that side; when it has gone, the name stays on its new side.
    two.at.x = 560;
    for (int n = 0; n < 3; ++n) plan.decide({one, two});
    const Label moved = plan.of(1);
    EXPECT_EQ(moved.level, LabelLevel::name);
    EXPECT_NE(moved.side, SignSide::right);
    two.at.x = 900;
    for (int n = 0; n < 30; ++n) plan.decide({one, two});
    EXPECT_EQ(plan.of(1).side, moved.side);
    Plan fresh;
    fresh.decide({one, two});
    EXPECT_EQ(fresh.of(1).side, SignSide::right) << "a control: without a memory";
    // A little below the limit it keeps its name, well below it does not.
    one.interest = plan.settings.name_above - 0.5 * LabelPlanner::kHeldBonus;
    for (int n = 0; n < 30; ++n) plan.decide({one, two});
    EXPECT_EQ(plan.of(1).level, LabelLevel::name);
    one.interest = plan.settings.name_above - 1.5 * LabelPlanner::kHeldBonus;
    for (int n = 0; n < 30; ++n) plan.decide({one, two});
    EXPECT_EQ(plan.of(1).level, LabelLevel::marker);
}

TEST(LabelPlanner, AChangeDwells) {
    Plan plan;
    plan.settings.dwell_s = 3;
    plan.settings.most_changes = 100;
    Feature one{1, 0.5, {500, 300}};
    plan.decide({one});
    std::vector<int> changed;
    LabelLevel before = LabelLevel::name;
    for (int n = 0; n < 60; ++n) {
        one.interest = n % 2 == 0 ? 0.05 : 0.95;
        plan.decide({one});
        if (plan.of(1).level != before) changed.push_back(n);
        before = plan.of(1).level;
    }
    ASSERT_GT(changed.size(), 2u);
    for (std::size_t n = 1; n < changed.size(); ++n) EXPECT_GE(changed[n] - changed[n - 1], 6) << "intervals of half a second";
}

TEST(LabelPlanner, ALeapForgetsAndSmallGapsDoNot) {
    Plan plan;
    std::vector<Feature> many;
    for (std::uint32_t n = 0; n < 20; ++n) many.push_back({n, 0.6, {100 + 200 * column(n, 5), 100 + 120 * row(n, 5)}, 60});
    plan.decide({many[0]}, 10);
    plan.decide(many, 12);
    const auto named = [&] {
        return std::count_if(plan.planner.labels().begin(), plan.planner.labels().end(),
                             [](const Label& label) { return label.level == LabelLevel::name; });
    };
    EXPECT_LE(named(), 3) << "the others wait their turn";
    EXPECT_FALSE(plan.planner.is_due(12));
    EXPECT_TRUE(plan.planner.is_due(13));
    plan.decide(many, 100);
    EXPECT_EQ(named(), 20);
    plan.decide({many[0]}, 101);
    plan.decide(many, 50);
    EXPECT_EQ(named(), 20) << "backwards";
    plan.planner.skip(51);
    EXPECT_TRUE(plan.planner.labels().empty());
    EXPECT_FALSE(plan.planner.is_due(51));
    plan.decide(many, 52);
    EXPECT_EQ(named(), 20) << "after an interval without labels";
    EXPECT_EQ(flight::decision_interval_of({-1}), -1);
    EXPECT_EQ(flight::decision_interval_of({499'999'999}), 0);
    EXPECT_EQ(flight::decision_interval_of({500'000'000}), 1);
}

TEST(LabelPlanner, LooksAreComparedWithTheFrameBefore) {
    Plan plan;
    Feature one{1, 0.9, {200, 300}}, two{2, 0.8, {600, 300}};
    plan.decide({one, two});
    EXPECT_TRUE(plan.planner.note(0, 3));
    EXPECT_FALSE(plan.planner.note(0, 3));
    EXPECT_TRUE(plan.planner.note(1, 1));
    two.interest = 0.95;
    plan.decide({one, two});
    EXPECT_EQ(plan.planner.labels()[0].key, 2u) << "the order has changed";
    EXPECT_FALSE(plan.planner.note(0, 1));
    EXPECT_FALSE(plan.planner.note(1, 3));
    EXPECT_EQ(plan.planner.take_gone(), 0u);
    plan.decide({two});
    EXPECT_EQ(plan.planner.take_gone(), 1u);
    EXPECT_EQ(plan.planner.take_gone(), 0u);
}

/// A country of places, flown over straight on, ten frames a second: what stands in each frame, and how often that changes.
class Flight {
public:
    static constexpr int kFramesAnInterval = 5;
    Flight(std::size_t places, double side_m) {
        std::uint32_t state = 12345;
        const auto next = [&] {
            state = state * 1664525u + 1013904223u;
            return static_cast<double>(state >> 8) / (1u << 24);
        };
        for (std::size_t n = 0; n < places; ++n)
            places_.push_back({side_m * (next() - 0.5), side_m * next(), next(), float(30 + 90 * next())});
    }

    struct Result {
        std::size_t overlaps = 0, changes = 0, worst_second = 0, named = 0, frames = 0;
        [[nodiscard]] double a_second() const { return 10.0 * double(changes) / double(frames); }
    };
    /// `remembers`: else every interval is the first one.
    Result fly(double seconds, double speed_mps, bool remembers, Plan& plan, double from_s = 0) const {
        Result result;
        std::map<LabelKey, int> before;
        std::vector<std::size_t> changes;
        for (int frame = 0; frame < 10 * seconds; ++frame) {
            const double time_s = from_s + 0.1 * frame;
            const std::vector<Feature> features = seen(speed_mps * time_s, time_s);
            const auto interval = static_cast<std::int64_t>(std::floor(2 * time_s + 1e-9));
            if (plan.planner.is_due(interval)) {
                if (!remembers) plan.planner.forget();
                plan.decide(features, interval);
            }
            std::map<LabelKey, int> now;
            result.overlaps += stand(plan, features, now);
            if (frame > 0) changes.push_back(differences(before, now));
            result.named += now.size();
            before = now;
        }
        for (std::size_t n = 0; n < changes.size(); ++n) {
            result.changes += changes[n];
            std::size_t second = 0;
            for (std::size_t k = n; k < std::min(n + 10, changes.size()); ++k) second += changes[k];
            result.worst_second = std::max(result.worst_second, second);
        }
        result.frames = changes.size();
        result.named /= std::max<std::size_t>(result.frames, 1);
        return result;
    }

private:
    struct Place {
        double right_m, ahead_m, prominence;
        float name_px;
    };
    /// As an eye 1200 m over a plain sees it, a little unsteady.
    [[nodiscard]] std::vector<Feature> seen(double flown_m, double time_s) const {
        std::vector<Feature> features;
        const float shake = 2 * static_cast<float>(std::sin(1.7 * time_s));
        for (std::size_t n = 0; n < places_.size(); ++n) {
            const Place& place = places_[n];
            const double ahead_m = place.ahead_m - flown_m;
            if (ahead_m < 500 || ahead_m > 60'000 || std::abs(place.right_m) > ahead_m) continue;
            const double px = 870 / ahead_m;
            const double near = 1 - std::log1p(ahead_m / 1000) / std::log1p(60.0);
            features.push_back({static_cast<LabelKey>(n),
                                0.5 * near + 0.5 * place.prominence,
                                {static_cast<float>(500 + px * place.right_m), static_cast<float>(250 + px * 1200) + shake},
                                place.name_px});
        }
        return features;
    }
    /// Labels that stand in a frame, by their looks; overlapping ones give way, in order. Returns what overlaps nevertheless.
    static std::size_t stand(const Plan& plan, const std::vector<Feature>& features, std::map<LabelKey, int>& now) {
        std::map<LabelKey, const Feature*> by_key;
        for (const Feature& feature : features) by_key[feature.key] = &feature;
        std::vector<Rect> boxes;
        for (const Label& label : plan.planner.labels()) {
            if (label.level == LabelLevel::none || by_key.count(label.key) == 0) continue;
            const SignBox box = box_of(*by_key.at(label.key));
            const bool is_named = label.level == LabelLevel::name;
            for (const bool with_name : {true, false}) {
                if (with_name && !is_named) continue;
                const Rect room = with_name ? box.raised(label.stem, kText_px).with(label.side) : box.with(SignSide::none);
                const bool is_free = std::none_of(boxes.begin(), boxes.end(), [&](const Rect& b) { return b.overlaps(room); });
                if (!is_free || !kScreen.contains(room)) continue;
                boxes.push_back(room);
                now[label.key] = with_name ? 1 + 4 * label.stem + static_cast<int>(label.side) : 100;
                break;
            }
        }
        std::size_t overlaps = 0;
        for (std::size_t n = 0; n < boxes.size(); ++n)
            for (std::size_t k = 0; k < n; ++k) overlaps += boxes[n].overlaps(boxes[k]) ? 1 : 0;
        return overlaps;
    }
    static std::size_t differences(const std::map<LabelKey, int>& before, const std::map<LabelKey, int>& now) {
        std::size_t changes = 0;
        for (const auto& [key, look] : now) changes += before.count(key) == 0 || before.at(key) != look ? 1 : 0;
        for (const auto& [key, look] : before) changes += now.count(key) == 0 ? 1 : 0;
        return changes;
    }

    std::vector<Place> places_;
};

design::LabelSettings choosy() {
    design::LabelSettings settings;
    settings.name_above = 0.4;
    settings.marker_above = 0.35;
    return settings;
}

TEST(LabelPlanner, SteadyFlightIsCalm) {
    const Flight flight(2000, 120'000);
    Plan calm, nervous;
    calm.settings = nervous.settings = choosy();
    const Flight::Result with = flight.fly(180, 70, true, calm), without = flight.fly(60, 70, false, nervous);
    EXPECT_EQ(with.overlaps, 0u);
    EXPECT_GT(with.named, 15u) << "there is something to see";
    EXPECT_LE(with.a_second(), 2) << "worst " << with.worst_second;
    EXPECT_GT(without.a_second(), 2 * with.a_second()) << "a control: without a memory";
    EXPECT_GT(without.a_second(), 2);
    test_support::record_worst("A38", with.a_second());
    test_support::record_control("A38", without.a_second());
}

/// Whoever brings the memory along has the same labels as the whole flight; who does not has others.
TEST(LabelPlanner, AMemoryBroughtAlongGoesOnTheSame) {
    const Flight flight(2000, 120'000);
    Plan whole, part, other;
    whole.settings = part.settings = other.settings = choosy();
    static_cast<void>(flight.fly(30, 70, true, whole));
    LabelMemory memory;
    whole.planner.keep(memory);
    static_cast<void>(flight.fly(20, 70, true, whole, 30));
    part.planner.restore(memory);
    static_cast<void>(flight.fly(20, 70, true, part, 30));
    EXPECT_TRUE(are_equal(whole.planner, part.planner));
    static_cast<void>(flight.fly(20, 70, true, other, 30));
    EXPECT_FALSE(are_equal(whole.planner, other.planner)) << "a control";
}

}  // namespace
}  // namespace tedavis::draw::test_label_planner
