/// The values of a layer's attribute at a time, with their positions, for data foci.
///
/// A grid has one value per post and level. Between two of the grid's times (scene/grid_field.hpp) quantitative values are
/// interpolated linearly, and others are those of the nearer time. Other layers have one value per feature or per point, as the
/// attribute has. A wind layer without an attribute "speed" has the speed from "east" and "north".
///
/// Pure. Frames  WGS84, radians. Any thread; the layer must outlive the object.
#pragma once

#include <cmath>

#include "render_core/scene/scene.hpp"

namespace tedavis::draw {

class LayerValues {
public:
    [[nodiscard]] static bool has(const scene::Layer& layer, std::string_view attribute) noexcept;
    /// A layer without the attribute has no values.
    LayerValues(const scene::Layer& layer, std::string_view attribute, std::int64_t time_ns);

    [[nodiscard]] std::size_t size() const { return size_; }
    /// Returns the n-th value, NaN where it is missing; n below size().
    [[nodiscard]] double operator[](std::size_t n) const {
        const double value = between(value_, n);
        if (north_.first == nullptr) return value;
        const double north = between(north_, n);
        return std::sqrt(value * value + north * north);
    }
    /// Returns the points to which the n-th value belongs; none for a grid.
    [[nodiscard]] scene::Run points_of(std::size_t n) const;
    struct Place {
        double latitude_rad, longitude_rad;
    };
    /// Returns the position of a grid's post.
    [[nodiscard]] Place post(std::size_t n) const;
    [[nodiscard]] bool is_grid() const { return is_grid_; }
    /// True where a layer that is not a grid has one value per point, false for one per feature.
    [[nodiscard]] bool is_of_points() const { return is_of_points_; }

private:
    /// The values at the time before and at the time after.
    struct Times {
        const float *first = nullptr, *second = nullptr;
    };
    [[nodiscard]] double between(const Times& times, std::size_t n) const {
        const auto first = static_cast<double>(times.first[n]);
        return fraction_ == 0 ? first : first + fraction_ * (static_cast<double>(times.second[n]) - first);
    }

    const scene::Layer* layer_;
    Times value_, north_;
    std::size_t size_ = 0;
    double fraction_ = 0;
    bool is_grid_ = false, is_of_points_ = false;
};

}  // namespace tedavis::draw
