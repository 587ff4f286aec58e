#include "render_core/scene/grid_slice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tedavis::scene {
namespace {

constexpr double kMaxSteps = 65535;
constexpr std::uint8_t kValid = 255, kInterpolated = 128;

}  // namespace

SliceTexel texel_of(const FieldValue& value, const SliceRange& range) noexcept {
    SliceTexel texel;
    if (value.state == ValueState::missing || !std::isfinite(value.value)) return texel;
    const double span = range.highest - range.lowest;
    const double level = span > 0 ? std::clamp((value.value - range.lowest) / span, 0.0, 1.0) : 0;
    const auto steps = static_cast<std::uint32_t>(std::lround(level * kMaxSteps));
    texel.value_high = static_cast<std::uint8_t>(steps >> 8);
    texel.value_low = static_cast<std::uint8_t>(steps & 0xFFu);
    texel.uncertainty = value.uncertainty.code();
    texel.state = value.state == ValueState::interpolated ? kInterpolated : kValid;
    return texel;
}

double value_of(const SliceTexel& texel, const SliceRange& range) noexcept {
    return range.lowest + (texel.value_high * 256 + texel.value_low) / kMaxSteps * (range.highest - range.lowest);
}

std::uint64_t GridSlice::bytes_needed(std::uint32_t most_posts) { return 2 * std::uint64_t{most_posts} * sizeof(SliceTexel); }

bool GridSlice::start(std::uint32_t most_posts, base::Arena& arena) {
    shown_.texels = arena.allocate_array<SliceTexel>(most_posts);
    next_.texels = arena.allocate_array<SliceTexel>(most_posts);
    forget();
    return shown_.texels.size() == most_posts && next_.texels.size() == most_posts;
}

bool GridSlice::set_field(const Layer& layer, const Attribute& attribute) {
    if (&layer == layer_ && &attribute == attribute_) return true;
    forget();
    const GridShape& grid = layer.entry->grid;
    if (layer.entry->shape != LayerShape::grid || std::uint64_t{grid.columns} * grid.rows > shown_.texels.size()) return false;
    layer_ = &layer;
    attribute_ = &attribute;
    return true;
}

void GridSlice::forget() {
    layer_ = nullptr;
    attribute_ = nullptr;
    shown_.is_begun = next_.is_begun = false;
}

SliceRange GridSlice::range() const {
    if (attribute_ == nullptr) return {};
    return {double{attribute_->entry->minimum}, double{attribute_->entry->maximum}};
}

void GridSlice::Sheet::begin(const SliceMoment& other) {
    moment = other;
    rows = classes = 0;
    is_begun = true;
}

void GridSlice::make(Sheet& sheet, std::uint32_t most_rows) const {
    const Attribute shown = sheet.moment.member == kMean ? *attribute_ : attribute_->member(sheet.moment.member);
    const GridField field(*layer_, shown);
    const AxisPlace level = field.level_at(sheet.moment.height_m), time = field.time_at(sheet.moment.time_ns);
    const base::Duration age = field.age(sheet.moment.time_ns);
    const bool is_classed = attribute_->entry->scale != AttributeScale::quantitative;
    const std::uint32_t across = columns(), end = sheet.rows + std::min(most_rows, rows() - sheet.rows);
    for (; sheet.rows < end; ++sheet.rows)
        for (std::uint32_t i = 0; i < across; ++i) {
            const FieldValue value = field.at_post(i, sheet.rows, level, time, age);
            sheet.texels[std::size_t{sheet.rows} * across + i] = texel_of(value, range());
            if (is_classed && value.state != ValueState::missing) sheet.classes |= 1u << static_cast<std::uint32_t>(value.value);
        }
}

bool GridSlice::show(const SliceMoment& moment) {
    if (layer_ == nullptr || shown_.is_of(moment)) return false;
    if (!next_.is_of(moment)) next_.begin(moment);
    make(next_, rows());
    std::swap(shown_, next_);
    return true;
}

void GridSlice::prepare(const SliceMoment& moment, std::uint32_t rows) {
    if (layer_ == nullptr) return;
    if (!next_.is_of(moment)) next_.begin(moment);
    make(next_, rows);
}

}  // namespace tedavis::scene
