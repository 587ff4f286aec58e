#include "host_sim/replay/run_estimate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <functional>
#include <sstream>

#include "host_sim/interrupt.hpp"
#include "host_sim/replay/frame_preroll.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_run_estimate {
namespace {

using ::testing::HasSubstr;

ReplayOptions options() {
    static const test_support::FlownFiles kFiles;
    ReplayOptions o = kFiles.options("unused");
    o.picture.size = PictureSize{160, 120};
    o.frames = FrameOutput::png;
    return o;
}

/// A session with the flight, and the frames of half a second each.
struct Flown {
    ReplayOptions asked;
    DisplaySession session{asked.picture, false};
    FlightPlayer player{{asked.log, asked.picture.bus, asked.switches, asked.switch_config}, session.display()};
    FrameInstants times{asked, player.first(), player.last(), session.device().frame_rate_hz};

    explicit Flown(const ReplayOptions& o) : asked(o) {}
    [[nodiscard]] RunEstimate estimate() { return estimate_run(asked, times, player, session); }
    /// What `measure` says of each picture.
    std::vector<std::uint64_t> drawn(const std::function<std::uint64_t()>& measure) {
        FramePreroll preroll(player, session, session.device().frame_rate_hz);
        std::vector<std::uint64_t> measured;
        for (std::uint64_t n = 0; n < times.count(); ++n) {
            EXPECT_TRUE(preroll.preroll(times.at(n)));
            const flight::FrameInput input = player.at(times.at(n));
            session.display().plan({input.state, input.phase, times.at(n), input.trail, input.legend});
            session.draw();
            measured.push_back(measure());
        }
        return measured;
    }
};

TEST(RunEstimate, BytesAreThoseOfPicturesAndRecords) {
    double records = 0;
    {
        ReplayOptions o = options();
        o.frames = FrameOutput::hash;
        records = Flown(o).estimate().bytes;
    }
    EXPECT_GT(records, 17 * 500);
    Flown flown(options());
    const RunEstimate whole = flown.estimate();
    EXPECT_EQ(whole.frames, 17u);
    EXPECT_GT(whole.seconds, 0);
    double bytes = 0;  // of the pictures that a run keeps
    for (const std::uint64_t picture_bytes : flown.drawn([&] { return encode_png(flown.session.pixels()).size(); }))
        bytes += static_cast<double>(picture_bytes);
    EXPECT_NEAR(whole.bytes - records, bytes, 0.25 * bytes);
}

TEST(RunEstimate, LeavesTheRunAsItIs) {
    std::vector<std::uint64_t> expected;
    {
        Flown alone(options());
        expected = alone.drawn([&] { return alone.session.frame_hash(); });
    }
    Flown estimated(options());
    (void)estimated.estimate();
    EXPECT_EQ(estimated.session.display().memory().frames, 0u) << "frames are counted from the run's first";
    EXPECT_EQ(estimated.drawn([&] { return estimated.session.frame_hash(); }), expected);
}

TEST(RunEstimate, IsSaidInWords) {
    EXPECT_EQ(words_of({585'300, 18'000, 80.2e9}), "585300 frames, about 5.0 h and 80 GB");
    EXPECT_EQ(words_of({300, 61.2, 41.2e6}), "300 frames, about 62 s and 42 MB");
    EXPECT_EQ(words_of({20'001, 600, 4.04e9}), "20001 frames, about 10 min and 4.0 GB");
}

/// What is said and whether it goes on, where `answer` is typed; null: nobody can answer.
struct Consent {
    bool goes_on = false;
    std::string notes;

    Consent(const RunEstimate& estimate, const char* answer, bool yes = false) {
        std::ostringstream results, said;
        std::istringstream typed(answer != nullptr ? answer : "");
        Console console(results, said, false, true);
        if (answer != nullptr) console.set_answers(&typed);
        ReplayOptions o;
        o.output = "out";
        o.yes = yes;
        try {
            require_consent(estimate, o, console);
            goes_on = true;
        } catch (const UserError& error) {
            said << error.what();
        }
        notes = said.str();
    }
};

/// With a line that waits: no answer counts then.
TEST(RunEstimate, AnInterruptedQuestionIsNoAnswer) {
    const InterruptGuard of_command;
    raise(SIGINT);
    for (const char* typed : {"", "y\n"}) {
        try {
            const Consent consent({20'001, 10, 1e6}, typed);
            ADD_FAILURE() << "it goes on: " << consent.notes;
        } catch (const Interrupted& interrupted) {
            EXPECT_STREQ(interrupted.what(), "interrupted; nothing was written to out");
        }
    }
}

TEST(RunEstimate, AShortRunIsNotSpokenOfAndALongerOneIsNot) {
    const Consent quiet({200, 10, 1e6}, nullptr), said({201, 10, 1e6}, nullptr);
    EXPECT_TRUE(quiet.goes_on);
    EXPECT_EQ(quiet.notes, "");
    EXPECT_TRUE(said.goes_on);
    EXPECT_EQ(said.notes, "note: out: 201 frames, about 10 s and 1 MB\n");
}

TEST(RunEstimate, ALongRunNeedsAnAnswer) {
    for (const RunEstimate& estimate : {RunEstimate{20'001, 10, 1e6}, RunEstimate{5000, 10, 4.1e9}}) {
        EXPECT_TRUE(Consent(estimate, "y\n").goes_on);
        EXPECT_THAT(Consent(estimate, "y\n").notes, HasSubstr("go on? [y/N]"));
        for (const char* no : {"n\n", "\n", "", "maybe\n"}) {
            const Consent refused(estimate, no);
            EXPECT_FALSE(refused.goes_on) << no;
            EXPECT_THAT(refused.notes, HasSubstr("not confirmed; nothing was written to out"));
        }
        const Consent nobody(estimate, nullptr);
        EXPECT_FALSE(nobody.goes_on);
        EXPECT_THAT(nobody.notes, HasSubstr("or confirm with --yes"));
        EXPECT_TRUE(Consent(estimate, nullptr, true).goes_on);
    }
    EXPECT_TRUE(Consent({20'000, 1e5, 4e9}, nullptr).goes_on) << "the limits themselves are no long run";
}

}  // namespace
}  // namespace tedavis::host_sim::test_run_estimate
