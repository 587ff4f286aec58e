// The surface grid on the data of a whole display: in step with the ground's, at its heights, where it is asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "render_core/display/display.hpp"
#include "render_core/effects/design_effects.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/display/hills_display.hpp"
#include "tests/support/scene/loaded_scene.hpp"
#include "tests/support/terrain/raster_scene.hpp"

namespace tedavis::display::test_grid_on_data {
namespace {

constexpr std::uint32_t kWidth = 480, kHeight = 360;
constexpr double kLatitude_deg = 47, kLongitude_deg = 9.7;
constexpr float kGround_m = 1000, kCeiling_m = 1001, kWay_m = 1420;
constexpr double kSpacing_m = 500, kHeights_m = 100;

const test_support::RasterScene& plain() {
    static const test_support::RasterScene scene(
        test_support::make_raster(241, 241, [](std::uint32_t, std::uint32_t) { return kGround_m; }));
    return scene;
}

host_sim::LayerDraft zone() {
    host_sim::LayerDraft layer;
    layer.name = "zone";
    layer.shape = scene::LayerShape::areas;
    layer.role = scene::LayerRole::no_go;
    const auto corner = [](double north, double east) {
        return test_support::scene_point(kLatitude_deg + 0.01 * north, kLongitude_deg + 0.01 * east, 0);
    };
    layer.points = {corner(-1, 0), corner(-1, 2), corner(1, 2), corner(1, 0)};
    layer.starts = {0, 4};
    host_sim::AttributeDraft ceiling;
    ceiling.name = "ceiling";
    ceiling.unit = "m";
    ceiling.of = scene::AttributeOf::feature;
    ceiling.values = {kCeiling_m};
    layer.attributes.push_back(ceiling);
    return layer;
}

host_sim::LayerDraft way() {
    host_sim::LayerDraft layer;
    layer.name = "way";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::trajectory;
    for (int n = -10; n <= 10; ++n)
        layer.points.push_back(test_support::scene_point(kLatitude_deg, kLongitude_deg + 0.002 * n, kWay_m));
    layer.starts = {0, 21};
    return layer;
}

enum class Shown { ground, data, data_with_grid };

design::DesignSettings design_of(Shown shown, design::DataTechnique technique) {
    design::DesignSettings design = design::default_design_settings();
    design.terrain.tau_px = 0.01;  // every post
    design.terrain.style.texture = design::TerrainTexture::plain;
    design.terrain.style.plain = {255, 255, 255};
    design.terrain.style.shade.technique = design::TerrainShade::none;
    design.terrain.style.sketch = {};
    design.terrain.style.grid = {kSpacing_m, 0, {0, 0, 0}, 1, kHeights_m};
    design.sky.haze_distance_m = 0;
    design.warning_colors = false;
    design.data.elements.clear();
    if (shown == Shown::ground) return design;
    design::DataElement element;
    element.layer = technique == design::DataTechnique::prism ? "zone" : "way";
    element.technique = technique;
    element.size_m = technique == design::DataTechnique::tube ? 5 : 0;
    element.cues.curtain = technique == design::DataTechnique::tube ? 0.8 : 0;
    element.grid = shown == Shown::data_with_grid;
    EXPECT_TRUE(design.data.elements.try_push_back(element));
    return design;
}

/// From an eye over a place, looking north; without symbology.
struct Place {
    double latitude_deg, msl_m, pitch_deg;
};
terrain::View view_from(const Place& from) {
    const double latitude = base::radians(from.latitude_deg), longitude = base::radians(kLongitude_deg);
    const double undulation_m = plain().built.database.undulation(latitude, longitude).m;
    return test_support::free_view(earth::to_ecef({latitude, longitude, {from.msl_m + undulation_m}}),
                                   earth::body_axes(latitude, longitude, 0, base::radians(from.pitch_deg), 0), kWidth, kHeight,
                                   5);
}

/// One at a time: its surface is current.
class Shows {
public:
    explicit Shows(const design::DesignSettings& design, const std::string& device = "es3-mid")
        : scene_(host_sim::sdb_bytes(host_sim::SceneDraft{"two", "a test", 1, {zone(), way()}})),
          headless_("egl", device, kWidth, kHeight, &terrain_, design, test_support::as_it_is, &scene_) {}
    test_support::HillsPicture from(const terrain::View& view) {
        headless_.display().planner().set_free_view(view);
        return test_support::hills_picture(headless_, test_support::aircraft_over_hills(2500));
    }
    [[nodiscard]] Display& display() { return headless_.display(); }

private:
    test_support::MemoryBytes terrain_{plain().built.image};
    test_support::FlakyBytes scene_;
    test_support::HeadlessDisplay headless_;
};

test_support::HillsPicture picture_of(Shown shown, design::DataTechnique technique, const Place& from,
                                      const std::string& device = "es3-mid") {
    Shows shows(design_of(shown, technique), device);
    return shows.from(view_from(from));
}

constexpr Place kAbove{kLatitude_deg, 5000, -90}, kSouth{kLatitude_deg - 0.025, 1250, 0};

/// In pixels, from the upper left corner.
glm::dvec2 pixel_at(const terrain::View& view, double latitude_deg, double longitude_deg, double msl_m) {
    const double latitude = base::radians(latitude_deg), longitude = base::radians(longitude_deg);
    const double undulation_m = plain().built.database.undulation(latitude, longitude).m;
    const auto pixel = test_support::pixel_of(view, earth::to_ecef({latitude, longitude, {msl_m + undulation_m}}));
    return pixel.value_or(glm::dvec2(-1));
}

/// Pixels of the area in two pictures: ink of lines, by the colour between them.
struct Inks {
    std::vector<double> ground, data;
};
Inks inks_over_zone(const test_support::HillsPicture& ground, const test_support::HillsPicture& data,
                    std::uint32_t moved_px = 0) {
    const terrain::View view = view_from(kAbove);
    const glm::dvec2 low = pixel_at(view, kLatitude_deg + 0.0099, kLongitude_deg + 0.0003, kGround_m),
                     high = pixel_at(view, kLatitude_deg - 0.0099, kLongitude_deg + 0.0197, kGround_m);
    double ground_is = 0, data_is = 0;
    Inks inks;
    for (auto y = static_cast<std::uint32_t>(low.y); y < high.y; ++y)
        for (auto x = static_cast<std::uint32_t>(low.x); x < high.x; ++x) {
            inks.ground.push_back(ground.at(x, y)[1]);
            inks.data.push_back(data.at(x - moved_px, y)[1]);
            ground_is = std::max(ground_is, inks.ground.back());
            data_is = std::max(data_is, inks.data.back());
        }
    for (double& ink : inks.ground) ink = 1 - ink / ground_is;
    for (double& ink : inks.data) ink = 1 - ink / data_is;
    return inks;
}

struct Apart {
    double most = 0;
    int lines = 0;  ///< pixels of the data
};
Apart apart(const Inks& inks) {
    Apart found;
    for (std::size_t n = 0; n < inks.data.size(); ++n) {
        found.most = std::max(found.most, std::fabs(inks.data[n] - inks.ground[n]));
        found.lines += inks.data[n] > 0.5 ? 1 : 0;
    }
    return found;
}

TEST(GridOnData, FromAboveItsLinesGoOnInThoseOfTheGround) {
    for (const char* device : {"es2-small", "es3-mid"}) {
        const auto prism = design::DataTechnique::prism;
        const auto ground = picture_of(Shown::ground, prism, kAbove, device);
        const auto with = picture_of(Shown::data_with_grid, prism, kAbove, device);
        const Apart same = apart(inks_over_zone(ground, with));
        EXPECT_LT(same.most, 0.2) << device << ": a fifth of a pixel";
        EXPECT_GT(same.lines, 500) << device;
        EXPECT_GT(apart(inks_over_zone(ground, with, 1)).most, 0.7) << "control: a pixel aside";
        EXPECT_EQ(apart(inks_over_zone(ground, picture_of(Shown::data, prism, kAbove, device))).lines, 0) << "control: none";
    }
}

TEST(GridOnData, OnACurtainLinesAreAtTheirHeights) {
    const auto with = picture_of(Shown::data_with_grid, design::DataTechnique::tube, kSouth);
    const auto without = picture_of(Shown::data, design::DataTechnique::tube, kSouth);
    const terrain::View view = view_from(kSouth);
    const auto darkened = [&](const glm::dvec2& at) {
        const auto x = static_cast<std::uint32_t>(at.x), y = static_cast<std::uint32_t>(at.y);
        return int{without.at(x, y)[1]} - int{with.at(x, y)[1]};
    };
    const terrain::Lattice& lattice = plain().built.lattice();
    const double middle = lattice.latitude_rad(lattice.rows() / 2);
    const double line_deg = base::degrees(kSpacing_m / (earth::prime_vertical_radius_m(middle) * std::cos(middle)));
    int meridians = 0;
    for (int k = 1; k < 40; ++k) {
        const double on_deg = base::degrees(lattice.longitude_rad(0)) + k * line_deg, between_deg = on_deg + 0.5 * line_deg;
        if (std::fabs(between_deg - kLongitude_deg) > 0.015) continue;
        ++meridians;
        EXPECT_GT(darkened(pixel_at(view, kLatitude_deg, on_deg, 1150)), 100) << "meridian " << k;
        EXPECT_EQ(darkened(pixel_at(view, kLatitude_deg, between_deg, 1150)), 0) << "beside it";
        for (const double msl_m : {1100.0, 1200.0, 1300.0, 1400.0}) {
            EXPECT_GT(darkened(pixel_at(view, kLatitude_deg, between_deg, msl_m)), 100) << msl_m;
            EXPECT_EQ(darkened(pixel_at(view, kLatitude_deg, between_deg, msl_m - 50)), 0) << msl_m;
        }
    }
    EXPECT_GE(meridians, 3);
}

TEST(GridOnData, BothLanesShowTheSame) {
    for (const auto technique : {design::DataTechnique::prism, design::DataTechnique::tube}) {
        const Place& from = technique == design::DataTechnique::prism ? kAbove : kSouth;
        const auto small = picture_of(Shown::data_with_grid, technique, from, "es2-small");
        const auto desktop = picture_of(Shown::data_with_grid, technique, from, "desktop");
        std::size_t off = 0;
        for (std::size_t n = 0; n < small.rgba.size(); ++n) off += std::abs(small.rgba[n] - desktop.rgba[n]) > 2 ? 1u : 0u;
        EXPECT_LT(off, small.rgba.size() / 1000);
    }
}

TEST(GridOnData, ItsProgramIsBuiltAtStartOrRefusedLater) {
    const auto with = design_of(Shown::data_with_grid, design::DataTechnique::prism);
    const auto without = design_of(Shown::data, design::DataTechnique::prism);
    {
        Shows shows(without);
        EXPECT_FALSE(shows.display().set_design(with));
        EXPECT_TRUE(shows.display().set_design(without));
    }
    test_support::HillsPicture changed;
    {
        Shows shows(with);
        EXPECT_TRUE(shows.display().set_design(without));
        changed = shows.from(view_from(kAbove));
        EXPECT_TRUE(shows.display().set_design(with));
    }
    const auto prism = design::DataTechnique::prism;
    EXPECT_EQ(apart(inks_over_zone(picture_of(Shown::ground, prism, kAbove), changed)).lines, 0) << "and has no lines meanwhile";
}

TEST(GridOnData, OneEffectIsForGroundAndData) {
    const auto with = design_of(Shown::data_with_grid, design::DataTechnique::prism);
    EXPECT_TRUE(effects::asked_effects(with).has(effects::Effect::surface_grid));
    const design::DesignSettings bare = effects::without_effect(with, effects::Effect::surface_grid);
    EXPECT_FALSE(has_grid_on_data(bare));
    EXPECT_FALSE(bare.data.elements[0].grid) << "isosurfaces have their own lines again";
    effects::DeviceSettings device = test_support::shipped_device("desktop");
    EXPECT_TRUE(has_grid_on_data(effects::possible_design(with, device)));
    device.forbidden.add(effects::Effect::surface_grid);
    EXPECT_FALSE(has_grid_on_data(effects::possible_design(with, device)));
}

}  // namespace
}  // namespace tedavis::display::test_grid_on_data
