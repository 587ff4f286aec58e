#include "host_sim/commands/gallery_flight.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_gallery_flight {
namespace {

/// The files, made once for all tests.
const GalleryFiles& files() {
    static std::ostringstream results, notes;
    static Console console(results, notes, false, false);
    static const GalleryFiles kFiles(console);
    return kFiles;
}

PictureOptions small() {
    PictureOptions picture;
    picture.size = PictureSize{160, 90};
    return picture;
}

TEST(GalleryFlight, APictureIsTheSameWhateverWasDrawnBefore) {
    const GalleryMoment& early = gallery_moments().front();
    const GalleryMoment& late = gallery_moments()[5];
    std::uint64_t early_hash = 0, late_hash = 0;
    {
        GalleryFlight forwards(files(), small());
        early_hash = forwards.draw(early).result.hash;
        late_hash = forwards.draw(late).result.hash;
    }
    GalleryFlight backwards(files(), small());
    EXPECT_EQ(backwards.draw(late).result.hash, late_hash);
    EXPECT_EQ(backwards.draw(early).result.hash, early_hash);
    EXPECT_NE(early_hash, late_hash) << "control";
}

TEST(GalleryFlight, FliesTheDemosAircraftUnlessAnotherIsNamed) {
    EXPECT_EQ(files().over({}).aircraft, "turboprop");
    PictureOptions other;
    other.aircraft = "my.toml";
    other.terrain = "my.tdb";
    EXPECT_EQ(files().over(other).aircraft, "my.toml");
    EXPECT_NE(files().over(other).terrain, "my.tdb");
}

TEST(GalleryFlight, AMomentThatItDoesNotHaveIsRefused) {
    GalleryFlight flight(files(), small());
    GalleryMoment moment = gallery_moments().front();
    moment.turn = 9;
    test_support::expect_user_error([&] { static_cast<void>(flight.draw(moment)); }, "the default flight: flies");
}

}  // namespace
}  // namespace tedavis::host_sim::test_gallery_flight
