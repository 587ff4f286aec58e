#include "host_sim/tracing/trace_sheet.hpp"

#include <gtest/gtest.h>

#include <set>

#include "host_sim/commands/trace.hpp"
#include "host_sim/user_error.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_trace_sheet {
namespace {

TEST(TraceSheet, HasAFileOfItsOwnForEachPicture) {
    const TraceSheet sheet = plan_trace_sheet();
    std::set<std::string> files;
    std::size_t pictures = 0;
    for (const TraceSheet::Group& group : sheet.groups)
        for (const TraceSheet::Picture& picture : group.pictures) {
            files.insert(picture.file);
            ++pictures;
        }
    EXPECT_EQ(files.size(), pictures);
    EXPECT_EQ(sheet.groups.front().pictures.back().title, "quality");
}

TEST(TraceSheet, MeasuresPicturesAgainstTheBest) {
    const test_support::FlownFiles files;
    base::SerialWorkers workers;
    const TracedGround ground(files.terrain, workers);
    TracedShotPlan plan;
    plan.pose = usual_pose(ground);
    plan.width = 64;
    plan.height = 48;
    plan.rounds = 1;
    TraceSheet sheet = plan_trace_sheet();
    std::size_t told = 0;
    draw_trace_sheet(sheet, ground, plan, workers, [&](std::size_t done, std::size_t) { told = done; });
    EXPECT_EQ(told, 14u);
    for (const TraceSheet::Group& group : sheet.groups)
        for (const TraceSheet::Picture& picture : group.pictures) {
            EXPECT_EQ(picture.from_quality.mean == 0, picture.title == "quality") << picture.title;
            EXPECT_GT(picture.shot.picture_ms, 0);
        }
    EXPECT_THROW(draw_trace_sheet(sheet, ground, plan, workers, [](std::size_t, std::size_t) { throw Interrupted("enough"); }),
                 Interrupted);
}

}  // namespace
}  // namespace tedavis::host_sim::test_trace_sheet
