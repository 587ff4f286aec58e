#include "host_sim/reports/track_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "render_core/base/units.hpp"
#include "tests/support/flights/frame_result.hpp"

namespace tedavis::host_sim::test_track_map {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Frames a second apart on a straight track to the north-east; from frame `cruise` on it is in cruise.
RunStory flown(int frames, int cruise, int lost = -1) {
    RunStory story(base::Time{0});
    for (int n = 0; n < frames; ++n) {
        FrameResult result = test_support::frame_result(static_cast<std::uint64_t>(n), n);
        result.record.own_ship.position.latitude_rad = base::radians(46.5 + 0.002 * n);
        result.record.own_ship.position.longitude_rad = base::radians(9.7 + 0.003 * n);
        if (n >= lost && lost >= 0 && n < lost + 8) result.record.own_ship.state = base::SignalState::lost;
        if (n >= cruise) result.record.phase.phase = {flight::Scenario::cruise, 0};
        static_cast<void>(story.add(result, 300, 60));
    }
    return story;
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(TrackMap, WithoutATrackThereIsNone) {
    EXPECT_EQ(track_map_svg(RunStory(base::Time{0}), nullptr), "");
    EXPECT_EQ(track_map_svg(flown(1, 9), nullptr), "");
}

/// A light line and a colored one for each stretch.
TEST(TrackMap, EachPhaseHasALineOfItsOwn) {
    EXPECT_EQ(count_of(track_map_svg(flown(20, 99), nullptr), "<polyline"), 2u);
    const std::string two = track_map_svg(flown(20, 10), nullptr);
    EXPECT_EQ(count_of(two, "<polyline"), 4u);
    EXPECT_THAT(two, HasSubstr("stroke='#d98c1f'"));
    EXPECT_THAT(two, HasSubstr("stroke='#5c97dd'"));
}

TEST(TrackMap, WherePositionsAreMissingTheLineIsBroken) {
    EXPECT_EQ(count_of(track_map_svg(flown(40, 99, 12), nullptr), "<polyline"), 4u);
}

/// Local distances in the drawing are those on the ground: a step is 222 m north and 229 m east.
TEST(TrackMap, ItIsTrueToScaleAndNorthIsUp) {
    const std::string svg = track_map_svg(flown(20, 99), nullptr);
    const std::regex points(
        "points='([0-9.]+),([0-9.]+) .* ([0-9.]+),([0-9.]+) '/>$|points='([0-9.]+),([0-9.]+) [^']* "
        "([0-9.]+),([0-9.]+) '");
    std::smatch match;
    ASSERT_TRUE(std::regex_search(svg, match, points));
    const auto number = [&](std::size_t n) { return std::stod(match[n].matched ? match[n].str() : match[n + 4].str()); };
    const double east = number(3) - number(1), north = number(2) - number(4);
    EXPECT_GT(east, 0);
    EXPECT_GT(north, 0);
    EXPECT_NEAR(east / north, 1.5 * std::cos(base::radians(46.519)), 0.01);
}

TEST(TrackMap, MarksStandWhereTheyAreAndAreExplained) {
    const std::string svg = track_map_svg(flown(20, 99), nullptr, {{46.52, 9.73, "1", "closest <here>"}});
    EXPECT_THAT(svg, HasSubstr("<title>closest &lt;here&gt;</title>"));
    EXPECT_THAT(svg, HasSubstr(">begin</text>"));
    EXPECT_THAT(svg, HasSubstr(">end</text>"));
    EXPECT_THAT(svg, Not(HasSubstr("<image"))) << "there is no terrain";
    EXPECT_THAT(svg, HasSubstr(" km</text>"));
}

MapTrack straight(const std::string& name, const std::string& color, double east_deg) {
    MapTrack track{name, color, 3, {}};
    for (int n = 0; n < 10; ++n) track.places.push_back({1.0 * n, 46.5 + 0.01 * n, 9.7 + east_deg});
    return track;
}

TEST(TracksMap, EachTrackHasItsColorAndTheNamesOfItsEnds) {
    const std::string apart = tracks_map_svg({straight("A", "#111111", 0), straight("B", "#222222", 0.05)}, nullptr);
    for (const char* part : {"stroke='#111111'", "stroke='#222222'", ">A begins<", ">B begins<", ">A ends<", ">B ends<"})
        EXPECT_THAT(apart, HasSubstr(part));
    const std::string together = tracks_map_svg({straight("A", "#111111", 0), straight("B", "#222222", 0)}, nullptr);
    EXPECT_THAT(together, HasSubstr(">A, B begin<"));
    EXPECT_THAT(together, Not(HasSubstr(">B begins<")));
}

/// Boxes of all labels, as wide as a wide font draws them: the rule is stated anew here.
TEST(TracksMap, LabelsDoNotOverlap) {
    std::vector<MapMark> marks;
    for (int n = 0; n < 12; ++n) marks.push_back({46.545 + 0.0004 * (n % 4), 9.7 + 0.0005 * (n / 4), "A: 312 ft", "place"});
    const std::string svg = tracks_map_svg({straight("A", "#111111", 0), straight("B", "#222222", 0.002)}, nullptr, marks);
    const std::regex text("<text x='([-0-9.]+)' y='([-0-9.]+)' text-anchor='([a-z]+)' class='map-text'>([^<]*)<");
    struct Box {
        double left, right, baseline;
    };
    std::vector<Box> boxes;
    for (std::sregex_iterator at(svg.begin(), svg.end(), text), end; at != end; ++at) {
        const double x = std::stod((*at)[1]), width = 6 * static_cast<double>((*at)[4].length());
        const double left = (*at)[3] == "start" ? x : (*at)[3] == "end" ? x - width : x - width / 2;
        boxes.push_back({left, left + width, std::stod((*at)[2])});
    }
    for (std::size_t n = 0; n < boxes.size(); ++n)
        for (std::size_t other = 0; other < n; ++other)
            EXPECT_FALSE(boxes[n].left < boxes[other].right && boxes[other].left < boxes[n].right &&
                         std::abs(boxes[n].baseline - boxes[other].baseline) < 11)
                << n << " and " << other;
    EXPECT_GT(boxes.size(), 6u) << "some of the marks have room";
    EXPECT_LT(boxes.size(), 4 + 4 + 12u) << "not all of them";
    EXPECT_EQ(count_of(svg, "<title>place</title>"), 12u) << "each has its title";
}

TEST(TracksMap, GapsBreakTheLineAndShortTracksAreLeftOut) {
    MapTrack track = straight("A", "#111111", 0);
    EXPECT_EQ(count_of(tracks_map_svg({track}, nullptr), "<polyline"), 2u);
    for (std::size_t n = 5; n < 10; ++n) track.places[n].time_s += 60;
    EXPECT_EQ(count_of(tracks_map_svg({track}, nullptr), "<polyline"), 4u);
    track.places.resize(1);
    EXPECT_EQ(tracks_map_svg({track}, nullptr), "");
}

TEST(TrackMap, OtherTracksLieBesideThatOfTheRun) {
    const std::string alone = track_map_svg(flown(20, 99), nullptr);
    MapTrack ghost = straight("ghost B", "#222222", 0.03);
    ghost.places.resize(4);  // within the map
    const std::string beside = track_map_svg(flown(20, 99), nullptr, {}, {ghost});
    EXPECT_EQ(count_of(beside, "<polyline"), count_of(alone, "<polyline") + 2);
    for (const char* part : {"stroke='#222222'", ">ghost B begins<", ">ghost B ends<", ">begin<", ">end<"})
        EXPECT_THAT(beside, HasSubstr(part));
    EXPECT_LT(beside.find("stroke='#222222'"), beside.find("stroke='#d98c1f'")) << "below that of the run";
    const std::regex x(" ([0-9.]+),[0-9.]+ '/>");
    for (std::sregex_iterator at(beside.begin(), beside.end(), x), end; at != end; ++at)
        EXPECT_LE(std::stod((*at)[1].str()), 640) << "the width of the map";
    MapTrack one = straight("B", "#222222", 0.03);
    one.places.resize(1);
    EXPECT_EQ(track_map_svg(flown(20, 99), nullptr, {}, {one}), alone);
}

/// The corner that its text states, in degrees.
double north_of(const std::string& svg) {
    const std::regex north("north up, from ([0-9.]+)");
    std::smatch match;
    return std::regex_search(svg, match, north) ? std::stod(match[1].str()) : 0;
}

/// The run goes from 46.5 to 46.538 degrees north.
TEST(TrackMap, AFarGhostDoesNotShrinkTheMapAndEndsAtItsBorder) {
    const RunStory story = flown(20, 99);
    MapTrack far = straight("ghost B", "#222222", 0.02);
    for (MapTrack::Place& place : far.places) place.latitude_deg = 46.52 + 0.3 * place.time_s;
    const std::string svg = track_map_svg(story, nullptr, {}, {far});
    EXPECT_LT(north_of(svg), 46.57);
    EXPECT_GT(north_of(svg), 46.54);
    EXPECT_THAT(svg, HasSubstr("stroke='#222222'"));
    EXPECT_THAT(svg, HasSubstr(">ghost B begins<"));
    EXPECT_THAT(svg, Not(HasSubstr(">ghost B ends<"))) << "beyond the map";
    EXPECT_THAT(svg, Not(HasSubstr(",-"))) << "no point lies above it";
    const MapTrackView view = view_of_track(story, {far}, 0);
    EXPECT_TRUE(view.is_shown && view.is_cut && !view.has_gaps);
    for (MapTrack::Place& place : far.places) place.latitude_deg += 1;
    EXPECT_FALSE(view_of_track(story, {far}, 0).is_shown);
    EXPECT_THAT(track_map_svg(story, nullptr, {}, {far}), Not(HasSubstr("stroke='#222222'")));
    const MapTrackView near = view_of_track(story, {straight("C", "#222222", 0.02)}, 0);
    EXPECT_TRUE(near.is_shown);
}

TEST(TrackMap, StatedGapsBreakTheLineOfAGhost) {
    const RunStory story = flown(20, 99);
    MapTrack ghost = straight("B", "#222222", 0.02);
    for (MapTrack::Place& place : ghost.places) place.latitude_deg = 46.5 + 0.002 * place.time_s;
    ghost.states_gaps = true;
    for (std::size_t n = 5; n < 10; ++n) ghost.places[n].time_s += 60;
    const auto lines = [&] { return count_of(track_map_svg(story, nullptr, {}, {ghost}), "stroke='#222222'"); };
    EXPECT_EQ(lines(), 1u) << "it flew on, as its log says";
    EXPECT_FALSE(view_of_track(story, {ghost}, 0).has_gaps);
    ghost.places[2].joins_next = ghost.places[7].joins_next = false;
    EXPECT_EQ(lines(), 3u);
    EXPECT_TRUE(view_of_track(story, {ghost}, 0).has_gaps);
    EXPECT_FALSE(view_of_track(story, {ghost}, 0).is_cut);
}

}  // namespace
}  // namespace tedavis::host_sim::test_track_map
