/// An edge detector with memory of its own, and what it finds.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "render_core/perception/edge_density.hpp"
#include "render_core/perception/edge_detector.hpp"
#include "tests/support/perception/synthetic_picture.hpp"

namespace tedavis::test_support {

class HeldEdges {
public:
    HeldEdges(int most_width, int most_height) : block_(perception::EdgeDetector::bytes(most_width, most_height)) {
        base::Arena arena(block_.data(), block_.size());
        EXPECT_TRUE(detector.start(arena, most_width, most_height));
    }
    /// kEdge or 0 a pixel.
    std::vector<std::uint8_t> of(const perception::PictureView& picture, const perception::CannySettings& settings = {}) {
        const base::Span<const std::uint8_t> edges = detector.detect(picture, settings);
        EXPECT_EQ(edges.size(), perception::pixels_of(picture.width, picture.height));
        return {edges.begin(), edges.end()};
    }
    perception::EdgeDetector detector;

private:
    std::vector<unsigned char> block_;
};

inline std::vector<std::uint8_t> edges_of(const SyntheticPicture& picture, const perception::CannySettings& settings = {}) {
    return HeldEdges(picture.width, picture.height).of(picture.view(), settings);
}

inline double density_of(const SyntheticPicture& picture, const perception::CannySettings& settings = {}) {
    const std::vector<std::uint8_t> edges = edges_of(picture, settings);
    return perception::edge_density({edges, picture.width, picture.height});
}

}  // namespace tedavis::test_support
