/// Features of a test whose labels are decided in a screen of their own.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "render_core/draw/data/label_planner.hpp"

namespace tedavis::test_support {

inline constexpr draw::Rect kLabelScreen{0, 0, 1000, 700};
inline constexpr float kLabelText_px = 16;

/// A feature of a test: where its sign would stand, and what it is worth.
struct LabelFeature {
    draw::LabelKey key = 0;
    double interest = 0;
    draw::Point at;
    float name_px = 80;
    bool is_known = true;
    std::uint8_t stems = draw::kSignStems;
};

inline draw::SignBox box_of(const LabelFeature& feature) {
    constexpr float kHalf = 8, kFoot = 20;
    return {{feature.at.x, feature.at.y - kFoot}, kHalf, 4, kFoot, feature.name_px, feature.name_px > 0 ? 15.0f : 0.0f};
}

class ShapesOfFeatures final : public draw::LabelShapes {
public:
    explicit ShapesOfFeatures(const std::vector<LabelFeature>& features) {
        for (const LabelFeature& feature : features) by_key_[feature.key] = feature;
    }
    draw::LabelShape shape(draw::LabelKey key) override {
        const LabelFeature& feature = by_key_.at(key);
        return {box_of(feature), feature.is_known, feature.stems};
    }

private:
    std::map<draw::LabelKey, LabelFeature> by_key_;
};

class PlannedLabels {
public:
    explicit PlannedLabels(const std::vector<draw::LabelGroup>& groups = {draw::LabelGroup{}})
        : groups_(groups), block_(1u << 16) {
        base::Arena arena(block_.data(), block_.size());
        EXPECT_TRUE(planner.start(arena));
    }
    void decide(const std::vector<LabelFeature>& features) { decide(features, ++interval_); }
    void decide(const std::vector<LabelFeature>& features, std::int64_t interval) {
        interval_ = interval;
        planner.begin({interval, kLabelScreen, kLabelText_px}, settings);
        for (const draw::LabelGroup& group : groups_) EXPECT_TRUE(planner.add_group(group));
        for (const LabelFeature& feature : features) planner.offer(feature.key, feature.interest, feature.interest);
        ShapesOfFeatures shapes(features);
        planner.settle(shapes);
    }
    [[nodiscard]] draw::Label of(draw::LabelKey key) const {
        for (const draw::Label& label : planner.labels())
            if (label.key == key) return label;
        return {};
    }

    draw::LabelPlanner planner;
    design::LabelSettings settings;

private:
    std::vector<draw::LabelGroup> groups_;
    std::vector<unsigned char> block_;
    std::int64_t interval_ = 0;
};

}  // namespace tedavis::test_support
