/// Pixels of neighbouring columns that are swept, between the lanes and the picture.
///
/// Columns of a sweep stand at different rows, and their pixels far apart in the picture's memory, often in the same few sets of
/// a cache. Here they are near each other, and go to the picture row by row when all columns are past them. A column that is too
/// far ahead of the others waits.
#pragma once

#include <algorithm>
#include <limits>

#include "render_core/raytrace/kernel/march.hpp"
#include "render_core/raytrace/view_kernels.hpp"

namespace tedavis::raytrace {

template <class V, class Height>
class SweptRows {
public:
    using Mask = typename V::Mask;
    using Int = typename V::Int;

    /// Columns [left, left + columns) of the picture; their rays are counted from the lowest row where `is_upwards`.
    SweptRows(const ViewJob<Height>& job, std::uint32_t left, std::uint32_t columns, bool is_upwards)
        : job_(job), left_(left), columns_(columns), is_upwards_(is_upwards) {
        std::fill_n(t_, kPixels, std::numeric_limits<float>::infinity());
        std::fill_n(cell_, kPixels, HitPicture::kNoCell);
    }

    /// Those of `asks` whose next pixels there is room for; rows that all of `runs` are past make room.
    Mask with_room(Mask asks, Mask runs, Int place) {
        const Mask waits = asks & (place >= Int(first_ + kRows));
        if (!V::any(waits)) return asks;
        give_up_to(least_of(runs, place));
        return asks & (place < Int(first_ + kRows));
    }
    /// What the rays at `place` have met.
    TEDAVIS_LANES_INLINE void keep(SweptRows& rows, Int place, Int lane, const RayLanes<V>& ray, const March<V>& m,
                                   std::int32_t columns) {
        const HitPicture& picture = rows.job_.picture;
        const Int to = (place & Int(kRows - 1)) * Int(V::kCount) + lane;
        V::scatter(rows.t_, to, m.met_t, m.is_met);
        if (!picture.cell.empty()) V::scatter(rows.cell_, to, m.met_row * Int(columns) + m.met_column, m.is_met);
        if (!picture.u.empty()) {
            V::scatter(rows.u_, to, RayAxis<V>::place_in(ray.x, m.met_column, m.met_t), m.is_met);
            V::scatter(rows.v_, to, RayAxis<V>::place_in(ray.y, m.met_row, m.met_t), m.is_met);
        }
        if (!V::any(m.is_beyond)) return;
        V::scatter(rows.t_, to, typename V::Float(kAloneAgain), m.is_beyond);
        rows.has_alone_ = true;
    }
    /// All that is left; from `place` on no ray has met anything.
    void finish(Int place) {
        const auto end = static_cast<std::int32_t>(job_.height);
        std::int32_t places[V::kCount] = {}, most = 0;
        V::store(places, place);
        for (std::uint32_t n = 0; n < V::kCount && n < columns_; ++n) most = std::max(most, places[n]);
        give_up_to(most);
        const std::uint32_t from = is_upwards_ ? 0 : static_cast<std::uint32_t>(first_);
        const std::uint32_t until = static_cast<std::uint32_t>(is_upwards_ ? end - first_ : end);
        clear_pixels(job_.picture, job_.width, left_, from, left_ + columns_, until);
    }

private:
    static constexpr std::int32_t kRows = 128, kPixels = kRows * V::kCount;
    static constexpr float kAloneAgain = -1;  ///< a t: what this ray meets is found by trace_pixel()

    static std::int32_t least_of(Mask runs, Int place) {
        std::int32_t places[V::kCount], least = std::numeric_limits<std::int32_t>::max();
        V::store(places, place);
        for (std::uint32_t left = V::bits(runs); left != 0; left &= left - 1)
            least = std::min(least, places[__builtin_ctz(left)]);
        return least;
    }
    void give_up_to(std::int32_t place) {
        for (; first_ < place; ++first_) give_row();
    }
    void give_row() {
        const std::size_t at = static_cast<std::size_t>(first_ & (kRows - 1)) * V::kCount;
        const auto y = static_cast<std::uint32_t>(is_upwards_ ? static_cast<std::int32_t>(job_.height) - 1 - first_ : first_);
        const std::size_t to = std::size_t{y} * job_.width + left_;
        const HitPicture& picture = job_.picture;
        copy(t_ + at, picture.t, to);
        copy(cell_ + at, picture.cell, to);
        if (!picture.side.empty())
            for (std::uint32_t n = 0; n < columns_; ++n)
                picture.side.data()[to + n] =
                    t_[at + n] < std::numeric_limits<float>::infinity() ? HitSide::above : HitSide::none;
        copy(u_ + at, picture.u, to);
        copy(v_ + at, picture.v, to);
        if (has_alone_)
            for (std::uint32_t n = 0; n < columns_; ++n)
                if (t_[at + n] == kAloneAgain) trace_pixel(job_, left_ + n, y);
        std::fill_n(t_ + at, V::kCount, std::numeric_limits<float>::infinity());
        std::fill_n(cell_ + at, V::kCount, HitPicture::kNoCell);
    }
    template <class Value>
    void copy(const Value* row, const base::Span<Value>& pixels, std::size_t to) const {
        if (pixels.empty()) return;
        if (columns_ == V::kCount)
            V::store(pixels.data() + to, V::load(row));
        else
            std::copy_n(row, columns_, pixels.data() + to);
    }

    const ViewJob<Height>& job_;
    const std::uint32_t left_, columns_;
    const bool is_upwards_;
    std::int32_t first_ = 0;  ///< of the rows that are here
    bool has_alone_ = false;
    alignas(64) float t_[kPixels];
    alignas(64) std::int32_t cell_[kPixels];
    alignas(64) float u_[kPixels], v_[kPixels];
};

}  // namespace tedavis::raytrace
