/// The steepest slopes of a region of insets, together with those of the coarse terrain round it.
#pragma once

#include <string>
#include <vector>

#include "host_sim/terrain_builder/inset_posts.hpp"
#include "host_sim/terrain_builder/slope_map.hpp"

namespace tedavis::host_sim {

class InsetSlopes final : public Steepness {
public:
    /// `plan` is of the fine posts. Reads the slopes known so far from the file at `path`; makes the file where it does not
    /// exist.
    InsetSlopes(const BuildPlan& plan, const SlopeMap& coarse, std::uint32_t shift, const InsetPosts& posts,
                const std::string& path);

    /// Measures the slopes of a block from all its posts. Different blocks may be measured at once, on any thread.
    void measure(const terrain::ChunkKey& block);
    void sync() { file_.sync(); }
    /// `posts` and `margin_posts` are in fine posts.
    [[nodiscard]] double steepest(const terrain::PostRange& posts, std::uint32_t margin_posts) const override;

private:
    const BuildPlan& plan_;
    const SlopeMap& coarse_;
    std::uint32_t shift_;
    const InsetPosts& posts_;
    std::uint32_t columns_, rows_;  ///< chunks of level 0 in the region
    std::vector<float> slope_;
    WorkFile file_;
};

}  // namespace tedavis::host_sim
