/// The posts of any rasters, read by windows, without a whole raster in memory.
///
/// The lattice is that of a single geographic file, whose posts are used as they are. Several files, or another projection, are
/// interpolated bilinearly on the finest geographic step of them; where files overlap, the later one is used. Heights are
/// returned in metres above MSL (EGM96) for any unit and datum of the files. Sea is where a height above MSL is exactly zero in
/// the file.
///
/// A post has the same bits in every window. Memory: GDAL's block cache is bounded (for the whole process), and at most
/// kMaxOpenFiles files are open in an object; the rest is a few windows of PostInterpolator::kBlock posts a side. Threads: one
/// object per thread; objects of the same files return equal bits.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/geoid_egm96.hpp"
#include "host_sim/terrain_builder/post_interpolator.hpp"
#include "host_sim/terrain_builder/post_reader.hpp"

namespace tedavis::host_sim {

class PostSource final : public PostReader {
public:
    static constexpr std::uint32_t kMaxPostsOfASide = 1u << 24;
    static constexpr std::int64_t kBlockCacheBytes = 64 << 20;
    static constexpr std::size_t kMaxOpenFiles = 24;

    /// Throws UserError, one sentence, for files that cannot be terrain (see open_raster_source) or cannot be combined.
    PostSource(const std::vector<std::string>& files, const RasterOptions& options);

    /// Its west_deg is within -180 and 180.
    [[nodiscard]] const PostGrid& grid() const override { return grid_; }
    /// Posts are interpolated from other grids.
    [[nodiscard]] bool resampled() const { return !taken_; }
    /// Sentences that the user should read.
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

    /// Posts i..i+columns-1, j..j+rows-1, row 0 in the north, row by row; the window lies inside and each view holds columns
    /// times rows elements. Void posts get NaN. Throws UserError where a file is damaged.
    void read(std::uint32_t i, std::uint32_t j, std::uint32_t columns, std::uint32_t rows, base::Span<float> heights_m,
              base::Span<terrain::PostClass> classes) override;

private:
    struct Window {
        std::uint32_t i, j, columns, rows;
        base::Span<float> heights_m;
        base::Span<terrain::PostClass> classes;

        [[nodiscard]] std::size_t at(std::int64_t a, std::int64_t b) const {
            return static_cast<std::size_t>(b - j) * columns + static_cast<std::size_t>(a - i);
        }
    };

    void open_sources(const std::vector<std::string>& files);
    void plan_taken();
    void plan_interpolated();
    void require_place(const std::string& file) const;
    RasterSource& opened(std::size_t source);
    void put(const Window& window, std::int64_t i, std::int64_t j, float height_m, VerticalDatum datum) const;
    void take(const Window& window);
    void interpolate(const Window& window, std::size_t source);
    void interpolate_block(const Window& window, std::size_t source, std::int64_t cell_i, std::int64_t cell_j);

    RasterOptions options_;
    std::vector<RasterSource> sources_;
    std::vector<PostInterpolator> interpolators_;  ///< of the sources in turn; none where posts are taken as they are
    std::deque<std::size_t> open_;                 ///< sources with an open file, longest unused first
    std::optional<GeoidEgm96> geoid_;              ///< where a source needs it
    bool taken_ = false;
    PostWindow taken_window_;
    PostGrid grid_;
    std::vector<std::string> notes_;
};

}  // namespace tedavis::host_sim
