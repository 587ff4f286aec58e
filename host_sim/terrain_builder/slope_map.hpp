/// How steep the true surface is at most, by chunks of level 0: with it a sideways shift becomes a height.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "host_sim/terrain_builder/posts_file.hpp"
#include "render_core/base/ports/workers.hpp"

namespace tedavis::host_sim {

class SlopeMap {
public:
    /// From all posts, unit by unit; `unit_done` may throw to stop.
    SlopeMap(const BuildPlan& plan, const PostsFile& posts, base::Workers& workers,
             const std::function<void(std::uint32_t)>& unit_done);

    /// Metres a metre, over a rectangle of posts and `margin_posts` round it. At the ring round a pole also whatever the
    /// heights of the ring differ by counts, over the distance of one row.
    [[nodiscard]] double steepest(const terrain::PostRange& posts, std::uint32_t margin_posts) const;

private:
    std::uint32_t columns_, rows_;
    bool closed_;
    std::vector<float> slope_;
};

}  // namespace tedavis::host_sim
