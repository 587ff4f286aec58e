/// Interface to the posts of a terrain: any lattice that can be read by windows.
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
    /// Reads the posts i..i+columns-1, j..j+rows-1, row by row, heights in metres above MSL; the height of a void post is
    /// undefined. A post has the same bits in every window. Throws UserError.
    virtual void read(std::uint32_t i, std::uint32_t j, std::uint32_t columns, std::uint32_t rows, base::Span<float> heights_m,
                      base::Span<terrain::PostClass> classes) = 0;
};

/// Makes a reader, one for each thread; all read the same posts.
using PostReaderFactory = std::function<std::unique_ptr<PostReader>()>;

}  // namespace tedavis::host_sim
