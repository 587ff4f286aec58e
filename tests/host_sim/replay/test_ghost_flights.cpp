#include "host_sim/replay/ghost_flights.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/scene_builder/open_scene.hpp"
#include "render_core/draw/data/ghost_signs.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::host_sim::test_ghost_flights {
namespace {

using ::testing::ElementsAre;

const test_support::FlownFiles& files() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

/// The own flight again, so many seconds later.
std::string later(int seconds) {
    return files().folder.write("later" + std::to_string(seconds) + ".log",
                                test_support::log_of(test_support::FlownLater(seconds)));
}

ShownGhosts made(const ReplayOptions& options, const std::string& folder) {
    std::ostringstream results, notes;
    Console console(results, notes, false, false);
    return make_ghosts(options, folder, console);
}

TEST(GhostFlights, TheLayerHasThemWhereTheyWereThen) {
    const test_support::TemporaryFolder folder;
    for (const int seconds : {0, 2, -2}) {
        ReplayOptions options = files().options("unused");
        options.ghosts = {later(seconds)};
        const ShownGhosts ghosts = made(options, folder.path());
        const OpenScene open(ghosts.scene);
        const scene::Layer& layer = *open.scene().find("ghosts");
        const test_support::FlownCircle flown;
        for (const double at_s : {3.5, 4.0, 4.9}) {
            const draw::GhostPlace place = draw::ghost_place(layer, 0, (flown.begin() + base::Duration::from_seconds(at_s)).ns);
            ASSERT_TRUE(place.is_known) << seconds;
            const SignalSample sample = flown.at(flown.begin() + base::Duration::from_seconds(at_s - seconds)).value();
            const earth::Geodetic expected{sample[flight::Signal::latitude], sample[flight::Signal::longitude], {}};
            EXPECT_LT(earth::surface_distance_m(expected, {place.point.latitude_rad, place.point.longitude_rad, {}}), 5)
                << seconds;
            EXPECT_NEAR(place.point.height_m, sample[flight::Signal::ellipsoid_height], 2);
        }
    }
}

TEST(GhostFlights, TheSceneKeepsItsLayers) {
    const test_support::TemporaryFolder folder;
    const std::vector<std::uint8_t> bytes = sdb_bytes(test_support::small_scene());
    ReplayOptions options = files().options("unused");
    options.picture.scene = folder.write("small.sdb", {bytes.begin(), bytes.end()});
    options.ghosts = {later(0), later(1)};
    const OpenScene open(made(options, folder.path()).scene);
    EXPECT_EQ(open.scene().layers().size(), 5u);
    EXPECT_NE(open.scene().find("masts"), nullptr);
    ASSERT_NE(open.scene().find("ghosts"), nullptr);
    EXPECT_EQ(open.scene().find("ghosts")->entry->feature_count, 2u);
    EXPECT_EQ(open.scene().find("ghosts")->name_of(1), "GHOST later1");
    EXPECT_EQ(open.scene().find("ghosts")->entry->role, scene::LayerRole::ghost);
}

TEST(GhostFlights, NamesAreThoseOfFilesOrElseOfFolders) {
    EXPECT_THAT(ghost_names("own.log", {"a/other.log.gz", "b/second.log"}), ElementsAre("other", "second"));
    EXPECT_THAT(ghost_names("x/flight.log", {"/a/flight.log", "/b/flight.log"}), ElementsAre("a", "b"));
    EXPECT_THAT(ghost_names("x/flight.log", {"/a/flight.log", "/a/flight.log"}), ElementsAre("a", "a 2"));
    EXPECT_THAT(ghost_names("own.log", {"/a/a_name_that_is_too_long_for_it.log"}), ElementsAre("a_name_that_is_to"));
}

/// A gap ends a line; a single place beside gaps is none.
TEST(GhostFlights, EachStretchIsALine) {
    ScannedFlight own;
    own.ahead = base::Duration::seconds(5);
    GhostTrack track;
    for (const bool joins : {true, false, false, true, true}) {
        track.places.push_back(
            {base::Time{std::int64_t{1'000'000'000} * static_cast<std::int64_t>(track.places.size())}, 0.5, 0.1, 9, joins});
    }
    const LayerDraft layer = ghost_layer(own, {{"a.log", "a", GhostAlign::time, 0, {}}}, {track});
    EXPECT_THAT(layer.starts, ElementsAre(0, 2, 4));
    EXPECT_THAT(layer.names, ElementsAre("GHOST a", "GHOST a"));
    EXPECT_EQ(layer.points[0].time_ns, 5'000'000'000);
    EXPECT_EQ(layer.points[2].time_ns, 8'000'000'000);
}

TEST(GhostFlights, WhatCannotBeShownIsRefused) {
    const test_support::TemporaryFolder folder;
    ReplayOptions options = files().options("unused");
    options.ghosts.assign(5, files().log);
    test_support::expect_user_error([&] { (void)made(options, folder.path()); }, "--ghost: at most 4 flights");
    options.ghosts = {later(86'400)};
    test_support::expect_user_error([&] { (void)made(options, folder.path()); }, "it shares no time with");
    SceneDraft full = test_support::small_scene();
    full.layers.assign(scene::kMaxLayers, test_support::small_areas());
    for (std::size_t n = 0; n < full.layers.size(); ++n) full.layers[n].name = "l" + std::to_string(n);
    const std::vector<std::uint8_t> bytes = sdb_bytes(full);
    options.picture.scene = folder.write("full.sdb", {bytes.begin(), bytes.end()});
    options.ghosts = {files().log};
    test_support::expect_user_error([&] { (void)made(options, folder.path()); }, "at most 32 layers");
}

}  // namespace
}  // namespace tedavis::host_sim::test_ghost_flights
