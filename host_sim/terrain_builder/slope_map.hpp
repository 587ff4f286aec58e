/// Upper bounds of the true surface's slope by chunks of level 0, by which a horizontal displacement is converted to a height
/// error.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "host_sim/terrain_builder/posts_file.hpp"

namespace tedavis::host_sim {

/// Returns the slope of the steepest triangle of valid posts in a rectangle of the window, metres per metre.
[[nodiscard]] float steepest_slope(const BuildPlan& plan, const LatticeWindow& window, const terrain::PostRange& posts);

class SlopeMap final : public Steepness {
public:
    /// Reads the slopes known so far from the file at `path`; makes the file where it does not exist.
    SlopeMap(const BuildPlan& plan, const std::string& path);

    /// Measures the slopes of a unit from all its posts. Different units may be measured at once, on any thread.
    void measure(const PostsFile& posts, std::uint32_t unit);
    void sync() { file_.sync(); }

    /// At the ring around a pole, the range of the ring's heights over the distance of one row is included.
    [[nodiscard]] double steepest(const terrain::PostRange& posts, std::uint32_t margin_posts) const override;

private:
    const BuildPlan& plan_;
    std::uint32_t columns_, rows_;
    bool closed_;
    std::vector<float> slope_;
    WorkFile file_;
};

}  // namespace tedavis::host_sim
