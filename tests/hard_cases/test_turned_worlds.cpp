// Flights over the antimeridian, over the pole and along 46.7 N with the camera at every pitch: nothing that is no number, no
// hole, errors as stated, and the same pictures when the world is turned about its axis.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "tests/hard_cases/flat_geoid.hpp"
#include "tests/hard_cases/turned_world.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/terrain/mesh_places.hpp"
#include "tests/support/terrain/picture_proof.hpp"
#include "tests/support/terrain/watched_surface.hpp"

namespace tedavis::test_turned_worlds {
namespace {

using test_support::HeadlessDisplay;
using test_support::PictureProof;
using test_support::TerrainPicture;
using test_support::TurnedWorld;
using test_support::WatchedSurface;

constexpr std::uint32_t kWidth = 320, kHeight = 240;
constexpr int kPitches = 25;            // from straight down to straight up
constexpr double kTurned_deg = -173.4;  // far from any symmetry

/// A straight flight over a world: from one place to another, in degrees; beyond a pole the latitude goes on.
struct Journey {
    const char* name;
    TurnedWorld::Shape shape;
    double from_latitude_deg, from_longitude_deg, to_latitude_deg, to_longitude_deg, height_m;
    double least_error_px;  ///< that must be found somewhere: the control
};
void PrintTo(const Journey& journey, std::ostream* out) { *out << journey.name; }

const Journey kJourneys[] = {
    {"Antimeridian", {320, 240, 179.86, 46.8, 1 / 1200.0, 1 / 1200.0}, 46.7, 179.95, 46.72, 180.03, 5200, 0.05},
    {"Pole", {360, 100, -180, 89.995, 1, 0.005, true, true}, 89.8, -140, 90.25, -140, 6000, 0.02},
    {"RoundTheEarthAt46North", {1800, 33, -180, 47.66, 0.2, 0.06, true}, 46.7, -170, 46.7, 175, 9000, 0.05},
};

/// One picture of a journey.
terrain::View view_on(const Journey& journey, const TurnedWorld& world, int n, double turned_deg) {
    const double along = (n + 0.5) / kPitches;
    double latitude = base::radians(journey.from_latitude_deg + along * (journey.to_latitude_deg - journey.from_latitude_deg)),
           longitude =
               base::radians(journey.from_longitude_deg + along * (journey.to_longitude_deg - journey.from_longitude_deg));
    double heading = journey.shape.has_pole ? 0 : base::kPi / 2;
    if (latitude > base::kPi / 2) {
        latitude = base::kPi - latitude;
        longitude += base::kPi;
        heading = base::kPi;
    }
    const double ground_m = world.surface_at(base::degrees(latitude), base::degrees(longitude) + turned_deg);
    const glm::dmat3 body = earth::body_axes(latitude, longitude, heading, test_support::pitch_rad(n, kPitches), 0);
    const double c = std::cos(base::radians(turned_deg)), s = std::sin(base::radians(turned_deg));
    const glm::dmat3 turn(c, s, 0, -s, c, 0, 0, 0, 1);
    const glm::dvec3 eye = earth::to_ecef({latitude, longitude, {ground_m + journey.height_m}});
    return test_support::free_view(turn * eye, turn * body, kWidth, kHeight, 50);
}

struct Flown {
    std::vector<TerrainPicture> pictures;
    WatchedSurface::Counts numbers;
};

Flown fly(const Journey& journey, const TurnedWorld& world, const std::vector<std::uint8_t>& image, double turned_deg,
          const design::DesignSettings& design) {
    test_support::MemoryBytes bytes(image);
    HeadlessDisplay headless("egl", "desktop", kWidth, kHeight, &bytes, design, [](std::unique_ptr<base::Surface> surface) {
        return std::unique_ptr<base::Surface>(std::make_unique<WatchedSurface>(std::move(surface)));
    });
    Flown flown;
    for (int n = 0; n < kPitches; ++n) {
        const terrain::View view = view_on(journey, world, n, turned_deg);
        flown.pictures.emplace_back(headless, view, earth::from_ecef(view.eye));
        EXPECT_TRUE(std::isfinite(flown.pictures.back().record().terrain.worst_error_px)) << n;
        EXPECT_TRUE(std::isfinite(flown.pictures.back().record().terrain.tau_reached_px)) << n;
    }
    flown.numbers = WatchedSurface::counts();
    return flown;
}

/// Random drawn points are no farther from their true places than stated, and than tau wherever chunks end with the data.
void expect_errors_within_tau(const TurnedWorld& world, const std::vector<std::uint8_t>& image, const Flown& flown,
                              double least_error_px) {
    constexpr int kPoints = 800;
    test_support::MemoryTerrain drawn(image);
    std::vector<std::uint8_t> memory(terrain::LodSelector::bytes_needed(8000));
    base::Arena arena(memory.data(), memory.size());
    terrain::LodSelector selector;
    EXPECT_TRUE(selector.start(arena, 8000));
    std::vector<terrain::SelectedChunk> selected(2000);
    const auto scratch = std::make_unique<terrain::ChunkMeshScratch>();
    std::mt19937 random(3);
    double worst_px = 0, worst_excess_px = -1e9;
    int points = 0;
    for (const TerrainPicture& picture : flown.pictures) {
        const terrain::LodResult stated =
            selector.select(drawn, picture.view(), {}, terrain::SelectionKind::ideal, {selected.data(), selected.size()});
        EXPECT_EQ(stated.reason == terrain::LodStop::met, stated.worst_error_px <= 1);
        for (int n = 0; n < kPoints && stated.chunks > 0; ++n) {
            const terrain::SelectedChunk& chunk = selected[random() % stated.chunks];
            const test_support::ChunkTriangles mesh = drawn.triangles(chunk.key, *chunk.entry, chunk.coarser_edges, *scratch);
            test_support::DrawnPlace place;
            if (!make_drawn_place(world, test_support::random_point(mesh, random), place)) continue;
            if (!test_support::is_in_picture(picture.view(), place.drawn)) continue;
            const double found_px = test_support::displacement_px(picture.view(), place);
            worst_px = std::max(worst_px, found_px);
            worst_excess_px = std::max(worst_excess_px, found_px - stated.worst_error_px);
            ++points;
        }
    }
    EXPECT_GT(points, 1000);
    EXPECT_LE(worst_px, 1);
    EXPECT_LE(worst_excess_px, 1e-6);
    EXPECT_GT(worst_px, least_error_px) << "control: there are errors to be seen";
}

struct Difference {
    int pixels = 0, different = 0, largest = 0;
};

Difference difference(const std::vector<TerrainPicture>& a, const std::vector<TerrainPicture>& b) {
    Difference all;
    for (std::size_t n = 0; n < a.size(); ++n)
        for (int row = 0; row < a[n].height(); ++row)
            for (int column = 0; column < a[n].width(); ++column) {
                int largest = 0;
                for (int channel = 0; channel < 3; ++channel)
                    largest = std::max(largest, std::abs(a[n].pixel(column, row)[channel] - b[n].pixel(column, row)[channel]));
                ++all.pixels;
                all.different += largest > 1 ? 1 : 0;
                all.largest = std::max(all.largest, largest);
            }
    return all;
}

class TurnedWorlds : public ::testing::TestWithParam<Journey> {
protected:
    test_support::FlatGeoid flat_;
    TurnedWorld world_{GetParam().shape, 0};
    std::vector<std::uint8_t> image_ = test_support::build_image(world_.raster);
};

TEST_P(TurnedWorlds, EveryPitchIsWithoutAHoleAndWithinTheStatedError) {
    const Flown flown = fly(GetParam(), world_, image_, 0, test_support::garish_design());
    EXPECT_EQ(flown.numbers.not_finite, 0u);
    EXPECT_GT(flown.numbers.numbers, 10'000u) << "control: the numbers were seen";
    PictureProof proof;
    int enclosed = 0, ground = 0;
    for (const TerrainPicture& picture : flown.pictures) {
        proof.include(picture, test_support::TrueView(world_, picture.view()), static_cast<std::uint32_t>(proof.pictures));
        enclosed += picture.enclosed_background();
        ground += picture.width() * picture.height() - picture.background();
    }
    EXPECT_EQ(proof.cracks, 0) << proof.text();
    EXPECT_EQ(enclosed, 0);
    EXPECT_EQ(proof.unsettled, 0);
    EXPECT_EQ(proof.met, kPitches) << proof.text();
    EXPECT_GT(ground, kPitches * int(kWidth) * int(kHeight) / 4);
    expect_errors_within_tau(world_, image_, flown, GetParam().least_error_px);
}

// Half a turn takes the grids of the vertices along, and the antimeridian to Greenwich.
TEST_P(TurnedWorlds, LookTheSameOnTheOtherSideOfTheEarth) {
    const TurnedWorld turned(GetParam().shape, 180);
    const design::DesignSettings design = test_support::shipped_design("default");
    const Difference found = difference(fly(GetParam(), world_, image_, 0, design).pictures,
                                        fly(GetParam(), turned, test_support::build_image(turned.raster), 180, design).pictures);
    EXPECT_EQ(found.different, 0) << "of " << found.pixels << " by more than one step, by " << found.largest << " at most";
}

TEST_P(TurnedWorlds, LookTheSameFromTurnedPlaces) {
    const TurnedWorld turned(GetParam().shape, kTurned_deg);
    design::DesignSettings design = test_support::shipped_design("default");
    const Flown here = fly(GetParam(), world_, image_, 0, design),
                there = fly(GetParam(), turned, test_support::build_image(turned.raster), kTurned_deg, design);
    const Difference found = difference(here.pictures, there.pictures);
    std::printf("%s: %d of %d pixels differ by more than one step, by %d at most\n", GetParam().name, found.different,
                found.pixels, found.largest);
    // Vertices lie on a grid of their own, which does not turn: a pixel's centre on a silhouette may change sides, and a distance
    // the step of its 8 bit code, which a silhouette's ink shows.
    EXPECT_LE(found.different, found.pixels / 40'000);
    const double moved_deg = 5 * GetParam().shape.step_lon_deg;
    EXPECT_GT(difference(here.pictures, fly(GetParam(), world_, image_, moved_deg, design).pictures).different,
              found.pixels / 100)
        << "control: five posts are seen";
}

INSTANTIATE_TEST_SUITE_P(Flights, TurnedWorlds, ::testing::ValuesIn(kJourneys),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tedavis::test_turned_worlds
