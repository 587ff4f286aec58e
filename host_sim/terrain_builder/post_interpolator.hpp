/// Interpolates the heights of one raster, in any projection, at the posts of a lattice of longitude and latitude.
///
/// A post has a height if the raster's nearest post has one; it is interpolated bilinearly between the surrounding posts that
/// have one. Each place is transformed exactly, and a post's height has equal bits in every window.
#pragma once

#include <ogr_spatialref.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "host_sim/terrain_builder/raster_mosaic.hpp"

namespace tedavis::host_sim {

class PostInterpolator {
public:
    /// Copies the needed data of source and lattice. Throws UserError where no transformation is known.
    PostInterpolator(const RasterSource& source, const GeoLattice& lattice);

    /// Positions of the posts of one block on the raster.
    struct Block {
        std::vector<double> column, row;  ///< 0 at the centre of the first pixel; NaN where the raster has no such place
        PostWindow pixels;                ///< all pixels that the block's posts need; no columns where there are none
    };
    /// False if no post of the cell of kBlock by kBlock posts at i, j can have a height. Fast.
    [[nodiscard]] bool reaches(std::int64_t i, std::int64_t j) const;
    /// Locates the posts first_i.., first_j.. of the lattice; a block must lie within one cell of kBlock by kBlock posts.
    [[nodiscard]] Block locate(std::int64_t first_i, std::int64_t first_j, std::int64_t columns, std::int64_t rows) const;
    /// `heights`: those of block.pixels. NaN where there is none.
    [[nodiscard]] float height_at(const Block& block, std::size_t post, const std::vector<float>& heights) const;

    static constexpr std::int64_t kBlock = 64;

private:
    void locate_plain(Block& block, std::int64_t first_i, std::int64_t first_j, std::int64_t columns, std::int64_t rows) const;
    void locate_row(Block& block, std::int64_t first_i, std::int64_t j, std::int64_t columns) const;
    void store(Block& block, double column, double row) const;
    void bound(Block& block) const;
    void plan_reach(const RasterSource& source);

    GeoLattice lattice_;
    int columns_, rows_;
    std::array<double, 6> transform_{}, to_pixel_{};
    double first_i_ = 0, first_j_ = 0, last_i_ = 0, last_j_ = 0;  ///< posts that the raster can reach
    double turn_ = 0, middle_ = 0;  ///< of geographic systems: a full turn, and the raster's middle meridian
    std::unique_ptr<OGRCoordinateTransformation> change_;  ///< none for plain sources
};

}  // namespace tedavis::host_sim
