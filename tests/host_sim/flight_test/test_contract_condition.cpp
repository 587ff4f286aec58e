#include "host_sim/flight_test/contract_condition.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/contract/contract_meter.hpp"
#include "host_sim/flight_test/judge_expectation.hpp"
#include "tests/host_sim/flight_test/painted_picture.hpp"
#include "tests/host_sim/flight_test/read_samples.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/sheets/contract_runs.hpp"

namespace tedavis::host_sim::test_contract_condition {
namespace {

using test_support::PaintedFrame;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kLabels =
    "[[condition]]\nname = \"labels are read\"\nmeasure = \"luminance_contrast\"\nlayer = \"labels\"\nleast = 3\n";
const std::string kCalm = "[[condition]]\nname = \"calm\"\nmeasure = \"clutter\"\nmost = 0.2\n";

/// Frames as a contract's tests paint them: a label of 255 on ground of 120 stands out, one of 140 does not.
class ContractOfAFrame : public ::testing::Test {
protected:
    FrameCondition read(const std::string& contract, const std::string& keys = "") {
        const std::string path = place_.write("c.toml", contract);
        const std::vector<FrameCondition> conditions = read_all("contract = \"" + path + "\"\n" + keys);
        EXPECT_THAT(faults_, ::testing::IsEmpty());
        return conditions.empty() ? FrameCondition{} : conditions.back();
    }
    std::vector<FrameCondition> read_all(const std::string& text) {
        return test_support::read_sample(text, faults_, [&](ScriptTable& table, ScriptFaults&) {
            std::vector<FrameCondition> conditions;
            if (const auto phase = table.text("phase")) conditions.push_back({"phase", *phase, {}});
            read_contract_condition(table, picture_options_, conditions);
            return conditions;
        });
    }
    std::string fault_of(const std::string& contract, const std::string& keys = "") {
        static_cast<void>(read_all("contract = \"" + place_.write("c.toml", contract) + "\"\n" + keys));
        EXPECT_EQ(faults_.size(), 1u);
        return faults_.empty() ? std::string() : faults_[0];
    }
    ObservedFrame frame_of(const PaintedFrame& painted, double time_s = 0) {
        const test_support::FramePainter painter(painted);
        const FrameResult result = test_support::painted_result(painted, {});
        shown_.picture = painter.picture;
        shown_.mask = {test_support::FramePainter::kWidth, test_support::FramePainter::kHeight, painter.layers, {}};
        shown_.mask.names.assign(display::kPictureLayerNames.begin(), display::kPictureLayerNames.end());
        shown_.read = flight_frame_of(nlohmann::ordered_json::parse(frame_record_json(result, result.record.time)));
        ObservedFrame frame;
        frame.time_s = time_s;
        frame.record = result.record;
        frame.picture = &shown_;
        return frame;
    }
    Observation observe(const std::string& contract, const PaintedFrame& painted) {
        return read(contract).observe(frame_of(painted));
    }
    /// Ten frames a second for 10 s; the label is faint from a time up to, but not at, another.
    ExpectationResult judge(const std::string& contract, WindowKind kind, double faint_from_s, double faint_to_s) {
        Expectation expectation;
        expectation.kind = kind;
        expectation.from_s = 2;
        expectation.to_s = kind == WindowKind::at ? 2 : 8;
        expectation.conditions = {read(contract)};
        ExpectationJudge judge(expectation, {10});
        for (int n = 0; n <= 100; ++n) {
            const double time_s = n / 10.0;
            const bool is_faint = time_s >= faint_from_s - 1e-9 && time_s < faint_to_s - 1e-9;
            if (judge.wants(time_s)) static_cast<void>(judge.take(frame_of(is_faint ? faint() : PaintedFrame(), time_s)));
        }
        return judge.result();
    }
    static PaintedFrame faint() {
        PaintedFrame painted;
        painted.label = 140;
        return painted;
    }
    test_support::TemporaryFolder place_;
    test_support::PaintedPicture shown_;
    PictureOptions picture_options_;
    std::vector<std::string> faults_;
};

TEST_F(ContractOfAFrame, HoldsWhereAllItsConditionsDo) {
    EXPECT_TRUE(observe(kCalm + kLabels, {}).holds);
    const Observation broken = observe(kCalm + kLabels, faint());
    EXPECT_FALSE(broken.holds);
    EXPECT_THAT(broken.found, AllOf(HasSubstr("\"labels are read\" has 1."), HasSubstr("(lower right), and 3.000 is the least")));
    EXPECT_THAT(broken.found, ::testing::Not(HasSubstr("calm")));
    EXPECT_THAT(broken.reason, HasSubstr("phase cruise"));
}

/// `tedavis contract` of a run with the same picture is the oracle.
TEST_F(ContractOfAFrame, MeasuresWhatTheContractOfARunMeasures) {
    for (const int stripe_px : {0, 3}) {
        PaintedFrame painted = faint();
        painted.stripe_px = stripe_px;
        test_support::write_painted_run(place_, "run", 1, [&](std::uint64_t) { return painted; });
        const std::string impossible =
            "[[condition]]\nname = \"a\"\nmeasure = \"clutter\"\nmost = 0\n[[condition]]\nname = \"b\"\nmeasure = "
            "\"saliency_share\"\nleast = 1\n[[condition]]\nname = \"c\"\nmeasure = \"luminance_contrast\"\nlayer = "
            "\"labels\"\nleast = 21\n";
        const Contract contract = read_contract(place_.write("run.toml", impossible));
        const FlightRun run = read_flight_run(place_.file("run"));
        PictureMeter meter(settings_of(contract));
        const auto readings = ContractMeter(contract, run).readings(meter, run.frames[0]);
        const Observation observation = observe(impossible, painted);
        for (std::size_t n = 0; n < readings.size(); ++n) {
            char value[64];
            std::snprintf(value, sizeof value, "\"%s\" has %.3f (", contract.conditions[n].name.c_str(), readings[n].value);
            EXPECT_THAT(observation.found, HasSubstr(value)) << readings[n].words;
        }
    }
}

TEST_F(ContractOfAFrame, CountsInItsPhasesAlone) {
    EXPECT_TRUE(observe(kCalm + kLabels + "phases = [\"approach\"]\n", faint()).holds) << "the frame is one of cruise";
    const Observation none = observe(kLabels + "phases = [\"approach\"]\n", {});
    EXPECT_FALSE(none.holds);
    EXPECT_EQ(none.found, "no condition of the contract applies");
    EXPECT_THAT(none.reason, HasSubstr("phase cruise"));
}

/// A part of the picture that is missing meets no contract.
TEST_F(ContractOfAFrame, WhatHasNothingToMeasureDoesNotHoldUnlessItIsOptional) {
    const std::string symbology =
        "[[condition]]\nname = \"s\"\nmeasure = \"luminance_contrast\"\nlayer = \"symbology\"\nleast = 1\n";
    const Observation missing = observe(kCalm + symbology, {});
    EXPECT_FALSE(missing.holds);
    EXPECT_EQ(missing.found, "\"s\" has nothing to measure");
    EXPECT_TRUE(observe(kCalm + symbology + "optional = true\n", {}).holds);
    EXPECT_FALSE(observe(symbology + "optional = true\n", {}).holds) << "nothing of it was measured";
}

TEST_F(ContractOfAFrame, InASpanATimeBeyondTheLimitMustBeAsLongAsItSays) {
    const std::string patient = kLabels + "for_s = 1\n";
    EXPECT_TRUE(judge(patient, WindowKind::during, 4, 4.9).holds);
    const ExpectationResult broken = judge(patient, WindowKind::during, 4, 5.5);
    EXPECT_FALSE(broken.holds);
    EXPECT_NEAR(broken.failed_s, 5, 1e-9);
    EXPECT_THAT(broken.found, HasSubstr("beyond it for 1.00 s, 1 s are allowed"));
    EXPECT_FALSE(judge(kLabels, WindowKind::during, 4, 4.1).holds) << "without for_s one picture breaks it";
    EXPECT_TRUE(judge(patient, WindowKind::during, 0.5, 2.5).holds) << "what was before the span is not known";
}

TEST_F(ContractOfAFrame, ASingleFrameIsBeyondTheLimitAtOnce) {
    const std::string patient = kLabels + "for_s = 1\n";
    EXPECT_FALSE(judge(patient, WindowKind::at, 2, 2.1).holds);
    EXPECT_TRUE(judge(patient, WindowKind::at, 2.1, 9).holds);
    const ExpectationResult reached = judge(patient, WindowKind::within, 0, 4);
    EXPECT_TRUE(reached.holds);
    EXPECT_NEAR(*reached.reached_s, 4, 1e-9);
}

/// Two flights of one test do not share what they saw.
TEST_F(ContractOfAFrame, EachWindowBeginsAnew) {
    const FrameCondition condition = read(kLabels + "for_s = 1\n");
    const FrameObserver first = condition.begin(WindowKind::during), second = condition.begin(WindowKind::during);
    EXPECT_TRUE(first(frame_of(faint(), 0)).holds);
    EXPECT_TRUE(second(frame_of(faint(), 5)).holds);
    EXPECT_FALSE(first(frame_of(faint(), 1)).holds);
}

TEST_F(ContractOfAFrame, WhatCannotBeJudgedIsAFault) {
    EXPECT_THAT(fault_of("[[condition]]\nmeasure = \"clutter\"\n"),
                AllOf(HasSubstr("f.toml:1: 'contract': "), HasSubstr("most")));
    EXPECT_THAT(fault_of(kLabels + "phases = [\"approach\"]\n", "phase = \"cruise\"\n"),
                AllOf(HasSubstr("f.toml:1"), HasSubstr("has no condition for the phase cruise")));
    const std::string rank = "[[condition]]\nname = \"r\"\nmeasure = \"obstacle_rank\"\nmost = 5\n";
    EXPECT_THAT(fault_of(rank), HasSubstr("\"r\" of"));
    static_cast<void>(read(rank + "optional = true\n"));
    static_cast<void>(read(kLabels + rank + "phases = [\"approach\"]\n", "phase = \"cruise\"\n"));
    const std::string of_data = "[[condition]]\nname = \"d\"\nlayer = \"data\"\nleast = 1\nmeasure = ";
    EXPECT_THAT(fault_of(of_data + "\"saliency_share\"\n"), HasSubstr("\"d\" of"));
    static_cast<void>(read(of_data + "\"luminance_contrast\"\n"));  // traffic has some
    picture_options_.scene = "jacksboro";
    static_cast<void>(read(rank));
    static_cast<void>(read(kLabels + "phases = [\"approach.final\"]\n", "phase = \"approach\"\n"));
    static_cast<void>(read_all("contract = \"aproach\"\n"));
    EXPECT_THAT(faults_, ElementsAre(AllOf(HasSubstr("f.toml:1: 'contract': there is no file"), HasSubstr("aproach"))));
}

TEST_F(ContractOfAFrame, WithoutTheKeyThereIsNone) { EXPECT_TRUE(read_all("title = \"A\"\n").empty()); }

}  // namespace
}  // namespace tedavis::host_sim::test_contract_condition
