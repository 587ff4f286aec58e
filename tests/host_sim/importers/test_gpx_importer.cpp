#include "host_sim/importers/gpx_importer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render_core/base/units.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_gpx_importer {
namespace {

std::string gpx(const std::string& content) {
    return "<?xml version=\"1.0\"?>\n<gpx version=\"1.1\" xmlns=\"http://www.topografix.com/GPX/1/1\">" + content + "</gpx>\n";
}
std::string point(const std::string& attributes, const std::string& content) {
    return "<trkpt " + attributes + ">" + content + "</trkpt>";
}
const std::string kPoint = point("lat='46.5' lon='9.75'", "<ele>1500.5</ele><time>2020-04-12T09:47:00Z</time>");

TEST(GpxImporter, ReadsTracksAsFlights) {
    const ImportedFile file = import_gpx(
        gpx("<trk><name>morning</name><trkseg>" + kPoint + "</trkseg></trk><trk><trkseg>" + kPoint + "</trkseg></trk>"), "t.gpx");
    ASSERT_EQ(file.flights.size(), 2u);
    EXPECT_EQ(file.flights[0].aircraft, "1");
    EXPECT_EQ(file.flights[0].callsign, "morning");
    EXPECT_EQ(file.flights[1].aircraft, "2");
    EXPECT_EQ(file.flights[0].gnss_datum, HeightDatum::msl_egm96);
    const RecordedFix& fix = file.flights[0].fixes.at(0);
    EXPECT_NEAR(base::degrees(fix.latitude_rad), 46.5, 1e-12);
    EXPECT_NEAR(base::degrees(fix.longitude_rad), 9.75, 1e-12);
    EXPECT_EQ(fix.gnss_height_m, 1500.5);
    EXPECT_EQ(fix.time.ns, 1586684820 * std::int64_t{1'000'000'000});
}

TEST(GpxImporter, ReadsPrefixedElementsAndTheRecordersOwnSeparation) {
    const std::string text =
        "<g:gpx xmlns:g='http://www.topografix.com/GPX/1/1'><g:trk><g:trkseg><g:trkpt lat='1' lon='2'><g:ele>10</g:ele>"
        "<g:time>2020-04-12T09:47:00Z</g:time><g:geoidheight>48.5</g:geoidheight></g:trkpt></g:trkseg></g:trk></g:gpx>";
    EXPECT_EQ(import_gpx(text, "t.gpx").flights.at(0).fixes.at(0).geoid_separation_m, 48.5);
}

TEST(GpxImporter, SkipsPointsWithoutTimeOrPositionAndCountsThem) {
    const ImportedFile file =
        import_gpx(gpx("<trk><trkseg>" + kPoint + point("lat='1' lon='2'", "") + point("lat='91' lon='2'", "") +
                       point("lon='2'", "") + point("lat='x' lon='2'", "") + "</trkseg></trk>"),
                   "t.gpx");
    EXPECT_EQ(file.flights[0].fixes.size(), 1u);
    EXPECT_THAT(file.notes, ::testing::ElementsAre("1 track points have no time and were skipped",
                                                   "3 track points have no position and were skipped"));
}

TEST(GpxImporter, RefusesWhatIsNoTrack) {
    test_support::expect_user_error([] { (void)import_gpx("<gpx><trk>", "t.gpx"); }, "not well-formed XML");
    test_support::expect_user_error([] { (void)import_gpx("<kml></kml>", "t.gpx"); }, "root is not <gpx>");
    test_support::expect_user_error([] { (void)import_gpx(gpx("<wpt lat='1' lon='2'/>"), "t.gpx"); }, "no track point");
}

}  // namespace
}  // namespace tedavis::host_sim::test_gpx_importer
