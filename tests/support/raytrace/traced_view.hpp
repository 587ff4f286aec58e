/// Pictures of the tracer over made heights, by any of its kernels.
#pragma once

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "render_core/base/check.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/raytrace/view_tiles.hpp"

namespace tedavis::test_support {

/// Hills of a few cells with needles, and holes where asked for; heights of some thousand steps.
template <class Height>
class ViewedHills {
public:
    ViewedHills(std::uint32_t columns, std::uint32_t rows, bool has_holes) : columns_(columns), rows_(rows) {
        std::mt19937 random(columns + 7 * rows);
        posts_.resize(std::size_t{columns} * rows);
        for (std::uint32_t n = 0; n < posts_.size(); ++n) {
            const double x = n % columns, y = static_cast<double>(n / columns);
            const double hill =
                900 * std::sin(0.21 * x) * std::cos(0.17 * y) + 2500 * std::sin(0.031 * (x + y)) + 300 * std::sin(x * y);
            posts_[n] = static_cast<Height>(random() % 200 == 0 ? hill + 6000 : hill);
            if (has_holes && random() % 90 == 0) posts_[n] = raytrace::HeightGrid<Height>::kVoid;
        }
        start(maxima_, memory_[0]);
        start(minima_, memory_[1]);
    }
    [[nodiscard]] raytrace::TracedField<Height> field(raytrace::CellSurface surface) const {
        return {&maxima_, &minima_, surface};
    }
    [[nodiscard]] double columns() const { return columns_; }
    [[nodiscard]] double rows() const { return rows_; }

private:
    void start(raytrace::HeightMipmap<Height>& mipmap, std::vector<std::uint64_t>& memory) {
        memory.resize(raytrace::HeightMipmap<Height>::bytes_needed(columns_, rows_) / 8 + 1);
        base::Arena arena(memory.data(), memory.size() * 8);
        TEDAVIS_CHECK(mipmap.start({posts_.data(), columns_, rows_, columns_}, arena));
        base::SerialWorkers workers;
        mipmap.build(workers);
    }

    std::uint32_t columns_, rows_;
    std::vector<Height> posts_;
    std::vector<std::uint64_t> memory_[2];
    raytrace::HeightMipmap<Height> maxima_{raytrace::HeightBound::maximum}, minima_{raytrace::HeightBound::minimum};
};

/// Any attitude, from a place over, beside or in the ground.
inline raytrace::GridCamera any_camera(std::mt19937& random, double columns, double rows, std::uint32_t width) {
    const auto any = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    const double yaw = any(-4, 4), pitch = any(-1.2, 0.5), roll = any(-3, 3), pixel = 1.1 / width, steps = 100;
    const glm::dvec3 forward(std::cos(yaw) * std::cos(pitch), std::sin(yaw) * std::cos(pitch), std::sin(pitch));
    const glm::dvec3 side(-std::sin(yaw), std::cos(yaw), 0);
    const glm::dvec3 below(std::cos(yaw) * std::sin(pitch), std::sin(yaw) * std::sin(pitch), -std::cos(pitch));
    const glm::dvec3 scale(1, 1, steps);
    const glm::dvec3 right = (side * std::cos(roll) + below * std::sin(roll)) * pixel * scale;
    const glm::dvec3 down = (below * std::cos(roll) - side * std::sin(roll)) * pixel * scale;
    raytrace::GridCamera camera;
    camera.origin = {any(-0.2, 1.2) * columns, any(-0.2, 1.2) * rows, any(-2000, 9000)};
    camera.right = right;
    camera.down = down;
    camera.corner = forward * scale - right * (0.5 * width) - down * (0.4 * width);
    return camera;
}

/// Its columns lie in vertical planes; `is_flipped`: its first row is the lowest.
inline raytrace::GridCamera upright_camera(std::mt19937& random, double columns, double rows, std::uint32_t width,
                                           bool is_flipped) {
    raytrace::GridCamera camera = any_camera(random, columns, rows, width);
    camera.right.z *= 0.1f;
    camera.down = {0, 0, is_flipped ? 0.7f : -0.7f};
    camera.corner.z = is_flipped ? -60.0f : 15.0f;
    return camera;
}

struct TracedPicture {
    TracedPicture(std::uint32_t w, std::uint32_t h) : width(w), height(h), t(w * h), cell(w * h), side(w * h) {}
    [[nodiscard]] raytrace::HitPicture picture() { return {t, cell, side}; }
    /// Pixels that are not the same bits.
    [[nodiscard]] std::size_t differences(const TracedPicture& other) const {
        std::size_t count = 0;
        for (std::size_t n = 0; n < t.size(); ++n)
            if (std::memcmp(&t[n], &other.t[n], sizeof t[n]) != 0 || cell[n] != other.cell[n] || side[n] != other.side[n])
                ++count;
        return count;
    }

    std::uint32_t width, height;
    std::vector<float> t;
    std::vector<std::int32_t> cell;
    std::vector<raytrace::HitSide> side;
};

/// Ray by ray.
template <class Height>
TracedPicture traced_singly(const raytrace::TracedField<Height>& field, const raytrace::GridCamera& camera, std::uint32_t width,
                            std::uint32_t height) {
    TracedPicture all(width, height);
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const raytrace::Hit hit = raytrace::trace_ray(field, camera.ray(x, y));
            const std::size_t at = std::size_t{y} * width + x;
            all.t[at] = hit.t;
            all.side[at] = hit.side;
            const std::uint32_t cells = field.grid().columns - 1;
            all.cell[at] = hit.side == raytrace::HitSide::none ? -1 : static_cast<std::int32_t>(hit.row * cells + hit.column);
        }
    return all;
}

/// All tiles of a picture, shared out to the workers; rays are straight in grid space.
template <class Height>
void trace_view(const raytrace::TracedField<Height>& field, const raytrace::GridCamera& camera,
                const raytrace::ViewKernel<Height>& kernel, base::Workers& workers, std::uint32_t width, std::uint32_t height,
                const raytrace::HitPicture& picture) {
    TEDAVIS_CHECK(raytrace::has_pixels(picture, std::size_t{width} * height));
    if (!raytrace::is_in_reach(camera.origin)) return raytrace::clear_pixels(picture, width, 0, 0, width, height);
    struct Work {
        raytrace::ViewJob<Height> job;
        const raytrace::ViewKernel<Height>* kernel;
        raytrace::ViewTiles tiles;
    } work{{&field, &camera, width, height, picture, {}, false}, &kernel, {width, height}};
    const auto trace_tile = [](void* context, std::uint32_t tile) {
        const Work& all = *static_cast<const Work*>(context);
        all.kernel->trace_tile(all.job, all.tiles.left(tile), all.tiles.top(tile));
    };
    workers.parallel_for(work.tiles.count(), trace_tile, &work);
}

template <class Height>
TracedPicture traced_by(const raytrace::ViewKernel<Height>& kernel, const raytrace::TracedField<Height>& field,
                        const raytrace::GridCamera& camera, std::uint32_t width, std::uint32_t height, base::Workers& workers) {
    TracedPicture all(width, height);
    trace_view(field, camera, kernel, workers, width, height, all.picture());
    return all;
}

}  // namespace tedavis::test_support
