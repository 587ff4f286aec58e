// Every place of a shown way, moved back by itself, lies on one of the parts, and the parts hold nothing else.
#include "render_core/earth/magnified_segment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "render_core/base/units.hpp"

namespace tedavis::earth::test_magnified_segment {
namespace {

using base::radians;

Magnifiers two() {
    Magnifiers all;
    for (const double north_deg : {46.8, 46.99}) {
        Magnifier magnifier;
        EXPECT_TRUE(Magnifier::make({radians(north_deg), radians(9.8), north_deg > 46.9, 2000, 9000, 1}, magnifier));
        EXPECT_TRUE(all.add(magnifier));
    }
    return all;
}

std::vector<TrueSegment> parts_of(const Magnifiers& all, const TrueSegment& shown) {
    std::vector<TrueSegment> parts;
    EXPECT_FALSE(any_true_segment(all, shown, [&](const TrueSegment& part) {
        parts.push_back(part);
        return false;
    }));
    return parts;
}

double distance_m(const Ecef& place, const TrueSegment& way) {
    const glm::dvec3 along = way.end - way.begin;
    const double share = std::fmin(std::fmax(glm::dot(place - way.begin, along) / glm::dot(along, along), 0.0), 1.0);
    return glm::distance(place, way.begin + along * share);
}

/// Through both, from far above or from one valley to another.
TrueSegment some_segment(std::mt19937_64& random, const Magnifiers& all) {
    std::uniform_real_distribution<double> aside(-9000, 9000), along(-15'000, 40'000), height(0, 4000);
    const Magnifier& first = *all.begin();
    const auto place = [&](double up_m) {
        return first.middle() + first.east() * aside(random) + first.north() * along(random) + first.up() * up_m;
    };
    const Ecef end = place(height(random));
    if (random() % 2 == 0) return {place(height(random)), end};
    return {end + first.up() * 2e6 - first.north() * 1.5e6 + first.east() * aside(random), end};
}

TEST(MagnifiedSegment, PartsHoldEveryPlaceMovedBack) {
    const Magnifiers all = two();
    std::mt19937_64 random(3);
    std::size_t most = 0;
    for (int k = 0; k < 400; ++k) {
        const TrueSegment shown = some_segment(random, all);
        const std::vector<TrueSegment> parts = parts_of(all, shown);
        most = std::max(most, parts.size());
        for (int n = 0; n <= 200; ++n) {
            const Ecef place = all.moved_back(shown.begin + (shown.end - shown.begin) * (n / 200.0));
            double nearest = 1e9;
            for (const TrueSegment& part : parts) nearest = std::fmin(nearest, distance_m(place, part));
            ASSERT_LT(nearest, 1e-3) << k << ' ' << n;
        }
    }
    EXPECT_GT(most, 8u);
}

TEST(MagnifiedSegment, PartsEndWhereOthersBegin) {
    const Magnifiers all = two();
    std::mt19937_64 random(4);
    for (int k = 0; k < 400; ++k) {
        const TrueSegment shown = some_segment(random, all);
        std::vector<TrueSegment> parts = parts_of(all, shown);
        Ecef at = all.moved_back(shown.begin);
        const Ecef last = all.moved_back(shown.end);
        while (!parts.empty()) {
            std::size_t next = 0;
            for (std::size_t n = 0; n < parts.size(); ++n)
                if (glm::distance(parts[n].begin, at) < glm::distance(parts[next].begin, at)) next = n;
            ASSERT_LT(glm::distance(parts[next].begin, at), 1e-3);
            at = parts[next].end;
            parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(next));
        }
        ASSERT_LT(glm::distance(at, last), 1e-3);
    }
}

TEST(MagnifiedSegment, AWayBesideThemIsOnePart) {
    const Magnifiers all = two();
    const Magnifier& first = *all.begin();
    const TrueSegment shown{first.middle() - first.north() * 9000.0 - first.east() * 20'000.0,
                            first.middle() - first.north() * 9000.0 + first.east() * 20'000.0};
    const std::vector<TrueSegment> parts = parts_of(all, shown);
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].begin, shown.begin);
    EXPECT_EQ(parts[0].end, shown.end);
}

TEST(MagnifiedSegment, AnAnswerEndsTheSearch) {
    const Magnifiers all = two();
    const Magnifier& first = *all.begin();
    int asked = 0;
    EXPECT_TRUE(any_true_segment(all, {first.middle(), first.middle() + first.north() * 9000.0}, [&](const TrueSegment&) {
        ++asked;
        return true;
    }));
    EXPECT_EQ(asked, 1);
}

}  // namespace
}  // namespace tedavis::earth::test_magnified_segment
