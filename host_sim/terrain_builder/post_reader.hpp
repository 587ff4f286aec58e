/// Where the posts of a terrain come from: any lattice that can be read by windows.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "host_sim/terrain_builder/raster_options.hpp"
#include "render_core/base/span.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::host_sim {

/// Degrees; row 0 in the north. Longitudes grow beyond 180 where the lattice crosses the antimeridian.
struct PostGrid {
    std::uint32_t columns = 0, rows = 0;
    double west_deg = 0, north_deg = 0, step_lon_deg = 0, step_lat_deg = 0;
    std::string source;  ///< names of the files
    VerticalDatum vertical_datum = VerticalDatum::egm96;
};

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
