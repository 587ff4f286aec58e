/// The pixels of a picture that lanes stand for, and the storage of their results.
#pragma once

#include <algorithm>
#include <cstring>

#include "render_core/raytrace/kernel/march.hpp"
#include "render_core/raytrace/view_kernels.hpp"

namespace tedavis::raytrace {

/// A packet of lanes: 4 x 4 pixels of a beam, a part of them, or those of neighbouring beams.
template <class V>
struct PacketShape {
    static constexpr std::uint32_t kRow = V::kCount < 4 ? V::kCount : 4;  ///< pixels of a row in consecutive lanes
    static constexpr std::uint32_t kWidth = V::kCount > 16 ? V::kCount / 4 : kRow;
    static constexpr std::uint32_t kHeight = V::kCount / kWidth;
    static constexpr std::uint32_t column(std::uint32_t lane) { return lane % 4 + lane / 16 * 4; }
    static constexpr std::uint32_t row(std::uint32_t lane) { return lane % 16 / 4; }
    static constexpr std::uint32_t kAll = V::kCount == 32 ? ~0u : (1u << (V::kCount % 32)) - 1;
};

/// Centres of a packet's pixels, relative to its first corner.
template <class V>
struct PacketMiddles {
    alignas(64) float x[V::kCount]{}, y[V::kCount]{};
    constexpr PacketMiddles() {
        for (std::uint32_t n = 0; n < V::kCount; ++n) {
            x[n] = static_cast<float>(PacketShape<V>::column(n)) + 0.5f;
            y[n] = static_cast<float>(PacketShape<V>::row(n)) + 0.5f;
        }
    }
};

/// Stores "no hit" for all rays of a packet.
template <class V, class Height>
void clear_packet(const ViewJob<Height>& job, std::uint32_t left, std::uint32_t top) {
    using Shape = PacketShape<V>;
    clear_pixels(job.picture, job.width, left, top, std::min(left + Shape::kWidth, job.width),
                 std::min(top + Shape::kHeight, job.height));
}

/// One bit for each lane whose pixel is in the picture and requested.
template <class V, class Height>
std::uint32_t asked_pixels(const ViewJob<Height>& job, std::uint32_t left, std::uint32_t top) {
    using Shape = PacketShape<V>;
    if (!job.goes_on && left + Shape::kWidth <= job.width && top + Shape::kHeight <= job.height) return Shape::kAll;
    std::uint32_t asked = 0;
    for (std::uint32_t n = 0; n < V::kCount; ++n) {
        const std::uint32_t x = left + Shape::column(n), y = top + Shape::row(n);
        if (x >= job.width || y >= job.height) continue;
        const bool is_asked = !job.goes_on || job.picture.t[std::size_t{y} * job.width + x] > std::numeric_limits<float>::max();
        asked |= (is_asked ? 1u : 0u) << n;
    }
    return asked;
}

/// Stores the values of all lanes to their pixels.
template <class V, class Value>
void keep_all(const Value* values, Value* pixels, std::uint32_t width) {
    using Shape = PacketShape<V>;
    for (std::uint32_t n = 0; n < V::kCount; n += Shape::kRow)
        std::memcpy(pixels + std::size_t{Shape::row(n)} * width + Shape::column(n), values + n, Shape::kRow * sizeof(Value));
}

template <class V, class Value>
void keep_asked(const Value* values, Value* pixels, std::uint32_t width, std::uint32_t asked) {
    using Shape = PacketShape<V>;
    if (asked == Shape::kAll) return keep_all<V>(values, pixels, width);
    for (; asked != 0; asked &= asked - 1) {
        const auto n = static_cast<std::uint32_t>(__builtin_ctz(asked));
        pixels[std::size_t{Shape::row(n)} * width + Shape::column(n)] = values[n];
    }
}

template <class V, class Height>
void keep_packet(const ViewJob<Height>& job, std::int32_t columns, const RayLanes<V>& ray, const TraversalState<V>& m,
                 std::uint32_t asked, std::uint32_t left, std::uint32_t top) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    using Shape = PacketShape<V>;
    const HitPicture& picture = job.picture;
    const std::size_t to = std::size_t{top} * job.width + left;
    float number[V::kCount];
    std::int32_t cell[V::kCount];
    HitSide side[V::kCount];
    V::store(number, V::select(m.is_hit, m.hit_t, Float(__builtin_inff())));
    keep_asked<V>(number, picture.t.data() + to, job.width, asked);
    V::store(cell, V::select(m.is_hit, m.hit_row * Int(columns) + m.hit_column, Int(HitPicture::kNoCell)));
    if (!picture.cell.empty()) keep_asked<V>(cell, picture.cell.data() + to, job.width, asked);
    for (std::uint32_t n = 0; n < V::kCount; ++n) side[n] = cell[n] < 0 ? HitSide::none : HitSide::above;
    if (!picture.side.empty()) keep_asked<V>(side, picture.side.data() + to, job.width, asked);
    if (!picture.u.empty()) {
        V::store(number, RayAxis<V>::place_in(ray.x, m.hit_column, m.hit_t));
        keep_asked<V>(number, picture.u.data() + to, job.width, asked);
        V::store(number, RayAxis<V>::place_in(ray.y, m.hit_row, m.hit_t));
        keep_asked<V>(number, picture.v.data() + to, job.width, asked);
    }
    for (std::uint32_t beyond = V::bits(m.is_beyond) & asked; beyond != 0; beyond &= beyond - 1) {
        const auto n = static_cast<std::uint32_t>(__builtin_ctz(beyond));
        trace_pixel(job, left + Shape::column(n), top + Shape::row(n));
    }
}

}  // namespace tedavis::raytrace
