#include "host_sim/commands/check_raster.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "host_sim/quiet_gdal.hpp"
#include "host_sim/reports/height_findings.hpp"
#include "host_sim/terrain_builder/post_source.hpp"
#include "host_sim/terrain_builder/raster_file.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

void count(const std::vector<float>& heights_m, const std::vector<terrain::PostClass>& classes, std::size_t posts,
           HeightCounts& counts) {
    for (std::size_t n = 0; n < posts; ++n) {
        if (classes[n] == terrain::PostClass::void_) {
            ++counts.void_posts;
            continue;
        }
        counts.lowest_m = std::min(counts.lowest_m, static_cast<double>(heights_m[n]));
        counts.highest_m = std::max(counts.highest_m, static_cast<double>(heights_m[n]));
    }
}

HeightCounts counts_of(PostSource& source) {
    constexpr std::uint32_t kRowsAtOnce = 64;
    HeightCounts counts;
    counts.posts = std::uint64_t{source.grid().columns} * source.grid().rows;
    counts.lowest_m = std::numeric_limits<double>::infinity();
    counts.highest_m = -counts.lowest_m;
    std::vector<float> heights_m(std::size_t{source.grid().columns} * kRowsAtOnce);
    std::vector<terrain::PostClass> classes(heights_m.size());
    for (std::uint32_t j = 0; j < source.grid().rows; j += kRowsAtOnce) {
        const std::uint32_t rows = std::min(kRowsAtOnce, source.grid().rows - j);
        const std::size_t posts = std::size_t{source.grid().columns} * rows;
        source.read(0, j, source.grid().columns, rows, {heights_m.data(), posts}, {classes.data(), posts});
        count(heights_m, classes, posts, counts);
    }
    return counts;
}

bool has_bytes(const std::string& path) {
    const QuietGdal quiet;
    return open_raster_file(path)->GetRasterBand(1)->GetRasterDataType() == GDT_Byte;
}

}  // namespace

CheckedFile check_raster(const std::string& path) {
    PostSource source({path}, {});
    HeightCounts counts = counts_of(source);
    counts.is_eight_bit = has_bytes(path);
    if (counts.void_posts == counts.posts)
        throw UserError(path + ": no post has a height from -500 to 9000 m; check the file or its void value");
    Findings findings = height_findings(path, counts);
    append(findings, value_findings(path, {}));
    return {"a height raster of " + std::to_string(source.grid().columns) + " x " + std::to_string(source.grid().rows) +
                " posts, " + std::to_string(counts.void_posts) + " of them void",
            findings};
}

}  // namespace tedavis::host_sim
