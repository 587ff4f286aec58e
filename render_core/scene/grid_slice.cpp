#include "render_core/scene/grid_slice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tedavis::scene {
namespace {

constexpr double kMostSteps = 65535;
constexpr std::uint8_t kValid = 255, kInterpolated = 128;

}  // namespace

SliceTexel texel_of(const FieldValue& value, const SliceRange& range) noexcept {
    SliceTexel texel;
    if (value.state == ValueState::missing || !std::isfinite(value.value)) return texel;
    const double span = range.highest - range.lowest;
    const double level = span > 0 ? std::clamp((value.value - range.lowest) / span, 0.0, 1.0) : 0;
    const auto steps = static_cast<std::uint32_t>(level * kMostSteps + 0.5);
    texel.value_high = static_cast<std::uint8_t>(steps >> 8);
    texel.value_low = static_cast<std::uint8_t>(steps & 0xFFu);
    texel.uncertainty = value.uncertainty.code();
    texel.state = value.state == ValueState::interpolated ? kInterpolated : kValid;
    return texel;
}

double value_of(const SliceTexel& texel, const SliceRange& range) noexcept {
    return range.lowest + (texel.value_high * 256 + texel.value_low) / kMostSteps * (range.highest - range.lowest);
}

std::uint64_t GridSlice::bytes_needed(std::uint32_t most_posts) { return 2 * std::uint64_t{most_posts} * sizeof(SliceTexel); }

bool GridSlice::start(std::uint32_t most_posts, base::Arena& arena) {
    finished_ = arena.allocate_array<SliceTexel>(most_posts);
    in_work_ = arena.allocate_array<SliceTexel>(most_posts);
    forget();
    return finished_.size() == most_posts && in_work_.size() == most_posts;
}

bool GridSlice::show(const Layer& layer, const Attribute& attribute) {
    if (&layer == layer_ && &attribute == attribute_) return true;
    forget();
    const GridShape& grid = layer.entry->grid;
    if (layer.entry->shape != LayerShape::grid || std::uint64_t{grid.columns} * grid.rows > finished_.size()) return false;
    layer_ = &layer;
    attribute_ = &attribute;
    return true;
}

void GridSlice::forget() {
    layer_ = nullptr;
    attribute_ = nullptr;
    is_in_work_ = is_begun_ = is_finished_ = false;
}

SliceRange GridSlice::range() const {
    if (attribute_ == nullptr) return {};
    return {double{attribute_->entry->minimum}, double{attribute_->entry->maximum}};
}

void GridSlice::begin(double height_m, std::int64_t time_ns) {
    height_m_ = height_m;
    time_ns_ = time_ns;
    next_row_ = 0;
    is_begun_ = is_in_work_ = true;
}

bool GridSlice::advance(double height_m, std::int64_t time_ns, base::Duration step, std::uint32_t rows) {
    if (layer_ == nullptr) return false;
    const base::Duration off = base::Time{time_ns} - base::Time{time_ns_};
    // One in work is ended first, so that a time that runs on cannot keep every slice from being finished.
    const bool is_old = height_m != height_m_ || off >= step || base::Duration{} - off >= step;
    if (!is_in_work_ && (!is_begun_ || is_old)) begin(height_m, time_ns);
    if (!is_in_work_) return false;
    const GridField field(*layer_, *attribute_);
    const AxisPlace level = field.level_at(height_m_), time = field.time_at(time_ns_);
    const base::Duration age = field.age(time_ns_);
    const GridShape& grid = layer_->entry->grid;
    const std::uint32_t end = next_row_ + std::min(rows, grid.rows - next_row_);
    for (std::uint32_t j = next_row_; j < end; ++j)
        for (std::uint32_t i = 0; i < grid.columns; ++i)
            in_work_[std::size_t{j} * grid.columns + i] = texel_of(field.at_post(i, j, level, time, age), range());
    next_row_ = end;
    if (next_row_ < grid.rows) return false;
    std::swap(finished_, in_work_);
    is_in_work_ = false;
    is_finished_ = true;
    return true;
}

}  // namespace tedavis::scene
