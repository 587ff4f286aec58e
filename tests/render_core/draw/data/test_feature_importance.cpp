#include "render_core/draw/data/feature_importance.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_feature_importance {
namespace {

TEST(FeatureImportance, GrowsStricterAsTheDetailFalls) {
    host_sim::LayerDraft layer;
    layer.name = "houses";
    host_sim::AttributeDraft height;
    height.name = "height";
    height.of = scene::AttributeOf::feature;
    height.values = {2, 10, 20, std::numeric_limits<float>::quiet_NaN()};
    layer.attributes.push_back(height);
    for (std::size_t n = 0; n < height.values.size(); ++n) layer.points.push_back(test_support::scene_point(46.8, 9.8, 0));
    test_support::ElementOfTest test(layer);
    const auto kept = [&](double detail, const char* attribute = "height") {
        test.element.detail = detail;
        int count = 0;
        for (std::uint32_t n = 0; n < 4; ++n) count += is_unimportant(test.input(), attribute, n) ? 0 : 1;
        return count;
    };
    EXPECT_EQ(kept(1), 4);
    EXPECT_EQ(kept(0.5), 3) << "below 8 m";
    EXPECT_EQ(kept(0), 2) << "below 16 m; one is unknown, and stays";
    EXPECT_EQ(kept(0, "width"), 4) << "nothing says what is important";
}

}  // namespace
}  // namespace tedavis::draw::test_feature_importance
