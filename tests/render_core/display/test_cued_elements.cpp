#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/support/display/shown_elements.hpp"

namespace tedavis::display::test_cued_elements {
namespace {

using design::DataTechnique;

/// A flight from west to east, a kilometre and a half over the ground, that stands in the scene.
host_sim::SceneDraft flight_draft() {
    host_sim::SceneDraft draft = test_support::scene_draft();
    host_sim::LayerDraft flight;
    flight.name = "flight";
    flight.shape = scene::LayerShape::lines;
    flight.role = scene::LayerRole::trajectory;
    for (int n = 0; n <= 20; ++n) flight.points.push_back(test_support::scene_point(46.78, 9.78 + 0.004 * n, 2100));
    flight.starts = {0, 21};
    draft.layers.push_back(flight);
    return draft;
}

class CuedElements : public test_support::ShownElements {
protected:
    CuedElements() : test_support::ShownElements(flight_draft()) {}

    std::size_t pixels_with(const design::ElementCues& cues) {
        asked_.clear();
        ask_for("flight", DataTechnique::tube).cues = cues;
        plan();
        return drawn_pixels();
    }
};

TEST_F(CuedElements, OnlyWhatIsAskedForIsBuilt) {
    const std::size_t bare = pixels_with({});
    for (const draw::CueCount& count : elements_.reports()[0].cues) EXPECT_EQ(count.drawn, 0u);
    EXPECT_GT(pixels_with({0, false, design::LineMotion::still, 0, 0, 0.5}), bare + 50);
    const auto& counts = elements_.reports()[0].cues;
    EXPECT_GT(counts[static_cast<std::size_t>(draw::Cue::curtain)].drawn, 0u);
    EXPECT_EQ(counts[0].drawn + counts[1].drawn, 0u);
}

TEST_F(CuedElements, LinesTravelWhileTheirWayStands) {
    design::ElementCues cues{1000, true};
    const auto pictures = [&] {
        std::vector<std::uint8_t> all[3];
        static_cast<void>(pixels_with(cues));
        for (std::size_t n = 0; n < 3; ++n) {
            const base::Time now{test_support::kNow.ns + static_cast<std::int64_t>(n) * 5'000'000'000};
            elements_.plan({ground_, frame_.view, {255, 0, 255}, flight::time_of_source(now)});
            static_cast<void>(drawn_pixels());
            all[n] = session_.pixels();
        }
        return std::pair(all[0] == all[1], all[0] == all[2]);
    };
    EXPECT_EQ(pictures(), std::pair(true, true)) << "control: they stand";
    cues.lines_move = design::LineMotion::along;
    cues.line_speed_mps = 100;
    EXPECT_EQ(pictures(), std::pair(false, true)) << "a spacing in ten seconds";
}

/// Frames are built in every frame, and what stands is left as it is.
TEST_F(CuedElements, APathwayHasFramesAheadOfTheOwnShip) {
    ask_for("flight", DataTechnique::pathway);
    elements_.set(&scene_.scene(), asked_);
    flight::AircraftState aircraft;
    const auto pieces_at = [&](double longitude_deg, base::SignalState state) {
        aircraft.own_ship.position = {base::radians(46.78), base::radians(longitude_deg), {2100}};
        aircraft.own_ship.state = state;
        elements_.plan(
            {ground_, frame_.view, {255, 0, 255}, flight::time_of_source(test_support::kNow), {nullptr, &aircraft, {}}});
        return elements_.moving().pieces().size();
    };
    const std::size_t early = pieces_at(9.79, base::SignalState::valid);
    const std::uint64_t standing = elements_.planned().standing_key;
    EXPECT_GT(early, 6u);
    EXPECT_EQ(elements_.reports()[0].count.drawn, 1u);
    EXPECT_LT(pieces_at(9.84, base::SignalState::valid), early) << "the path's end is nearer";
    EXPECT_EQ(pieces_at(9.79, base::SignalState::stale), 1u) << "the line alone";
    EXPECT_EQ(elements_.planned().standing_key, standing);
    EXPECT_EQ(elements_.standing().pieces().size(), 0u);
}

}  // namespace
}  // namespace tedavis::display::test_cued_elements
