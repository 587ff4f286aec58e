#include "host_sim/reports/height_findings.hpp"

#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kMaxVoid = 0.5;
/// Of a region that large even a plain has more; one height alone is a sea or a lake.
constexpr double kMinRelief_m = 1.5;
constexpr std::uint64_t kFewestPosts = 10'000;
constexpr double kMaxImpossible = 0.01;

}  // namespace

HeightCounts height_counts(const terrain::FileHeader& header) {
    return {std::uint64_t{header.columns} * header.rows, header.void_posts, double{header.min_height_m},
            double{header.max_height_m}, false};
}

Findings height_findings(const std::string& file, const HeightCounts& counts) {
    Findings findings;
    const double void_share = static_cast<double>(counts.void_posts) / static_cast<double>(counts.posts);
    if (void_share > kMaxVoid)
        findings.push_back({"heights.void",
                            file + ": " + decimal(100 * void_share, 0) + " % of " + counted(counts.posts, "post") +
                                " have no height from -500 to 9000 m (void)",
                            counts.void_posts});
    if (counts.void_posts >= counts.posts) return findings;
    const double relief_m = counts.highest_m - counts.lowest_m;
    if (relief_m > 0 && relief_m < kMinRelief_m && counts.posts >= kFewestPosts)
        findings.push_back({"heights.no_relief",
                            file + ": all heights of " + counted(counts.posts, "post") + " lie from " +
                                decimal(counts.lowest_m, 2) + " to " + decimal(counts.highest_m, 2) +
                                " m, which is hardly a ground; check what the file holds and in which unit",
                            counts.posts});
    if (counts.is_eight_bit)
        findings.push_back({"heights.eight_bit",
                            file + ": has numbers of 8 bits, as grey pictures have, which are taken for heights of " +
                                decimal(counts.lowest_m, 0) + " to " + decimal(counts.highest_m, 0) + " m",
                            counts.posts});
    return findings;
}

Findings value_findings(const std::string& file, const RasterOptions& options) {
    const ImpossibleValues found = impossible_values(open_raster_source(file, options), options);
    if (found.share < kMaxImpossible) return {};
    return {{"heights.impossible",
             file + ": about " + decimal(100 * found.share, 0) + " % of its posts have values that no ground has, from " +
                 decimal(found.lowest_m, 0) + " to " + decimal(found.highest_m, 0) +
                 " m, and that it does not declare as void; check whether it holds heights, or name its void value with --void",
             1}};
}

}  // namespace tedavis::host_sim
