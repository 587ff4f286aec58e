#include "render_core/draw/data/feature_sight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_feature_sight {
namespace {

using test_support::ElementOfTest;
using test_support::scene_point;

terrain::View view_from(double heading_deg, double pitch_deg) {
    const double latitude = base::radians(46.8), longitude = base::radians(9.8);
    return test_support::free_view(earth::to_ecef({latitude, longitude, {3000}}),
                                   earth::body_axes(latitude, longitude, base::radians(heading_deg), base::radians(pitch_deg), 0),
                                   640, 480, 10);
}

host_sim::LayerDraft way(const std::vector<scene::ScenePoint>& points) {
    host_sim::LayerDraft layer;
    layer.name = "way";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::trajectory;
    layer.height_datum = scene::HeightDatum::ellipsoid;
    layer.points = points;
    layer.starts = {0, static_cast<std::uint32_t>(points.size())};
    return layer;
}

/// Whether a point lies within the picture, by its place in ECEF alone.
bool is_seen(const terrain::View& view, const glm::dvec3& place) {
    const glm::dvec3 at = place - view.eye;
    const double ahead = glm::dot(at, view.forward);
    return ahead > 0 && std::fabs(glm::dot(at, view.right)) <= ahead * view.half_width_tangent() &&
           std::fabs(glm::dot(at, view.down)) <= ahead * view.half_height_tangent();
}

TEST(FeatureSight, NothingThatIsSeenIsEverOutOfView) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> off(-1.2, 1.2), height(0, 9000), heading(0, 360);
    int out = 0, seen = 0;
    for (int n = 0; n < 4000; ++n) {
        const double latitude = 46.8 + off(random), longitude = 9.8 + off(random), height_m = height(random);
        const terrain::View view = view_from(heading(random), -10);
        host_sim::LayerDraft layer = way({scene_point(latitude, longitude, static_cast<float>(height_m)),
                                          scene_point(latitude + 0.01, longitude, static_cast<float>(height_m))});
        ElementOfTest test(layer);
        test.element.technique = design::DataTechnique::ribbon;
        const bool is_out = count_out_of_view(test.input(), view) == 1;
        bool any_is_seen = false;
        for (const scene::ScenePoint& point : layer.points)
            any_is_seen = any_is_seen || is_seen(view, earth::to_ecef({point.latitude_rad, point.longitude_rad, {height_m}}));
        EXPECT_FALSE(is_out && any_is_seen) << latitude << " " << longitude << " " << height_m;
        out += is_out ? 1 : 0;
        seen += any_is_seen ? 1 : 0;
    }
    EXPECT_GT(out, 2400) << "control: nearly all that is not seen is out of view";
    EXPECT_GT(seen, 300);
}

/// Maps are seen from thousands of kilometres above, by narrow fields of view.
TEST(FeatureSight, OnMapsWhatIsSeenIsInViewAndTheRestIsNot) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> off(-0.25, 0.25), height(0, 4000);
    for (const double range_m : {2500.0, 6000.0, 12'000.0}) {
        const double latitude = base::radians(46.8), longitude = base::radians(9.8), eye_m = 1000 * range_m;
        terrain::View view = test_support::free_view(
            earth::to_ecef({latitude, longitude, {eye_m}}),
            earth::body_axes(latitude, longitude, base::radians(30), base::radians(-90), 0), 640, 480, 10);
        view.focal_px = 240 * eye_m / range_m;
        int out = 0, seen = 0;
        for (int n = 0; n < 1000; ++n) {
            const double at_latitude = 46.8 + off(random), at_longitude = 9.8 + off(random), height_m = height(random);
            const host_sim::LayerDraft layer =
                way({scene_point(at_latitude, at_longitude, static_cast<float>(height_m)),
                     scene_point(at_latitude + 0.002, at_longitude, static_cast<float>(height_m))});
            ElementOfTest test(layer);
            test.element.technique = design::DataTechnique::ribbon;
            const bool is_out = count_out_of_view(test.input(), view) == 1;
            bool any_is_seen = false;
            for (const scene::ScenePoint& point : layer.points)
                any_is_seen = any_is_seen || is_seen(view, earth::to_ecef({point.latitude_rad, point.longitude_rad, {height_m}}));
            EXPECT_FALSE(is_out && any_is_seen) << range_m << ": " << at_latitude << " " << at_longitude;
            out += is_out ? 1 : 0;
            seen += any_is_seen ? 1 : 0;
        }
        EXPECT_GT(seen, 5) << range_m;
        EXPECT_GT(out, 0.9 * (1000 - seen)) << "control, " << range_m;
    }
}

TEST(FeatureSight, AWayAcrossTheViewIsInItThoughItsEndsAreNot) {
    ElementOfTest test(way({scene_point(46.9, 9.5, 3000), scene_point(46.9, 10.1, 3000)}));
    test.element.technique = design::DataTechnique::ribbon;
    EXPECT_EQ(count_out_of_view(test.input(), view_from(0, 0)), 0u);
    EXPECT_EQ(count_out_of_view(test.input(), view_from(180, 0)), 1u);
    test.element.technique = design::DataTechnique::tube;
    EXPECT_EQ(count_out_of_view(test.input(), view_from(180, 0)), 2u) << "tubes count points";
}

TEST(FeatureSight, CellsAreWhereTheyHaveGone) {
    host_sim::LayerDraft layer = test_support::small_areas();
    layer.points.clear();
    for (const double north : {0.0, 0.01, 0.01}) layer.points.push_back(scene_point(46.7 + north, 9.8 + 0.5 * north, 0));
    layer.starts = {0, 3};
    layer.attributes.clear();
    layer.names.clear();
    layer.role = scene::LayerRole::storm_cell;
    layer.data_time_ns = 1'000'000'000'000;
    for (const auto& [name, value] : {std::pair<const char*, float>{"speed", 20}, {"toward", 0}}) {
        host_sim::AttributeDraft attribute;
        attribute.name = name;
        attribute.of = scene::AttributeOf::feature;
        attribute.values = {value};
        layer.attributes.push_back(attribute);
    }
    ElementOfTest test(layer);
    test.element.technique = design::DataTechnique::prism;
    test.has_date = true;
    test.time_ns = layer.data_time_ns;
    EXPECT_EQ(count_out_of_view(test.input(), view_from(0, 0)), 1u) << "behind";
    test.time_ns += 1800 * 1'000'000'000LL;  // 36 km
    EXPECT_EQ(count_out_of_view(test.input(), view_from(0, 0)), 0u);
}

}  // namespace
}  // namespace tedavis::draw::test_feature_sight
