/// The first stage of a build: writes every post of the sources once to the posts file, and makes the closing column and the pole
/// rows.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "host_sim/terrain_builder/idle_pool.hpp"
#include "host_sim/terrain_builder/posts_file.hpp"

namespace tedavis::host_sim {

struct PostStatistics {
    float min_height_m = std::numeric_limits<float>::max();  ///< of valid posts
    float max_height_m = std::numeric_limits<float>::lowest();
    std::uint64_t valid_posts = 0, void_posts = 0;

    void include(const PostStatistics& other);
    /// The range of heights only.
    void include_heights(const PostStatistics& other);
    void include(base::Span<const float> heights_m, base::Span<const terrain::PostClass> classes);
};

/// Divides the source into blocks, band by band, one per task.
class ImportBlocks {
public:
    explicit ImportBlocks(const BuildPlan& plan);

    struct Block {
        std::uint32_t i, j, columns, rows;  ///< of the source
    };
    [[nodiscard]] std::uint32_t count() const { return across_ * down_; }
    [[nodiscard]] Block at(std::uint32_t index) const;

private:
    std::uint32_t columns_, rows_, block_rows_, across_, down_;
};

class PostImport {
public:
    PostImport(const BuildPlan& plan, const PostReaderFactory& open, PostsFile& posts)
        : plan_(plan), blocks_(plan), open_(open), posts_(posts) {}

    [[nodiscard]] std::uint32_t block_count() const { return blocks_.count(); }
    /// Imports a block and returns its statistics. Different blocks may be imported at once, on any thread.
    [[nodiscard]] PostStatistics import(std::uint32_t block);

private:
    void close_columns(const ImportBlocks::Block& block, const std::vector<float>& heights_m,
                       const std::vector<terrain::PostClass>& classes);

    const BuildPlan& plan_;
    const ImportBlocks blocks_;
    const PostReaderFactory& open_;
    PostsFile& posts_;
    IdlePool<PostReader> readers_;
};

/// Fills the pole rows. A pole row has one height: the mean of the valid posts of the neighbouring row, or of its own where the
/// source has it.
void make_pole_rows(const BuildPlan& plan, PostsFile& posts);

}  // namespace tedavis::host_sim
