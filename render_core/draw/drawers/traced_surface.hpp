/// The surface of traced ground where rays hit it: the height, interpolated over the triangle that was hit; sea or unknown; and
/// the corners' normals with their barycentric coordinates. Pure; any thread.
#pragma once

#include <cstring>

#include "render_core/draw/traced_ground.hpp"
#include "render_core/raytrace/view_kernels.hpp"

namespace tedavis::draw {

/// Values of a triangle's three corners side by side; the fourth is 0.
using CornerFloats = float __attribute__((vector_size(16)));
using CornerWords = std::int32_t __attribute__((vector_size(16)));

[[nodiscard]] inline float sum_of(const CornerFloats& of) { return of[0] + of[1] + of[2]; }

struct TracedPoint {
    std::uint32_t column = 0, row = 0;  ///< of the cell
    float u = 0, v = 0;                 ///< in the cell, 0..1 towards higher columns and rows
    CornerFloats shares{};              ///< barycentric coordinates in the triangle
    CornerWords looks{};                ///< of the corners: normals in the lower three bytes, times 127; the class in the highest
    float height_m = 0;                 ///< above MSL
    /// A corner of the triangle is sea, and the bilinear weights of the cell's posts that are sea sum to more than 0.5 at this
    /// point.
    bool is_sea = false;
    bool is_unknown = false;  ///< one of the triangle's corners is void

    /// Normals at the corners, ECEF, times 127.
    [[nodiscard]] CornerFloats normals_x() const { return __builtin_convertvector((looks << 24) >> 24, CornerFloats); }
    [[nodiscard]] CornerFloats normals_y() const { return __builtin_convertvector((looks << 16) >> 24, CornerFloats); }
    [[nodiscard]] CornerFloats normals_z() const { return __builtin_convertvector((looks << 8) >> 24, CornerFloats); }
};

class TracedSurface {
public:
    /// Both must outlive the object; `hits` must have `cell`, `u` and `v`.
    TracedSurface(const TracedGround& ground, const raytrace::HitPicture& hits)
        : grid_(ground.heights()), looks_(ground.looks().data()), hits_(hits) {}

    /// Returns the point of a pixel that has a hit; `pixel` counts row by row from the top.
    [[nodiscard]] TracedPoint at(std::size_t pixel) const {
        TracedPoint point;
        const auto cell = static_cast<std::uint32_t>(hits_.cell[pixel]);
        point.row = cell / (grid_.columns - 1);
        point.column = cell - point.row * (grid_.columns - 1);
        point.u = hits_.u[pixel];
        point.v = hits_.v[pixel];
        const std::size_t north = std::size_t{point.row} * grid_.stride + point.column, south = north + grid_.stride;
        // The triangle at the north-west post; else the one at the south-east post, from which the shares are then counted.
        const bool is_upper = point.u + point.v <= 1;
        const std::size_t first = is_upper ? north : south + 1;
        const float of_east = is_upper ? point.u : 1 - point.v, of_south = is_upper ? point.v : 1 - point.u;
        point.shares = CornerFloats{1 - of_east - of_south, of_east, of_south, 0};
        point.looks = CornerWords{word_of(looks_[first]), word_of(looks_[north + 1]), word_of(looks_[south]), 0};
        point.height_m = sum_of(point.shares * CornerFloats{grid_.posts[first], grid_.posts[north + 1], grid_.posts[south], 0});
        if (((point.looks[0] | point.looks[1] | point.looks[2]) >> 24) != 0) classify(north, south, point);
        return point;
    }

private:
    static std::int32_t word_of(const PostLook& look) {
        static_assert(sizeof look == sizeof(std::int32_t));
        std::int32_t word = 0;
        std::memcpy(&word, &look, sizeof word);
        return word;
    }

    /// Sets is_sea and is_unknown where not all corners are land.
    void classify(std::size_t north, std::size_t south, TracedPoint& point) const {
        using terrain::PostClass;
        const auto has = [&](PostClass what) {
            const auto code = static_cast<std::int32_t>(what);
            return point.looks[0] >> 24 == code || point.looks[1] >> 24 == code || point.looks[2] >> 24 == code;
        };
        const auto sea = [&](std::size_t post) { return looks_[post].post_class == PostClass::sea ? 1.0f : 0.0f; };
        const float u = point.u, v = point.v;
        const float share =
            (1 - v) * ((1 - u) * sea(north) + u * sea(north + 1)) + v * ((1 - u) * sea(south) + u * sea(south + 1));
        point.is_sea = has(PostClass::sea) && share > 0.5f;
        point.is_unknown = has(PostClass::void_);
    }

    const raytrace::HeightGrid<float>& grid_;
    const PostLook* looks_;
    const raytrace::HitPicture& hits_;
};

}  // namespace tedavis::draw
