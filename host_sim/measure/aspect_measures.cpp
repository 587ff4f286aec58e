#include "host_sim/measure/aspect_measures.hpp"

#include <algorithm>
#include <set>

#include "host_sim/measure/lab_picture.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kMinEdge = 0.5;  // L* a pixel

}  // namespace

double edge_density(const RgbaView& picture) {
    const LabPicture lab(picture);
    std::uint64_t edges = 0;
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x) edges += lab.gradient(x, y) > kMinEdge ? 1 : 0;
    return static_cast<double>(edges) / std::max(static_cast<double>(picture.width) * picture.height, 1.0);
}

std::uint32_t distinct_colors(const RgbaView& picture, const RgbaView& without, design::Color ground) {
    if (picture.width != without.width || picture.height != without.height)
        throw UserError("pictures of different sizes cannot be compared; draw both in one size");
    const std::uint8_t bare[] = {ground.red, ground.green, ground.blue};
    std::set<std::uint32_t> colors;
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            const std::uint8_t *p = picture.row(y) + std::size_t{x} * 4, *q = without.row(y) + std::size_t{x} * 4;
            if (std::equal(q, q + 3, bare) && !std::equal(p, p + 3, q))
                colors.insert(std::uint32_t{p[0]} << 16 | std::uint32_t{p[1]} << 8 | p[2]);
        }
    return static_cast<std::uint32_t>(colors.size());
}

}  // namespace tedavis::host_sim
