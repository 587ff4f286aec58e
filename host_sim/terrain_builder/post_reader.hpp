/// Where the posts of a terrain come from: any lattice that can be read by windows.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "host_sim/terrain_builder/post_grid.hpp"
#include "render_core/base/span.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::host_sim {

class PostReader {
public:
    virtual ~PostReader() = default;
    [[nodiscard]] virtual const PostGrid& grid() const = 0;
    /// Posts i..i+columns-1, j..j+rows-1, row by row, heights above MSL; void posts have any height and their class.
    /// A post has the same bits in every window. Throws UserError.
    virtual void read(std::uint32_t i, std::uint32_t j, std::uint32_t columns, std::uint32_t rows, base::Span<float> heights_m,
                      base::Span<terrain::PostClass> classes) = 0;
};

/// Makes one reader a thread; all of them read the same posts.
using PostReaderFactory = std::function<std::unique_ptr<PostReader>()>;

}  // namespace tedavis::host_sim
