/// The image of a drape at the texels of a terrain's finest drape pages.
///
/// Texels  of level k (of the coarse posts' lattice) stand 2^k / 4 posts apart, on posts where those coincide. The finest level
/// is
///         the coarsest whose texels are no farther apart than the image's pixels, 0 at the finest.
/// Colours bilinear between pixels. Where pixels are finer than half a texel, blocks of them are averaged first, so that nothing
///         falls between the texels. Beyond the image, and where it has no data, coverage is 0.
/// Memory  a page and the pixels that it needs, read in strips; each thread has the file open once.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "host_sim/terrain_builder/idle_pool.hpp"
#include "host_sim/terrain_builder/image_source.hpp"

namespace tedavis::host_sim {

class DrapeSampler {
public:
    /// `plan` is for the coarse posts and must outlive this object. Throws UserError, also where the image does not overlap the
    /// terrain.
    DrapeSampler(const BuildPlan& plan, const DrapeOptions& options);
    ~DrapeSampler();

    [[nodiscard]] std::uint32_t finest_level() const { return finest_level_; }
    /// A place in the image, with whole numbers at the corners of pixels; NaN where the image has no such place.
    struct Pixel {
        double x = std::numeric_limits<double>::quiet_NaN(), y = std::numeric_limits<double>::quiet_NaN();
    };

    /// The page of chunk (i, j) of the finest level. Any thread. Throws UserError where the file is damaged.
    void sample(std::uint32_t i, std::uint32_t j, terrain::DrapePage& page);

private:
    class Reader;
    struct Blocks;
    struct Post {
        double column, row;
    };

    [[nodiscard]] std::vector<Post> probes(const Reader& reader) const;
    void choose_level(const Reader& reader);
    [[nodiscard]] std::vector<Pixel> place_texels(const Reader& reader, std::uint32_t i, std::uint32_t j) const;
    [[nodiscard]] double latitude_deg(double row) const;

    const BuildPlan& plan_;
    const DrapeOptions options_;
    std::uint32_t finest_level_ = 0;
    int block_columns_ = 1, block_rows_ = 1;  ///< size of the blocks of pixels that are averaged first
    IdlePool<Reader> readers_;
};

}  // namespace tedavis::host_sim
