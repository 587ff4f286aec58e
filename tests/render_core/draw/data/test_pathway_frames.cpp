#include "render_core/draw/data/pathway_frames.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_pathway_frames {
namespace {

using test_support::ElementOfTest;
using test_support::scene_point;

constexpr double kFoot_m = 0.3048, kNauticalMile_m = 1852;
constexpr std::int64_t kSecond_ns = 1'000'000'000;

glm::dvec3 ecef(double latitude_deg, double longitude_deg, double height_m) {
    glm::dvec3 at;
    GeographicLib::Geocentric::WGS84().Forward(latitude_deg, longitude_deg, height_m, at.x, at.y, at.z);
    return at;
}

struct Place {
    double latitude_deg = 0, longitude_deg = 0, height_m = 0;
};
Place place_of(const glm::dvec3& at) {
    Place place;
    GeographicLib::Geocentric::WGS84().Reverse(at.x, at.y, at.z, place.latitude_deg, place.longitude_deg, place.height_m);
    return place;
}
glm::dvec3 vertical_at(const glm::dvec3& at) {
    const Place place = place_of(at);
    return ecef(place.latitude_deg, place.longitude_deg, place.height_m + 1) - at;
}

/// To the north, then to the north-east, descending 3000 m, a point every 200 m or so.
host_sim::LayerDraft planned(float last_height_m = 1000) {
    host_sim::LayerDraft layer;
    layer.name = "flight";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::trajectory;
    layer.height_datum = scene::HeightDatum::ellipsoid;
    for (int n = 0; n <= 100; ++n) {
        const double east = n > 60 ? 0.002 * (n - 60) : 0;
        layer.points.push_back(scene_point(46.5 + 0.002 * n, 9.6 + east, last_height_m + 30.0f * static_cast<float>(100 - n)));
    }
    layer.starts = {0, 101};
    return layer;
}

class PathwayOfTest {
public:
    explicit PathwayOfTest(const host_sim::LayerDraft& draft) : draft_(draft), test_(draft) {}

    [[nodiscard]] ElementInput input(double latitude_deg, double longitude_deg, bool is_valid = true) {
        ElementInput made = test_.input();
        made.own_ship = {{base::radians(latitude_deg), base::radians(longitude_deg), {0}}, is_valid};
        return made;
    }
    [[nodiscard]] PathwayFrames frames(double latitude_deg, double longitude_deg = 9.6) {
        const ElementInput made = input(latitude_deg, longitude_deg);
        return pathway_frames(made, planned_pathway(made));
    }
    /// How far a place is from the nearest leg, and where along the path that is.
    [[nodiscard]] std::pair<double, double> off_and_along_m(const glm::dvec3& place) const {
        double off_m = 1e9, along_m = 0, flown_m = 0;
        for (std::size_t n = 0; n + 1 < draft_.points.size(); ++n) {
            const glm::dvec3 a = corner(n), b = corner(n + 1), way = b - a;
            const double share = std::clamp(glm::dot(place - a, way) / glm::dot(way, way), 0.0, 1.0);
            if (const double away_m = glm::length(place - a - share * way); away_m < off_m) {
                off_m = away_m;
                along_m = flown_m + share * glm::length(way);
            }
            flown_m += glm::length(way);
        }
        return {off_m, along_m};
    }
    [[nodiscard]] double length_m() const {
        double length_m = 0;
        for (std::size_t n = 0; n + 1 < draft_.points.size(); ++n) length_m += glm::length(corner(n + 1) - corner(n));
        return length_m;
    }
    ElementOfTest& test() { return test_; }

private:
    [[nodiscard]] glm::dvec3 corner(std::size_t n) const {
        const scene::ScenePoint& point = draft_.points[n];
        return ecef(base::degrees(point.latitude_rad), base::degrees(point.longitude_rad), static_cast<double>(point.height_m));
    }
    host_sim::LayerDraft draft_;
    ElementOfTest test_;
};

TEST(PathwayFrames, P27StandOnThePathAndMeasure700By200Feet) {
    PathwayOfTest pathway(planned());
    std::size_t seen = 0;
    for (double latitude_deg = 46.5; latitude_deg < 46.7; latitude_deg += 0.011)
        for (const PathwayFrame& frame : pathway.frames(latitude_deg)) {
            EXPECT_LT(pathway.off_and_along_m(frame.middle).first, 1);
            EXPECT_NEAR(2 * frame.half_width_m, 700 * kFoot_m, 1);
            EXPECT_NEAR(2 * frame.half_height_m, 200 * kFoot_m, 1);
            ++seen;
        }
    EXPECT_GT(seen, 100u);
    for (const PathwayFrame& frame : pathway.frames(46.5))
        EXPECT_GT(pathway.off_and_along_m(frame.middle + 2.0 * frame.right).first, 1) << "control: two meters beside the path";
}

TEST(PathwayFrames, P27StandUprightAndAcrossThePath) {
    PathwayOfTest pathway(planned());
    const PathwayFrames frames = pathway.frames(46.56);
    ASSERT_EQ(frames.size(), 5u);
    for (const PathwayFrame& frame : frames) {
        EXPECT_NEAR(glm::dot(frame.up, vertical_at(frame.middle)), 1, 1e-6);
        EXPECT_NEAR(glm::dot(frame.right, frame.up), 0, 1e-9);
        EXPECT_NEAR(glm::length(frame.right), 1, 1e-9);
        const Place here = place_of(frame.middle), beside = place_of(frame.middle + 100.0 * frame.right);
        double distance_m = 0, azimuth_deg = 0, back_deg = 0;
        GeographicLib::Geodesic::WGS84().Inverse(here.latitude_deg, here.longitude_deg, beside.latitude_deg, beside.longitude_deg,
                                                 distance_m, azimuth_deg, back_deg);
        const bool has_turned = here.latitude_deg > 46.6201;
        EXPECT_NEAR(azimuth_deg, 90 + (has_turned ? base::degrees(std::atan(std::cos(base::radians(46.66)))) : 0), 0.3);
    }
}

TEST(PathwayFrames, P27StandEquallyFarApartFromTheEndOn) {
    PathwayOfTest pathway(planned());
    for (const double latitude_deg : {46.51, 46.55, 46.6}) {
        const PathwayFrames frames = pathway.frames(latitude_deg);
        ASSERT_GT(frames.size(), 4u);
        for (const PathwayFrame& frame : frames) {
            const double left_m = pathway.length_m() - pathway.off_and_along_m(frame.middle).second;
            const double spacing_m = (left_m > 3 * kNauticalMile_m - 1 ? 0.5 : 0.25) * kNauticalMile_m;
            EXPECT_NEAR(std::remainder(left_m, spacing_m), 0, 0.1) << left_m;
        }
        for (std::size_t n = 0; n + 1 < frames.size(); ++n) {
            const double left_m = pathway.length_m() - frames[n + 1].along_m;
            EXPECT_NEAR(frames[n + 1].along_m - frames[n].along_m,
                        (left_m > 3 * kNauticalMile_m - 1 ? 0.5 : 0.25) * kNauticalMile_m, 0.1);
        }
    }
}

/// Half a spacing farther, all frames that both show stand where they stood.
TEST(PathwayFrames, P27StandStillAndAheadWhileTheAircraftFlies) {
    PathwayOfTest pathway(planned());
    std::size_t kept = 0;
    for (double latitude_deg = 46.5; latitude_deg < 46.61; latitude_deg += 0.004) {
        const PathwayFrames before = pathway.frames(latitude_deg), after = pathway.frames(latitude_deg + 0.004);
        for (const PathwayFrame& frame : before) EXPECT_GT(place_of(frame.middle).latitude_deg, latitude_deg);
        for (const PathwayFrame& a : before)
            for (const PathwayFrame& b : after)
                if (glm::distance(a.middle, b.middle) < 200) {
                    EXPECT_LT(glm::distance(a.middle, b.middle), 1e-6);
                    ++kept;
                }
    }
    EXPECT_GT(kept, 100u);
}

TEST(PathwayFrames, FadeAtTheEyeAndFarAway) {
    PathwayOfTest pathway(planned());
    const ElementInput input = pathway.input(46.52, 9.6);
    const Pathway planned = planned_pathway(input);
    const PathwayFrames frames = pathway_frames(input, planned);
    ASSERT_EQ(frames.size(), kMaxPathwayFrames);
    EXPECT_EQ(frames[1].opacity, 1);
    EXPECT_LT(frames.back().opacity, 0.3);
    for (const PathwayFrame& frame : frames) EXPECT_GT(frame.along_m - planned.own_m, kGone_m);
    for (std::size_t n = 1; n + 1 < frames.size(); ++n) EXPECT_LE(frames[n + 1].opacity, frames[n].opacity);
    const double line_from_m = faded_from_m(input, planned);
    EXPECT_EQ(frames[frames.size() - 5].opacity, 1);
    EXPECT_GT(line_from_m, frames[frames.size() - 6].along_m);
    EXPECT_LT(line_from_m, frames.back().along_m);
    EXPECT_EQ(shown_ahead(100), 0);
    EXPECT_EQ(shown_ahead(175), 0.5);
    EXPECT_EQ(shown_ahead(1000), 1);
}

TEST(PathwayFrames, LittleDetailShowsTheNearestOnes) {
    PathwayOfTest pathway(planned());
    const PathwayFrames all = pathway.frames(46.52);
    pathway.test().element.detail = 0.5;
    const PathwayFrames few = pathway.frames(46.52);
    EXPECT_EQ(all.size(), few.size() + kMaxPathwayFrames / 2);
    EXPECT_EQ(few[0].along_m, all[0].along_m);
    pathway.test().element.detail = 0;
    EXPECT_EQ(pathway.frames(46.52).size(), kMinPathwayFrames);
}

/// The ground is 600 m high, and the path ends on it. Control: without a known ground all frames stand.
TEST(PathwayFrames, P27NoneStandsLowNearTheRunway) {
    PathwayOfTest pathway(planned(600));
    const auto lowest_m = [&] {
        double lowest_m = 1e9;
        for (double latitude_deg = 46.5; latitude_deg < 46.7; latitude_deg += 0.004)
            for (const PathwayFrame& frame :
                 pathway.frames(latitude_deg, latitude_deg > 46.62 ? 9.6 + latitude_deg - 46.62 : 9.6))
                lowest_m = std::min(lowest_m, place_of(frame.middle).height_m - 600);
        return lowest_m;
    };
    EXPECT_GT(lowest_m(), 200 * kFoot_m);
    EXPECT_LT(lowest_m(), 200 * kFoot_m + 100);
    pathway.test().ground.is_known = false;
    EXPECT_LT(lowest_m(), 1) << "control";
}

/// Ground under the middle of a long, level path: the frames' lower edges rest on it.
TEST(PathwayFrames, P27NoFrameReachesBelowTheGround) {
    host_sim::LayerDraft draft = planned();
    for (scene::ScenePoint& point : draft.points) point.height_m = 1000;
    PathwayOfTest pathway(draft);
    const ElementInput input = pathway.input(46.56, 9.6);
    PathwayFrame frame = pathway.frames(46.56)[0];
    for (const double ground_m : {600.0, 980.0, 995.0}) {
        pathway.test().ground.height = ground_m;
        for (const double low_m : lower_edge(input, frame))
            EXPECT_NEAR(low_m, std::max(-100 * kFoot_m, ground_m - place_of(frame.middle).height_m), 0.01);
    }
    pathway.test().ground.height = 2000;
    for (const double low_m : lower_edge(input, frame)) EXPECT_EQ(low_m, frame.half_height_m) << "and not above the frame";
    EXPECT_EQ(pathway.frames(46.56).size(), 0u) << "all are in the ground";
    pathway.test().ground.is_known = false;
    EXPECT_EQ(lower_edge(input, frame)[1], -frame.half_height_m);
}

TEST(PathwayFrames, AreThereOnlyWithAValidPlaceNearThePath) {
    PathwayOfTest pathway(planned());
    EXPECT_EQ(planned_pathway(pathway.input(46.56, 9.6)).feature, 0u) << "control";
    EXPECT_EQ(planned_pathway(pathway.input(46.56, 9.6, false)).feature, Pathway::kNone);
    EXPECT_EQ(planned_pathway(pathway.input(46.56, 9.5)).feature, Pathway::kNone) << "7 km beside it";
    EXPECT_EQ(pathway_frames(pathway.input(46.56, 9.5), {}).size(), 0u);
}

/// Out and back by the same way: the time says which of them is flown, and the own ship's place how far.
TEST(PathwayFrames, FollowThePathThatTheTimeTells) {
    host_sim::LayerDraft draft = planned();
    draft.points.clear();
    for (int n = 0; n <= 80; ++n) {
        draft.points.push_back(scene_point(46.5, 9.6 + 0.0025 * (n <= 40 ? n : 80 - n), 2000));
        draft.points.back().time_ns = n * 4 * kSecond_ns;
    }
    draft.starts = {0, 81};
    PathwayOfTest pathway(draft);
    pathway.test().has_date = true;
    for (const bool is_back : {false, true}) {
        pathway.test().time_ns = (is_back ? 60 : 20) * 4 * kSecond_ns;
        const PathwayFrames frames = pathway.frames(46.501, 9.6 + 0.0025 * 25);
        ASSERT_GT(frames.size(), 0u);
        const double east_deg = place_of(frames[0].middle).longitude_deg - (9.6 + 0.0025 * 25);
        EXPECT_EQ(east_deg < 0, is_back);
        EXPECT_LT(std::abs(east_deg), 0.013) << "the first one is less than a spacing ahead, though the plan is a kilometer off";
    }
}

TEST(PathwayFrames, AreAsWideAsTheDesignStates) {
    PathwayOfTest pathway(planned());
    pathway.test().element.size_m = 420;
    EXPECT_EQ(pathway.frames(46.56)[0].half_width_m, 210);
    EXPECT_NEAR(pathway.frames(46.56)[0].half_height_m, 60, 1e-9);
}

}  // namespace
}  // namespace tedavis::draw::test_pathway_frames
