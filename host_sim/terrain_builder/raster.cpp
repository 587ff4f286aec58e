#include "host_sim/terrain_builder/raster.hpp"

#include <algorithm>

#include "host_sim/terrain_builder/post_source.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint64_t kMaxPosts = 1u << 30;

}  // namespace

Raster load_rasters(const std::vector<std::string>& files, const RasterOptions& options) {
    PostSource posts(files, options);
    const std::uint64_t count = std::uint64_t{posts.grid().columns} * posts.grid().rows;
    if (count > kMaxPosts)
        throw UserError(files.front() + ": more than 2^30 posts do not fit the memory; choose parts of it with --bounds");
    Raster raster;
    static_cast<PostGrid&>(raster) = posts.grid();
    raster.resampled = posts.resampled();
    raster.notes = posts.notes();
    raster.height_m.resize(count);
    raster.post_class.resize(count);
    posts.read(0, 0, raster.columns, raster.rows, raster.height_m, raster.post_class);
    raster.void_posts =
        static_cast<std::uint64_t>(std::count(raster.post_class.begin(), raster.post_class.end(), terrain::PostClass::void_));
    if (raster.void_posts == count)
        throw UserError(files.front() + ": no post has a height from -500 to 9000 m; check the file or its void value");
    return raster;
}

}  // namespace tedavis::host_sim
