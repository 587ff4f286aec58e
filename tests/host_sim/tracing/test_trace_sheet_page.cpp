#include "host_sim/tracing/trace_sheet_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_trace_sheet_page {
namespace {

TEST(TraceSheetPage, TellsTimesBytesAndErrors) {
    const test_support::FlownFiles files;
    base::SerialWorkers workers;
    const TracedGround ground(files.terrain, workers);
    TraceSheet sheet = plan_trace_sheet();
    sheet.terrain = "hills & <dales>.tdb";
    for (TraceSheet::Group& group : sheet.groups)
        for (TraceSheet::Picture& picture : group.pictures) {
            picture.shot.pixels = {2, 2, std::vector<std::uint8_t>(16, 200)};
            picture.shot.picture_ms = 7.25;
            picture.from_quality.mean = 1.5;
        }
    const std::string page = trace_sheet_page(sheet, ground);
    EXPECT_THAT(page, ::testing::HasSubstr("hills &amp; &lt;dales&gt;.tdb"));
    EXPECT_THAT(page, ::testing::HasSubstr("<td>7.2</td>"));
    EXPECT_THAT(page, ::testing::HasSubstr("data:image/png;base64,"));
    EXPECT_THAT(page, ::testing::Not(::testing::HasSubstr("http")));
    const auto json = nlohmann::json::parse(trace_sheet_json(sheet, ground));
    EXPECT_EQ(json.at("pictures").size(), 14u);
    EXPECT_EQ(json.at("pictures")[0].at("error").at("mean"), 1.5);
    const DrawnSheet drawn = labelled_sheet(sheet, ground);
    EXPECT_EQ(drawn.groups.size(), 3u);
    EXPECT_THAT(drawn.groups[0].pictures[0].design, ::testing::HasSubstr("1.50 from quality"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_trace_sheet_page
