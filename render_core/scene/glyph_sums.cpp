#include "render_core/scene/glyph_sums.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace tedavis::scene {
namespace {

constexpr float kRoundingRoom = 1.000001f;  // a box made in floats holds what it was made of

}  // namespace

void GlyphSums::add(const GlyphSummary& part) {
    GlyphSums sums(values_);
    const std::uint32_t valued = part.members - part.missing;
    for (int axis = 0; axis < 3; ++axis) sums.place_[axis] = double{part.place[axis]} * part.members;
    sums.over_ground_ = double{part.over_ground_m} * part.members;
    sums.value_ = double{part.value} * valued;
    sums.north_ = double{part.north_mps} * valued;
    sums.speed_ = double{part.speed_mps} * valued;
    sums.uncertainty_ = std::uint64_t{part.uncertainty.code()} * valued;
    sums.low_ = part.place - part.reach_m;
    sums.high_ = part.place + part.reach_m;
    sums.size_m_ = part.size_m;
    sums.class_ = part.value;
    sums.members_ = part.members;
    sums.missing_ = part.missing;
    sums.is_unknown_ = valued > 0 && !part.uncertainty.is_known();
    sums.is_interpolated_ = part.state == ValueState::interpolated;
    sums.is_mixed_ = part.is_mixed;
    add(sums);
}

void GlyphSums::add(const GlyphSums& other) {
    if (other.members_ == 0) return;
    add_class(other);
    low_ = members_ == 0 ? other.low_ : glm::min(low_, other.low_);
    high_ = members_ == 0 ? other.high_ : glm::max(high_, other.high_);
    for (int axis = 0; axis < 3; ++axis) place_[axis] += other.place_[axis];
    over_ground_ += other.over_ground_;
    value_ += other.value_;
    north_ += other.north_;
    speed_ += other.speed_;
    uncertainty_ += other.uncertainty_;
    size_m_ = std::max(size_m_, other.size_m_);
    members_ += other.members_;
    missing_ += other.missing_;
    is_unknown_ = is_unknown_ || other.is_unknown_;
    is_interpolated_ = is_interpolated_ || other.is_interpolated_;
}

void GlyphSums::add_class(const GlyphSums& other) {
    if (other.members_ == other.missing_) return;
    const bool is_first = members_ == missing_;
    is_mixed_ = other.is_mixed_ || (!is_first && (is_mixed_ || class_ != other.class_));
    class_ = other.class_;
}

void GlyphSums::keep_within(const glm::dvec3& low, const glm::dvec3& high) {
    for (int axis = 0; axis < 3; ++axis) {
        const double mean = place_[axis] / members_;
        if (!(mean >= low[axis] && mean <= high[axis])) continue;
        low_[axis] = std::max(low_[axis], static_cast<float>(low[axis]));
        high_[axis] = std::min(high_[axis], static_cast<float>(high[axis]));
    }
}

GlyphSummary GlyphSums::summary() const {
    GlyphSummary summary;
    if (members_ == 0) return summary;
    for (int axis = 0; axis < 3; ++axis) summary.place[axis] = static_cast<float>(place_[axis] / members_);
    summary.reach_m = glm::max(summary.place - low_, high_ - summary.place) * kRoundingRoom;
    summary.size_m = size_m_;
    summary.over_ground_m = static_cast<float>(over_ground_ / members_);
    summary.members = members_;
    summary.missing = missing_;
    const std::uint32_t valued = members_ - missing_;
    if (valued == 0) return summary;
    summary.state = is_interpolated_ ? ValueState::interpolated : ValueState::valid;
    if (!is_unknown_)
        summary.uncertainty = Uncertainty::from_code(static_cast<std::uint8_t>((uncertainty_ + valued - 1) / valued));
    if (values_ == GlyphValues::category) {
        summary.is_mixed = is_mixed_;
        summary.value = is_mixed_ ? 0 : class_;
        return summary;
    }
    summary.value = static_cast<float>(value_ / valued);
    summary.north_mps = static_cast<float>(north_ / valued);
    summary.speed_mps = static_cast<float>(speed_ / valued);
    return summary;
}

}  // namespace tedavis::scene
