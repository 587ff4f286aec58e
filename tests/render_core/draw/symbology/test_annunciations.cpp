#include "render_core/draw/symbology/annunciations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/symbology/short_words.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "render_core/policy/notice_table.hpp"
#include "tests/support/draw/batch_shapes.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_annunciations {
namespace {

using flight::PhaseSource;
using policy::Notice;
using policy::NoticeLevel;
using test_support::BatchShape;
using test_support::BatchStore;

struct Screen {
    std::uint32_t width, height;
};
constexpr Screen kScreens[] = {{240, 320}, {320, 240}, {480, 800}, {640, 480}, {800, 480}, {1280, 720}, {3840, 2160}};

flight::PhaseStatus phase_of(const flight::FlightPhase& phase, PhaseSource source = PhaseSource::switches) {
    return flight::stated_phase(phase, source);
}

/// The first warnings and cautions of the notice table, which has the most urgent first.
std::vector<Notice> urgent_notices(std::size_t count) {
    std::vector<Notice> notices;
    for (const policy::NoticeRow& row : policy::notice_rows())
        if (row.level != NoticeLevel::information && notices.size() < count) notices.push_back({row.level, row.text});
    EXPECT_EQ(notices.size(), count);
    return notices;
}

AnnunciationPlan plan_of(const Layout& layout, const std::vector<Notice>& notices, const flight::PhaseStatus* phase) {
    return plan_annunciations(layout.annunciations, layout.text_px, phase, {notices.data(), notices.size()});
}

bool is_notice(const Annunciation& field) {
    return field.kind == AnnunciationKind::warning || field.kind == AnnunciationKind::caution;
}

std::vector<std::string> notices_in(const AnnunciationPlan& plan) {
    std::vector<std::string> texts;
    for (const Annunciation& field : plan.fields)
        if (is_notice(field)) texts.emplace_back(field.text.view());
    return texts;
}

bool fields_overlap(const AnnunciationPlan& plan) {
    for (std::size_t i = 0; i < plan.fields.size(); ++i)
        for (std::size_t j = i + 1; j < plan.fields.size(); ++j)
            if (plan.fields[i].box.shrunk(0.01f).overlaps(plan.fields[j].box)) return true;
    return false;
}

template <typename Check>
void for_every_strip(Check check) {
    for (const Screen& screen : kScreens)
        for (const double dpi : {60.0, 96.0, 160.0})
            for (const flight::FlightPhase phase :
                 {flight::kGoAroundReplanning, flight::kTakeoffSecondClimb, flight::FlightPhase{flight::Scenario::cruise, 0}})
                for (std::size_t count = 0; count <= 14; ++count) {
                    SCOPED_TRACE(std::to_string(screen.width) + "x" + std::to_string(screen.height) + ", " +
                                 std::to_string(count) + " notices");
                    check(make_layout(screen.width, screen.height, dpi), phase_of(phase), urgent_notices(count));
                }
}

TEST(Annunciations, NoFieldOverlapsAnotherOrLeavesTheStrip) {
    for_every_strip([](const Layout& layout, const flight::PhaseStatus& phase, const std::vector<Notice>& notices) {
        const AnnunciationPlan plan = plan_of(layout, notices, &phase);
        EXPECT_FALSE(fields_overlap(plan));
        for (const Annunciation& field : plan.fields) EXPECT_TRUE(layout.annunciations.contains(field.box)) << field.text.view();
    });
    // Negative control.
    const flight::PhaseStatus phase = phase_of(flight::kApproachFinal);
    AnnunciationPlan moved = plan_of(make_layout(1280, 720, 96), urgent_notices(2), &phase);
    moved.fields[3].box.x = moved.fields[2].box.right() - 2;
    EXPECT_TRUE(fields_overlap(moved));
}

TEST(Annunciations, TheWordsHaveTheRoomThatTheyTake) {
    for_every_strip([](const Layout& layout, const flight::PhaseStatus& phase, const std::vector<Notice>& notices) {
        for (const Annunciation& field : plan_of(layout, notices, &phase).fields) {
            EXPECT_LE(text_width_px(field.text.view(), field.size * layout.text_px), field.box.width) << field.text.view();
            EXPECT_GE(field.size * layout.text_px, 10.99f) << "legible";
            // Capitals are lower than an em by what the typeface says.
            EXPECT_GE(field.box.height, font_atlas().cap_height_em * field.size * layout.text_px) << field.text.view();
        }
    });
}

TEST(Annunciations, TheMostUrgentComeFirstAndWhatIsLeftOutIsCounted) {
    for_every_strip([](const Layout& layout, const flight::PhaseStatus& phase, const std::vector<Notice>& notices) {
        const AnnunciationPlan plan = plan_of(layout, notices, &phase);
        const std::vector<std::string> shown = notices_in(plan);
        ASSERT_EQ(shown.size() + plan.left_out, notices.size());
        EXPECT_TRUE(!shown.empty() || notices.empty());
        for (std::size_t n = 0; n < shown.size(); ++n) EXPECT_EQ(shown[n], notices[n].text.view());
        const Annunciation& last = plan.fields.back();
        EXPECT_EQ(last.kind == AnnunciationKind::more, plan.left_out > 0);
        if (plan.left_out > 0) {
            EXPECT_EQ(std::string(last.text.view()), "+" + std::to_string(plan.left_out) + " MORE");
        }
        // Reading order: from the left, then the row below.
        const Annunciation* before = nullptr;
        for (const Annunciation& field : plan.fields) {
            if (field.kind == AnnunciationKind::phase || field.kind == AnnunciationKind::phase_source) continue;
            EXPECT_TRUE(before == nullptr || field.box.x > before->box.x || field.box.y > before->box.bottom() - 0.01f);
            before = &field;
        }
    });
}

TEST(Annunciations, AlmostEveryPictureHasRoomForTwoNoticesAndAWideOneForThreeInOneRow) {
    const flight::PhaseStatus phase = phase_of(flight::kGoAroundReplanning, PhaseSource::motion);
    for (const Screen& screen : kScreens)
        EXPECT_GE(notices_in(plan_of(make_layout(screen.width, screen.height, 96), urgent_notices(14), &phase)).size(),
                  screen.width < 320 ? 1u : 2u)
            << screen.width << "x" << screen.height;
    const AnnunciationPlan wide = plan_of(make_layout(1280, 720, 96), urgent_notices(3), &phase);
    ASSERT_EQ(notices_in(wide).size(), 3u);
    EXPECT_FLOAT_EQ(wide.fields[2].box.y, wide.fields[4].box.y);
}

/// On the narrowest screen it may have the shorter wording that the table of such words has for it.
TEST(Annunciations, EveryNoticeOfTheTableIsShownWholeWhereItIsTheOnlyOne) {
    const flight::PhaseStatus phase = phase_of(flight::kGoAroundReplanning, PhaseSource::motion);
    for (const Screen& screen : kScreens)
        for (const policy::NoticeRow& row : policy::notice_rows()) {
            if (row.level == NoticeLevel::information) continue;
            const Layout layout = make_layout(screen.width, screen.height, 96);
            const AnnunciationPlan plan = plan_of(layout, {{row.level, row.text}}, &phase);
            const std::string shown(plan.fields.back().text.view());
            EXPECT_TRUE(shown == row.text || (screen.width < 320 && shown == short_wording(row.text))) << shown;
            EXPECT_LE(text_width_px(shown, plan.fields.back().size * layout.text_px), plan.fields.back().box.width) << shown;
        }
}

TEST(Annunciations, InformationIsNotInTheStrip) {
    const std::vector<Notice> notices{{NoticeLevel::caution, "TERRAIN COARSE"}, {NoticeLevel::information, "NOT FOR NAVIGATION"}};
    const AnnunciationPlan plan = plan_of(make_layout(640, 480, 96), notices, nullptr);
    EXPECT_EQ(notices_in(plan), std::vector<std::string>{"TERRAIN COARSE"});
    EXPECT_EQ(plan.left_out, 0u);
    EXPECT_TRUE(plan_of(make_layout(640, 480, 96), {notices[1]}, nullptr).fields.empty());
}

TEST(Annunciations, AHostileNumberOfLongNoticesStillHasTheFirst) {
    const std::vector<Notice> notices(16, {NoticeLevel::caution, "WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW"});
    const flight::PhaseStatus phase = phase_of(flight::kGoAroundReplanning, PhaseSource::motion);
    for (const Screen& screen : kScreens) {
        const Layout layout = make_layout(screen.width, screen.height, 96);
        const AnnunciationPlan plan = plan_of(layout, notices, &phase);
        EXPECT_GE(notices_in(plan).size(), 1u);
        EXPECT_EQ(notices_in(plan).size() + plan.left_out, 16u);
        EXPECT_FALSE(fields_overlap(plan));
        for (const Annunciation& field : plan.fields) EXPECT_TRUE(layout.annunciations.shrunk(-0.01f).contains(field.box));
    }
}

SymbologyInput input_with(const std::vector<Notice>& notices, PhaseSource source) {
    SymbologyInput input = test_support::scene_input(test_support::scene_state(3, 0, 0), 640, 480);
    input.phase = phase_of(flight::kApproachFinal, source);
    input.decisions.notices.clear();
    for (const Notice& notice : notices) EXPECT_TRUE(input.decisions.notices.try_push_back(notice));
    return input;
}

std::string text_in(const SymbologyInput& input, design::Color color) {
    BatchStore store;
    const Layout layout = make_layout(640, 480, 96);
    build_annunciations(Painter(store.batch, layout), input);
    return test_support::text_in(store.batch, layout.annunciations, color);
}

TEST(Annunciations, ColorsSayHowUrgentANoticeIsAndHowCertainThePhaseIs) {
    const std::vector<Notice> notices{{NoticeLevel::warning, "PULL UP"}, {NoticeLevel::caution, "COARSE"}};
    for (const PhaseSource source : {PhaseSource::switches, PhaseSource::can, PhaseSource::motion}) {
        const SymbologyInput input = input_with(notices, source);
        EXPECT_TRUE(is_phase_certain(input.phase));
        EXPECT_EQ(text_in(input, test_support::day_color(SymbolRole::warning)), "PULLUP");
        EXPECT_EQ(text_in(input, test_support::day_color(SymbolRole::caution)), "COARSE");
        EXPECT_EQ(text_in(input, test_support::day_color(SymbolRole::engaged)).find("APPROACHFINALPHASE"), 0u);
    }
    EXPECT_EQ(text_in(input_with(notices, PhaseSource::held), test_support::day_color(SymbolRole::caution)),
              "APPROACHFINALPHASEHELDCOARSE");
    EXPECT_EQ(text_in(input_with({}, PhaseSource::none), test_support::day_color(SymbolRole::caution)),
              "APPROACHFINALPHASENOSOURCE");
    EXPECT_EQ(text_in(input_with({}, PhaseSource::none), test_support::day_color(SymbolRole::engaged)), "");
}

TEST(Annunciations, TheGroundIsTranslucentAndNoticesHaveAFrame) {
    BatchStore store;
    const Layout layout = make_layout(640, 480, 96);
    SymbologyInput input = input_with({{NoticeLevel::caution, "COARSE"}}, PhaseSource::can);
    input.position_time.reset();  // no activity mark, whose lines lie aslant
    build_annunciations(Painter(store.batch, layout), input);
    std::size_t solid = 0, frames = 0;
    for (const BatchShape& shape : test_support::shapes_of(store.batch)) {
        if (shape.letter != 0) continue;
        const bool is_frame = shape.has(test_support::day_color(SymbolRole::caution));
        frames += is_frame ? 1 : 0;
        const bool is_thin = std::min(shape.bounds.width, shape.bounds.height) < 0.3f * layout.text_px;  // the frame's rim
        solid += !is_frame && !is_thin && shape.color.alpha == 255 ? 1 : 0;
    }
    EXPECT_EQ(solid, 0u);
    EXPECT_EQ(frames, 4u) << "the sides of one frame";
}

TEST(Annunciations, ThePhaseIsSmallerThanTheAltitudesReadout) {
    const flight::PhaseStatus phase = phase_of(flight::kApproachFinal);
    for (const Screen& screen : kScreens) {
        if (screen.width < 640) continue;  // there both are the smallest legible text
        const AnnunciationPlan plan = plan_of(make_layout(screen.width, screen.height, 96), {}, &phase);
        EXPECT_LT(plan.fields[0].size, 1.0f);
        EXPECT_LT(plan.fields[1].size, plan.fields[0].size);
    }
}

}  // namespace
}  // namespace tedavis::draw::test_annunciations
