#include "host_sim/reports/run_findings.hpp"

#include <gtest/gtest.h>

#include "tests/support/programs/command_run.hpp"

namespace tedavis::host_sim::test_run_findings {
namespace {

TEST(RunFindings, ArePrintedAsWarningsAndWrittenWithTheirNames) {
    Findings findings = {{"a.b", "3 of 4 frames", 3}};
    append(findings, {{"c", "all 2", 2}});
    const auto run = test_support::run_command([&](Console& console) {
        print_warnings(findings, console);
        return exit_code_of(findings, false);
    });
    EXPECT_EQ(run.notes, "warning: 3 of 4 frames\nwarning: all 2\n");
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(findings_json(findings).dump(),
              R"([{"name":"a.b","text":"3 of 4 frames","count":3},{"name":"c","text":"all 2","count":2}])");
    EXPECT_EQ(findings_json({}).dump(), "[]");
}

TEST(RunFindings, FailOnlyWhereTheCommandIsStrict) {
    EXPECT_EQ(exit_code_of({{"a", "b", 1}}, true), 1);
    EXPECT_EQ(exit_code_of({{"a", "b", 1}}, false), 0);
    EXPECT_EQ(exit_code_of({}, true), 0);
}

TEST(RunFindings, CountInWords) {
    EXPECT_EQ(counted(1, "frame"), "1 frame");
    EXPECT_EQ(counted(0, "frame"), "0 frames");
    EXPECT_EQ(part_of(3, 4), "3 of 4");
    EXPECT_EQ(part_of(4, 4), "all 4");
    EXPECT_EQ(age_words(2400), "40 min");
    EXPECT_EQ(age_words(3.5 * 3600), "3.5 h");
    EXPECT_EQ(age_words(74 * 86400.0), "74 d");
}

}  // namespace
}  // namespace tedavis::host_sim::test_run_findings
