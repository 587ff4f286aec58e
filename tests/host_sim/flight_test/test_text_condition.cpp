#include "host_sim/flight_test/text_condition.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host_sim/flight_test/painted_picture.hpp"
#include "tests/host_sim/flight_test/read_samples.hpp"
#include "tests/support/draw/batch_rasterizer.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::host_sim::test_text_condition {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr int kWidth = 640, kHeight = 480;

class TextCondition : public ::testing::Test {
protected:
    TextCondition() { write("TERRAIN AHEAD", layout_.annunciations.center()); }

    void write(const std::string& text, draw::Point at) {
        draw::TextStyle style;
        style.color = {255, 255, 255, 255};
        EXPECT_TRUE(store_.batch.text(text, at, draw::TextAnchor::center, style));
    }
    void cover(const draw::Rect& box) { EXPECT_TRUE(store_.batch.box(box, {60, 60, 60, 255})); }

    Observation observe(const std::string& text) {
        std::vector<std::string> faults;
        const auto conditions = test_support::read_sample(text, faults, [](ScriptTable& table, ScriptFaults& found) {
            std::vector<FrameCondition> read;
            read_text_conditions(table, found, read);
            return read;
        });
        EXPECT_TRUE(faults.empty());
        EXPECT_EQ(conditions.size(), 1u);
        test_support::Picture drawn(kWidth, kHeight, {90, 110, 70, 255});
        test_support::rasterize(store_.batch, drawn);
        picture_.picture = {kWidth, kHeight, {}};
        for (std::size_t n = 0; n < drawn.rgb.size(); n += 3)
            picture_.picture.pixels.insert(picture_.picture.pixels.end(),
                                           {drawn.rgb[n], drawn.rgb[n + 1], drawn.rgb[n + 2], 255});
        ObservedFrame frame;
        frame.words = placed_words(store_.batch, layout_);
        frame.picture = has_picture_ ? &picture_ : nullptr;
        return conditions.at(0).observe(frame);
    }
    draw::Layout layout_ = draw::make_layout(kWidth, kHeight, 96);
    test_support::BatchStore store_;
    test_support::PaintedPicture picture_;
    bool has_picture_ = true;
};

TEST_F(TextCondition, HoldsWhereItIsWrittenAndSeen) {
    EXPECT_TRUE(observe("text = { says = \"TERRAIN AHEAD\", in = \"annunciations\" }").holds);
    EXPECT_TRUE(observe("text = { says = \"AHEAD\" }").holds);
    EXPECT_FALSE(observe("text = { says = \"OBSTACLE AHEAD\" }").holds);
    EXPECT_FALSE(observe("text = { says = \"AHEAD\", in = \"heading\" }").holds);
}

/// The record states it all the same.
TEST_F(TextCondition, DoesNotHoldWhereAnotherThingCoversIt) {
    cover(layout_.annunciations);
    const Observation found = observe("text = { says = \"TERRAIN AHEAD\" }");
    EXPECT_FALSE(found.holds);
    EXPECT_THAT(found.found, AllOf(HasSubstr("it is written, but not seen"), HasSubstr("and 0.85 is needed")));
    EXPECT_THAT(found.reason, HasSubstr("covers it"));
    has_picture_ = false;
    EXPECT_TRUE(observe("text = { says = \"TERRAIN AHEAD\" }").holds) << "without a picture what is written counts";
}

TEST_F(TextCondition, OnePlaceOfSeveralThatIsSeenIsEnough) {
    cover(layout_.annunciations);
    write("TERRAIN AHEAD", {320, 300});
    EXPECT_TRUE(observe("text = { says = \"TERRAIN AHEAD\" }").holds);
    EXPECT_FALSE(observe("text = { says = \"TERRAIN AHEAD\", in = \"annunciations\" }").holds);
}

/// The reason is one of the text, and a long picture is not listed.
TEST_F(TextCondition, WhatIsMissingIsNamedByItsNearestText) {
    Observation found = observe("text = { says = \"Terrain ahead\" }");
    EXPECT_EQ(found.found, "\"TERRAIN AHEAD\"");
    EXPECT_THAT(found.reason, HasSubstr("in another case"));
    found = observe("text = { says = \"TERRAIN AHEAD\", in = \"heading\" }");
    EXPECT_EQ(found.found, "no text");
    EXPECT_EQ(found.reason, "it is written in annunciations");
    for (const char* const text : {"IAS", "ALT", "HDG", "CRUISE"})
        write(text, {100, 60 + 40 * static_cast<float>(std::string_view(text).front() - 'A')});
    found = observe("text = { says = \"TERAIN AHED\" }");
    EXPECT_EQ(found.found, "\"TERRAIN AHEAD\", \"IAS\", \"ALT\", \"HDG\", \"CRUISE\"") << "all, as they are few";
    EXPECT_EQ(found.reason, "no text there has these words");
    for (int n = 0; n < 8; ++n) write("MSG" + std::string(1, static_cast<char>('A' + n)), {500, 60 + 40 * static_cast<float>(n)});
    const std::string many = "13 texts, the most similar ones ";
    EXPECT_THAT(observe("text = { says = \"TERAIN AHED\" }").found, StartsWith(many + "\"TERRAIN AHEAD\", "));
    EXPECT_THAT(observe("text = { says = \"cruise\" }").found, StartsWith(many + "\"CRUISE\", "));
    EXPECT_EQ(observe("text = { says = \"MSGX\" }").found, many + "\"MSGA\", \"MSGB\", \"MSGC\"");
}

/// A word in the wrong case is never written: that it is not there would prove nothing.
TEST_F(TextCondition, WhatMustNotBeThereIsNotWrittenInAnotherCaseEither) {
    const Observation found = observe("text = { says = \"terrain Ahead\", there = false }");
    EXPECT_FALSE(found.holds);
    EXPECT_EQ(found.found, "\"TERRAIN AHEAD\"");
    EXPECT_THAT(found.reason, HasSubstr("in another case"));
    EXPECT_TRUE(observe("text = { says = \"errain ahead\", there = false }").holds) << "these words whole";
}

/// What must not be written may not even be written where it is covered, and nobody looks at the picture.
TEST_F(TextCondition, WhatMustNotBeThereIsNotWritten) {
    cover(layout_.annunciations);
    EXPECT_FALSE(observe("text = { says = \"TERRAIN AHEAD\", there = false }").holds);
    EXPECT_TRUE(observe("text = { says = \"PULL UP\", there = false }").holds);
    EXPECT_EQ(picture_.times_asked(), 0);
}

}  // namespace
}  // namespace tedavis::host_sim::test_text_condition
