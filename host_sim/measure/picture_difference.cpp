#include "host_sim/measure/picture_difference.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/measure/lab_picture.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

bool is_equal(const design::Lab& a, const design::Lab& b) { return a.lightness == b.lightness && a.a == b.a && a.b == b.b; }

}  // namespace

PictureDifference picture_difference(const RgbaView& first, const RgbaView& second) {
    if (first.width != second.width || first.height != second.height)
        throw UserError("pictures of different sizes cannot be compared; draw both in one size");
    const LabPicture a(first), b(second);
    PictureDifference sum;
    for (std::uint32_t y = 0; y < first.height; ++y)
        for (std::uint32_t x = 0; x < first.width; ++x) {
            const double difference = is_equal(a.at(x, y), b.at(x, y)) ? 0 : color_difference(a.at(x, y), b.at(x, y));
            sum.mean += difference;
            sum.largest = std::max(sum.largest, difference);
            sum.edges += std::abs(a.gradient(x, y) - b.gradient(x, y));
        }
    const double pixels = std::max(static_cast<double>(first.width) * first.height, 1.0);
    return {sum.mean / pixels, sum.largest, sum.edges / pixels};
}

}  // namespace tedavis::host_sim
