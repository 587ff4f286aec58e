/// A saliency model with memory of its own, and maps as values.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "render_core/perception/saliency_model.hpp"
#include "tests/support/perception/synthetic_picture.hpp"

namespace tedavis::test_support {

struct HeldMap {
    std::vector<float> values;
    int width = 0, height = 0, level = 0;
    bool has_salient = false;

    [[nodiscard]] float at(int x, int y) const { return values[perception::pixels_of(width, y) + static_cast<std::size_t>(x)]; }
    /// Column and row of the most salient place.
    [[nodiscard]] std::pair<int, int> most() const {
        const auto place = static_cast<int>(std::max_element(values.begin(), values.end()) - values.begin());
        return {place % width, place / width};
    }
};

class HeldSaliency {
public:
    HeldSaliency(int most_width, int most_height, int least_start_level = 0)
        : block_(perception::SaliencyModel::bytes(most_width, most_height, least_start_level)) {
        base::Arena arena(block_.data(), block_.size());
        EXPECT_TRUE(model.start(arena, most_width, most_height, least_start_level));
    }
    HeldMap of(const perception::PictureView& picture, int start_level = 0,
               perception::SaliencyScale scale = perception::SaliencyScale::per_picture) {
        EXPECT_TRUE(model.look(picture, start_level));
        const perception::SaliencyMap map = model.map(scale);
        return {{map.values.begin(), map.values.end()}, map.width, map.height, map.level, map.has_salient};
    }
    perception::SaliencyModel model;

private:
    std::vector<unsigned char> block_;
};

inline HeldMap saliency_of(const SyntheticPicture& picture, int start_level = 0,
                           perception::SaliencyScale scale = perception::SaliencyScale::per_picture) {
    return HeldSaliency(picture.width, picture.height, start_level).of(picture.view(), start_level, scale);
}

}  // namespace tedavis::test_support
