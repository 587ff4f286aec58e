/// How steep the true surface is at most, by chunks of level 0: with it a sideways shift becomes a height.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "host_sim/terrain_builder/posts_file.hpp"

namespace tedavis::host_sim {

/// Of the steepest triangle in a rectangle of the window's posts; between valid ones.
[[nodiscard]] float steepest_slope(const BuildPlan& plan, const LatticeWindow& window, const terrain::PostRange& posts);

class SlopeMap final : public Steepness {
public:
    /// Reads what is known already from the file at `path`; makes it where it does not exist.
    SlopeMap(const BuildPlan& plan, const std::string& path);

    /// From all posts of a unit. Any thread, different units at once.
    void measure(const PostsFile& posts, std::uint32_t unit);
    void sync() { file_.sync(); }

    /// At the ring round a pole also whatever the heights of the ring differ by counts, over the distance of one row.
    [[nodiscard]] double steepest(const terrain::PostRange& posts, std::uint32_t margin_posts) const override;

private:
    const BuildPlan& plan_;
    std::uint32_t columns_, rows_;
    bool closed_;
    std::vector<float> slope_;
    WorkFile file_;
};

}  // namespace tedavis::host_sim
