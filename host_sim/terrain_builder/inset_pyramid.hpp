/// The heights of a terrain with insets at halved resolutions: finer levels are stored in the regions and interpolated elsewhere.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/height_levels.hpp"
#include "host_sim/terrain_builder/height_pyramid.hpp"
#include "host_sim/terrain_builder/inset_posts.hpp"

namespace tedavis::host_sim {

/// Levels 1 to base level - 1 of one region, each from the one below.
class RegionPyramid {
public:
    /// Opens or makes `<path>.level.<m>.*`.
    RegionPyramid(const InsetPosts& posts, const PostsFile& coarse, std::uint32_t base_level, const std::string& path);

    [[nodiscard]] std::uint32_t block_count(std::uint32_t m) const;
    /// The level below must be whole. Any thread, different blocks at once.
    void build_block(std::uint32_t m, std::uint32_t block);
    void sync();
    /// Reads a level below the base level.
    void read(std::uint32_t m, LatticeWindow& window) const;
    /// Whether the middle of a window of a level lies in the region.
    [[nodiscard]] bool holds_middle(std::uint32_t m, const LatticeWindow& window) const;

private:
    [[nodiscard]] const PostWindows& level(std::uint32_t m) const;

    const InsetPosts& posts_;
    std::deque<InsetPosts> levels_;  // from level 1 on
};

class InsetPyramid final : public HeightLevels {
public:
    InsetPyramid(HeightPyramid& coarse, std::uint32_t base_level, const terrain::Lattice& fine)
        : coarse_(coarse), base_level_(base_level), fine_(fine) {}

    void add(const RegionPyramid& region) { regions_.push_back(&region); }

    [[nodiscard]] std::uint32_t level_count() const override { return coarse_.level_count() + base_level_; }
    [[nodiscard]] std::uint32_t columns(std::uint32_t level) const override;
    [[nodiscard]] std::uint32_t rows(std::uint32_t level) const override;
    void read(std::uint32_t level, LatticeWindow& window) const override;

private:
    HeightPyramid& coarse_;
    std::uint32_t base_level_;
    const terrain::Lattice& fine_;
    std::vector<const RegionPyramid*> regions_;
};

}  // namespace tedavis::host_sim
