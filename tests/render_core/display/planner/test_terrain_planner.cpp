#include "render_core/display/terrain_painter.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/gl/render_target.hpp"
#include "render_core/terrain/drawn_surface.hpp"
#include "render_core/terrain/projected_error.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/programs/gl_session.hpp"
#include "tests/support/terrain/built_database.hpp"
#include "tests/support/terrain/raster_ray_caster.hpp"

namespace tedavis::display::test_terrain_planner {
namespace {

using base::radians;

constexpr std::uint32_t kWidth = 320, kHeight = 240;

const host_sim::Raster& raster() {
    static const host_sim::Raster kRaster = test_support::make_rough_raster(193, 193);
    return kRaster;
}
const test_support::BuiltDatabase& hills() {
    static const test_support::BuiltDatabase built(raster());
    return built;
}

design::DesignSettings plain_design() {
    design::DesignSettings design = design::default_design_settings();
    design.sky.haze_distance_m = 0;
    return design;
}

/// From a post of the raster at a height above MSL.
Camera camera_at(double i, double j, double msl_m, double heading_deg, double pitch_deg) {
    const double latitude = radians(raster().north_deg - j * raster().step_lat_deg),
                 longitude = radians(raster().west_deg + i * raster().step_lon_deg);
    CameraInput input;
    input.own_ship = {latitude, longitude, {msl_m + hills().database.undulation(latitude, longitude).m}};
    input.msl_m = msl_m;
    input.above_ground_m = msl_m - 1000;
    input.heading_rad = radians(heading_deg);
    input.pitch_rad = radians(pitch_deg);
    input.width_px = kWidth;
    input.height_px = kHeight;
    return make_camera(input, design::ViewSettings(), 0);
}

/// A scene on a surface, each budget line with memory of its own.
class Stage {
public:
    /// `small_line` of the device's lines is cut to a thousand bytes.
    explicit Stage(const design::DesignSettings& design, const std::string& small_line = "",
                   const std::vector<std::uint8_t>& image = hills().image)
        : at_("egl", "es3-mid", kWidth, kHeight), design_(design), bytes_(image), reader_(bytes_, base::kMaxReadTickets) {
        for (std::size_t n = 0; n < kLines; ++n) {
            const std::string name(kNames[n]);
            memory_[n].resize(name == small_line ? 1000 : static_cast<std::size_t>(at_.device.budget.find(name)->bytes));
            arenas_[n] = base::Arena(memory_[n].data(), memory_[n].size());
        }
        const draw::DrawnDesign only{&design};
        error = scene.start({&bytes_, &reader_, terrain::ArrivalMode::exact}, {&only, 1}, at_.device,
                            {arenas_[0], arenas_[1], arenas_[2], arenas_[3], arenas_[4], arenas_[5], arenas_[6]});
        if (!error) error = painter.start(at_.gl, scene, {&only, 1}, at_.device, arenas_[6]);
        if (!error) scene.follow_painter(painter.reads_pages(), painter.tracer());
        if (!error) scene.set_design(only);
        at_.gl.seal();
    }
    ~Stage() {
        at_.gl.retire();
        painter.destroy(at_.gl);
    }
    /// With everything arrived.
    TerrainPlan settled(const Camera& camera) {
        TerrainPlan plan;
        for (int n = 0; n < 4; ++n) plan = scene.plan(camera, design_);
        return plan;
    }
    bool prepare(const Camera& camera) { return painter.prepare(at_.gl, scene.seen_from(camera.view), input(camera)); }
    draw::TerrainDrawResult draw(const Camera& camera) {
        draw::TerrainDrawResult result;
        gl::bind_surface(at_.gl, *at_.surface);
        painter.draw(at_.gl, scene.seen_from(camera.view), input(camera), {camera.view.near_m, camera.view.far_m}, result);
        EXPECT_EQ(at_.gl.denied().total, 0u);
        return result;
    }
    bool shows(const design::DesignSettings& design) const { return painter.shows({&design}); }

    TerrainPlanner scene;
    TerrainPainter painter;
    base::Error error;

private:
    static constexpr std::size_t kLines = 7;
    static constexpr std::string_view kNames[kLines] = {
        effects::kTerrainIndex, effects::kTerrainChunkSlots, effects::kTerrainHeights, effects::kTerrainAttributes,
        effects::kTerrainDrape, effects::kLodScratch,        effects::kStaging};
    static draw::TerrainDrawInput input(const Camera& camera) {
        draw::TerrainDrawInput input;
        input.view = camera.view;
        input.light_direction[0] = glm::normalize(camera.view.eye);
        return input;
    }

    test_support::GlSession at_;
    design::DesignSettings design_;
    test_support::MemoryBytes bytes_;
    base::SynchronousReader reader_;
    std::vector<std::uint8_t> memory_[kLines];
    base::Arena arenas_[kLines];
};

TEST(TerrainPlanner, TheLineThatDoesNotHoldIsNamed) {
    EXPECT_EQ(Stage(plain_design()).error.message.view(), "");
    for (const std::string line : {"terrain_chunk_slots", "terrain_heights", "terrain_attributes", "lod_scratch", "staging"}) {
        const Stage stage(plain_design(), line);
        EXPECT_NE(std::string(stage.error.message.view()).find("'" + line + "'"), std::string::npos)
            << line << ": " << stage.error.message.view();
        EXPECT_EQ(database_fault(stage.error.message.view()), "");
        EXPECT_FALSE(stage.scene.is_started());
    }
}

TEST(TerrainPlanner, ADatabaseThatIsNoneIsRefusedWithItsOffset) {
    std::vector<std::uint8_t> image = hills().image;
    image[100] ^= 8;
    const Stage stage(plain_design(), "", image);
    EXPECT_EQ(database_fault(stage.error.message.view()).find("has a damaged header (offset 0); get a whole copy"), 0u);
}

TEST(TerrainPlanner, TracedTerrainHasNoErrorWhateverHasArrived) {
    Stage stage(plain_design());
    const TerrainPlan plan = stage.scene.plan(camera_at(96, 96, 2600, 40, -15), plain_design());
    EXPECT_GT(plan.lod.worst_error_px, 0);
    const TerrainPlan traced = as_traced(plan, false);
    EXPECT_EQ(traced.lod.worst_error_px, 0);
    EXPECT_EQ(traced.lod.worst_waiting_px, 0);
    EXPECT_EQ(traced.lod.worst_coarse_px, 0);
    EXPECT_EQ(traced.lod.reason, terrain::LodStop::met);
    EXPECT_TRUE(traced.lod.within_budget);
    EXPECT_EQ(traced.lod.chunks, plan.lod.chunks);
    EXPECT_EQ(traced.pending, plan.pending) << "of what else reads chunks";
}

TEST(TerrainPlanner, RaysThatCannotBeLeaveTriangles) {
    design::DesignSettings design = plain_design();
    EXPECT_EQ(Stage(design).scene.trace_state(), draw::TraceState::not_asked_for);
    design.terrain.renderer = design::TerrainRenderer::trace;
    Stage stage(design);
    ASSERT_EQ(stage.error.message.view(), "");
    EXPECT_EQ(stage.scene.trace_state(), draw::TraceState::not_on_device) << "the stage shades no rays";
    EXPECT_TRUE(stage.shows(plain_design()));
}

TEST(TerrainPlanner, CoarserFirstThenRefinedToTau) {
    Stage stage(plain_design());
    const Camera camera = camera_at(96, 96, 2600, 40, -15);
    double last_px = 1e9;
    for (int frame = 0; frame < 6; ++frame) {
        const TerrainPlan plan = stage.scene.plan(camera, plain_design());
        EXPECT_GT(plan.lod.chunks, 0u) << frame;
        EXPECT_LE(plan.lod.worst_error_px, last_px) << frame;
        EXPECT_EQ(plan.pending == 0, plan.lod.reason == terrain::LodStop::met) << frame;
        if (frame == 0) {
            EXPECT_GT(plan.pending, 0u);
        }
        last_px = plan.lod.worst_error_px;
    }
    EXPECT_LE(last_px, plain_design().terrain.tau_px);
    EXPECT_FALSE(stage.scene.plan(camera, plain_design()).is_failing);
}

/// Boxes alone say for these eyes, from which the near plane is a metre away, several times as much.
TEST(TerrainPlanner, CloseOverTheGroundTauIsReached) {
    Stage stage(plain_design());
    design::DesignSettings design = plain_design();
    design.terrain.tau_px = 0.5;
    int over_tau_by_boxes = 0;
    for (const double post : {40.3, 64.1, 97.6, 128.5, 150.2}) {
        const double latitude = radians(raster().north_deg - post * raster().step_lat_deg),
                     longitude = radians(raster().west_deg + post * raster().step_lon_deg);
        Camera camera = camera_at(post, post, stage.scene.true_height(latitude, longitude).height.m + 3, 11 * post, -8);
        camera.view.near_m = 1;
        camera.view.focal_px *= 3;
        TerrainPlan plan;
        for (int n = 0; n < 6; ++n) plan = stage.scene.plan(camera, design);
        EXPECT_EQ(plan.lod.reason, terrain::LodStop::met) << post;
        EXPECT_LE(plan.lod.worst_error_px, 0.5) << post;
        double by_boxes_px = 0;
        for (const terrain::SelectedChunk& chunk : stage.scene.selected())
            by_boxes_px = std::fmax(by_boxes_px,
                                    terrain::error_in_box_px(*chunk.entry, camera.view,
                                                             double{std::fmax(chunk.entry->above_m, chunk.entry->below_m)}, 0));
        over_tau_by_boxes += by_boxes_px > 0.5 ? 1 : 0;
    }
    EXPECT_GE(over_tau_by_boxes, 3);
}

// A frame without terrain is a frame: what was seen before it falls out of the window.
TEST(TerrainPlanner, RestingForgetsAsFramesDo) {
    Stage stage(plain_design());
    const Camera camera = camera_at(96, 96, 2600, 40, -15);
    EXPECT_EQ(stage.settled(camera).pending, 0u);
    for (std::uint32_t frame = 0; frame <= terrain::StoreSettings().window_frames; ++frame) stage.scene.rest();
    EXPECT_TRUE(stage.scene.selected().empty());
    EXPECT_GT(stage.scene.plan(camera, plain_design()).pending, 0u);
    EXPECT_EQ(stage.settled(camera).pending, 0u);
    stage.scene.rest();
    EXPECT_EQ(stage.scene.plan(camera, plain_design()).pending, 0u) << "control: a single one does not";
}

TEST(TerrainPlanner, NothingThatIsDrawnLiesBeyondTheFarthestDepth) {
    Stage stage(plain_design());
    for (const double heading : {0.0, 130.0, 250.0}) {
        const Camera camera = camera_at(96, 96, 2600, heading, -10);
        static_cast<void>(stage.settled(camera));
        const double far_m = stage.scene.farthest_depth_m(camera.view);
        double farthest_m = 0;
        for (const terrain::SelectedChunk& chunk : stage.scene.selected()) {
            const glm::dvec3 centre(chunk.entry->centre_m[0], chunk.entry->centre_m[1], chunk.entry->centre_m[2]);
            for (const terrain::ChunkVertex& v : hills().vertices(*chunk.entry))
                farthest_m =
                    std::max(farthest_m, glm::dot(centre + glm::dvec3(v.x, v.y, v.z) - camera.view.eye, camera.view.forward));
        }
        EXPECT_GE(far_m, farthest_m);
        EXPECT_LT(far_m, 1.3 * farthest_m);
    }
}

/// Turned about the view's axis.
Camera rolled(Camera camera, double roll_deg) {
    const glm::dvec3 right = camera.view.right, down = camera.view.down;
    camera.view.right = right * std::cos(radians(roll_deg)) + down * std::sin(radians(roll_deg));
    camera.view.down = down * std::cos(radians(roll_deg)) - right * std::sin(radians(roll_deg));
    return camera;
}

/// Along x * part.right + y * part.up, of the places in front of the eye; ECEF.
double highest_of(const std::vector<glm::dvec3>& places, const terrain::View& view, const draw::ScreenPart& part) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const glm::dvec3& at : places) {
        const glm::dvec3 place = at - view.eye;
        const double depth_m = glm::dot(place, view.forward);
        if (depth_m < view.near_m) continue;
        const double x = glm::dot(place, view.right) / depth_m / view.half_width_tangent(),
                     y = -glm::dot(place, view.down) / depth_m / view.half_height_tangent();
        highest = std::max(highest, x * double{part.right} + y * double{part.up});
    }
    return highest;
}

glm::dvec3 centre_of(const terrain::ChunkEntry& entry) { return {entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]}; }

/// The vertices as they are drawn, each raised along the ellipsoid's normal at its post.
std::vector<glm::dvec3> vertices_of(const terrain::SelectedChunk& chunk) {
    const terrain::Lattice& lattice = hills().database.lattice();
    const terrain::PostRange posts = lattice.posts_of(terrain::key_of(*chunk.entry));
    std::vector<glm::dvec3> places;
    for (const terrain::ChunkVertex& v : hills().vertices(*chunk.entry)) {
        const double latitude = lattice.latitude_rad(posts.j0 + v.j), longitude = lattice.longitude_rad(posts.i0 + v.i);
        const glm::dvec3 normal(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                                std::sin(latitude));
        places.push_back(centre_of(*chunk.entry) + glm::dvec3(v.x, v.y, v.z) +
                         normal * double{terrain::vertex_lift_m(chunk.lift, posts, v)});
    }
    return places;
}

/// The corners of the box that holds a chunk's surface and mesh, moved up.
std::vector<glm::dvec3> raised_box(const terrain::ChunkEntry& entry, double lift_m) {
    std::vector<glm::dvec3> corners{centre_of(entry)};
    for (int a = 0; a < 3; ++a) {
        const glm::dvec3 axis(entry.axes[3 * a], entry.axes[3 * a + 1], entry.axes[3 * a + 2]);
        std::vector<glm::dvec3> both;
        for (const glm::dvec3& corner : corners)
            for (const double sign : {-1.0, 1.0})
                both.push_back(corner + axis * (sign * double{entry.half_extent_m[a]} - (a == 2 ? lift_m : 0)));
        corners = both;
    }
    return corners;
}

TEST(TerrainPlanner, NothingThatIsDrawnLiesBeyondTheDrawnPart) {
    const design::DesignSettings design = plain_design();
    Stage stage(design);
    EXPECT_EQ(stage.scene.seen_from(camera_at(96, 96, 2600, 130, 4).view).part.limit, draw::ScreenPart().limit)
        << "no pass reads it";
    stage.scene.set_design({&design, draw::TerrainOutput::color_and_distance});
    int narrow = 0;
    for (const double roll : {0.0, 25.0, -70.0, 180.0})
        for (const double pitch : {-10.0, 4.0, -89.99}) {
            const Camera camera = rolled(camera_at(96, 96, 2600, 130, pitch), roll);
            static_cast<void>(stage.settled(camera));
            const draw::ScreenPart part = stage.scene.seen_from(camera.view).part;
            narrow += part.limit < 0.9f * (std::abs(part.right) + std::abs(part.up)) ? 1 : 0;
            for (const terrain::SelectedChunk& chunk : stage.scene.selected())
                ASSERT_LT(highest_of(vertices_of(chunk), camera.view, part), double{part.limit} - 1 / camera.view.focal_px)
                    << roll << ", " << pitch;
        }
    EXPECT_GT(narrow, 3) << "a part that is always the whole screen says nothing";
}

/// Conservative-up raises vertices, with a large tau by tens of metres, and out of the boxes of their chunks.
TEST(TerrainPlanner, LiftedChunksLieWithinTheDrawnPartToo) {
    design::DesignSettings design = plain_design();
    design.terrain.conservative_up = true;
    design.terrain.tau_px = 12;
    Stage stage(design);
    stage.scene.set_design({&design, draw::TerrainOutput::color_and_distance});
    int large = 0, beyond_boxes = 0;
    for (const double roll : {0.0, 25.0, -70.0, 180.0})
        for (const double heading : {20.0, 130.0, 250.0, 315.0})
            for (const double msl_m : {900.0, 1500.0, 2600.0}) {
                const Camera camera = rolled(camera_at(96, 96, msl_m, heading, -4), roll);
                static_cast<void>(stage.settled(camera));
                const draw::ScreenPart part = stage.scene.seen_from(camera.view).part;
                const double limit = double{part.limit} - 1 / camera.view.focal_px;
                for (const terrain::SelectedChunk& chunk : stage.scene.selected()) {
                    SCOPED_TRACE(::testing::Message() << roll << ", " << heading << ", " << msl_m);
                    const double own_m = double{chunk.lift.own_m};
                    large += own_m > 10 ? 1 : 0;
                    const double highest = highest_of(vertices_of(chunk), camera.view, part);
                    ASSERT_LT(highest, limit);
                    ASSERT_LT(highest_of(raised_box(*chunk.entry, own_m), camera.view, part), limit);
                    beyond_boxes += highest > highest_of(raised_box(*chunk.entry, 0), camera.view, part) ? 1 : 0;
                }
            }
    EXPECT_GT(large, 10);
    EXPECT_GT(beyond_boxes, 0) << "control: boxes alone do not hold what is lifted";
}

/// What stands on the ground stands on what is drawn: within tau of the true surface, by an oracle of its own.
TEST(TerrainPlanner, DrawnPointsLieWithinTauOfTheTrueSurface) {
    Stage stage(plain_design());
    const test_support::RasterRayCaster truth(raster());
    const Camera camera = camera_at(96, 96, 2600, 40, -15);
    static_cast<void>(stage.settled(camera));
    ASSERT_TRUE(stage.prepare(camera));
    EXPECT_GT(stage.draw(camera).triangles, 0u);
    int seen = 0, off = 0;
    for (double j = 8.3; j < 185; j += 4.7)
        for (double i = 8.6; i < 185; i += 4.9) {
            const double lat_deg = raster().north_deg - j * raster().step_lat_deg,
                         lon_deg = raster().west_deg + i * raster().step_lon_deg;
            const terrain::DrawnPoint drawn = stage.scene.drawn_point(radians(lat_deg), radians(lon_deg));
            if (!drawn.found) continue;
            const glm::dvec3 true_point =
                earth::to_ecef({radians(lat_deg), radians(lon_deg), {*truth.surface_m(lat_deg, lon_deg)}});
            const glm::dvec3 a = drawn.position - camera.view.eye, b = true_point - camera.view.eye;
            const double depth_m = glm::dot(a, camera.view.forward);
            if (depth_m < 100 || std::abs(glm::dot(a, camera.view.right)) > depth_m * camera.view.half_width_tangent() ||
                std::abs(glm::dot(a, camera.view.down)) > depth_m * camera.view.half_height_tangent())
                continue;
            ++seen;
            EXPECT_LE(glm::length(a / depth_m - b / glm::dot(b, camera.view.forward)) * camera.view.focal_px, 1.01)
                << i << ", " << j;
            off += glm::length(drawn.position - true_point) > 0.1 ? 1 : 0;
        }
    EXPECT_GT(seen, 50);
    EXPECT_GT(off, 0) << "control: it is the drawn surface, not the true one";
    EXPECT_FALSE(stage.scene.drawn_point(radians(48.5), radians(9.6)).found) << "outside";
}

TEST(TerrainPlanner, TheTrueHeightIsThatOfThePosts) {
    Stage stage(plain_design());
    for (const std::uint32_t n : {3u, 77u, 150u}) {
        const terrain::HeightAnswer answer = stage.scene.true_height(radians(raster().north_deg - n * raster().step_lat_deg),
                                                                     radians(raster().west_deg + n * raster().step_lon_deg));
        EXPECT_EQ(answer.status, terrain::HeightStatus::land);
        EXPECT_NEAR(answer.height.m, double{raster().height_m[raster().at(n, n)]}, 0.05);
    }
}

}  // namespace
}  // namespace tedavis::display::test_terrain_planner
