#include "render_core/perception/saliency_model.hpp"

#include <algorithm>

namespace tedavis::perception {
namespace {

/// Hands out planes of a block front to back; counts only, without a block.
class PlaneCutter {
public:
    explicit PlaneCutter(base::Span<float> room) : room_(room) {}
    Plane cut(int width, int height) {
        const std::size_t first = used_;
        used_ += pixels_of(width, height);
        return {room_.empty() ? nullptr : room_.subspan(first, used_ - first).data(), width, height};
    }
    [[nodiscard]] std::size_t used() const { return used_; }

private:
    base::Span<float> room_;
    std::size_t used_ = 0;
};

struct ModelPlanes {
    LabPlanes colors;
    Plane between;
    FeaturePyramid feature;
    std::array<FeaturePyramid, kDirections> direction;
    std::array<CenterPlanes, 2> centers;
    SaliencyMaps maps;
    std::size_t floats = 0;
};

struct PictureSize {
    int width = 0, height = 0, start_level = 0;
};

ModelPlanes cut_planes(const PictureSize& size, base::Span<float> room) {
    PlaneCutter cutter(room);
    ModelPlanes planes;
    const int level = saliency_level(size.width, size.height), start = std::min(size.start_level, level);
    const auto cut = [&](int at) { return cutter.cut(level_side(size.width, at), level_side(size.height, at)); };
    for (Plane* color : {&planes.colors.lightness, &planes.colors.a, &planes.colors.b}) *color = cut(start);
    if (start + 1 < level) planes.between = cut(start + 1);
    for (int n = start == level ? 1 : 0; n < kFeatureLevels; ++n) planes.feature[n] = cut(level + n);
    for (FeaturePyramid& pyramid : planes.direction)
        for (int n = 0; n < kFeatureLevels; ++n) pyramid[n] = cut(level + n);
    for (CenterPlanes& center : planes.centers)
        for (int n = 1; n < kCenters; ++n) center[n] = cut(level + n);
    for (Plane& map : planes.maps.features) map = cut(level);
    planes.maps.conspicuity = cut(level);
    planes.maps.saliency = cut(level);
    planes.floats = cutter.used();
    return planes;
}

std::size_t scratch_floats(const PictureSize& size) {
    const int level = saliency_level(size.width, size.height), map_width = level_side(size.width, level);
    const int start_width = level_side(size.width, std::min(size.start_level, level));
    return std::max({reduction_scratch(start_width), softening_scratch(start_width), center_surround_scratch(map_width),
                     kOrientedEnergyScratch});
}

struct RoomNeeds {
    std::size_t planes = 0, scratch = 0;
};

/// Of the largest picture, and of the largest narrow and flat ones, whose maps are finer.
RoomNeeds room_needs(const PictureSize& most) {
    RoomNeeds needs;
    for (const int least_side : {kMaxPictureSide, 63, 31})
        for (const PictureSize& size : {PictureSize{std::min(most.width, least_side), most.height, most.start_level},
                                        PictureSize{most.width, std::min(most.height, least_side), most.start_level}}) {
            needs.planes = std::max(needs.planes, cut_planes(size, {}).floats);
            needs.scratch = std::max(needs.scratch, scratch_floats(size));
        }
    return needs;
}

bool is_possible(const PictureSize& size) {
    return size.width >= 1 && size.height >= 1 && size.width <= kMaxPictureSide && size.height <= kMaxPictureSide &&
           size.start_level >= 0 && size.start_level <= kMaxStartLevel;
}

}  // namespace

int saliency_level(int width, int height) noexcept {
    const int side = std::min(width, height);
    return side >= 64 ? 2 : side >= 32 ? 1 : 0;
}

std::size_t SaliencyModel::bytes(int most_width, int most_height, int least_start_level) {
    const RoomNeeds needs = room_needs({most_width, most_height, least_start_level});
    return (needs.planes + needs.scratch) * sizeof(float) + LabConversion::bytes(most_width) + 2 * 16;
}

bool SaliencyModel::start(base::Arena& arena, int most_width, int most_height, int least_start_level) {
    const PictureSize most{most_width, most_height, least_start_level};
    if (!is_possible(most)) return false;
    const RoomNeeds needs = room_needs(most);
    room_ = arena.allocate_array<float>(needs.planes);
    scratch_ = arena.allocate_array<float>(needs.scratch);
    if (room_.empty() || scratch_.empty() || !lab_.start(arena, most_width)) return false;
    taps_ = gabor_taps();
    most_width_ = most_width;
    most_height_ = most_height;
    least_start_level_ = least_start_level;
    return true;
}

void SaliencyModel::lay_out(int width, int height, int start_level) {
    const ModelPlanes planes = cut_planes({width, height, start_level}, room_);
    level_ = saliency_level(width, height);
    start_level_ = std::min(start_level, level_);
    colors_ = planes.colors;
    between_ = planes.between;
    feature_ = planes.feature;
    direction_ = planes.direction;
    centers_ = planes.centers;
    maps_ = planes.maps;
}

bool SaliencyModel::look(const PictureView& picture, int start_level) {
    has_looked_ = false;
    if (!picture.is_valid() || picture.width > most_width_ || picture.height > most_height_ || start_level < least_start_level_ ||
        start_level > kMaxStartLevel)
        return false;
    lay_out(picture.width, picture.height, start_level);
    lab_.convert(picture, start_level_, colors_);
    constexpr float kShares[kMaxStartLevel + 1] = {0, 1.0f / 16, 5.0f / 64};
    if (start_level_ > 0)
        for (const Plane& color : {colors_.lightness, colors_.a, colors_.b}) soften(color, kShares[start_level_], scratch_);
    measure_color(colors_.a, 2);
    measure_color(colors_.b, 4);
    measure_color(colors_.lightness, 0);
    measure_directions();
    has_looked_ = true;
    return true;
}

void SaliencyModel::build_pyramid(const Plane& base) {
    if (start_level_ == level_) {
        feature_[0] = base;
    } else if (start_level_ + 1 == level_) {
        halve(base, feature_[0], scratch_);
    } else {
        halve(base, between_, scratch_);
        halve(between_, feature_[0], scratch_);
    }
    for (int n = 1; n < kFeatureLevels; ++n) halve(feature_[n - 1], feature_[n], scratch_);
}

void SaliencyModel::measure_color(const Plane& base, int first_map) {
    build_pyramid(base);
    centers_[0][0] = maps_.features[first_map];
    centers_[1][0] = maps_.features[first_map + 1];
    signed_differences(feature_, centers_[0], centers_[1], scratch_);
}

/// Of the feature that the pyramid holds: lightness.
void SaliencyModel::measure_directions() {
    for (int n = 0; n < kFeatureLevels; ++n) {
        std::array<Plane, kDirections> out;
        for (int k = 0; k < kDirections; ++k) out[k] = direction_[k][n];
        oriented_energy(feature_[n], taps_, out, scratch_);
    }
    for (int k = 0; k < kDirections; ++k) {
        centers_[0][0] = maps_.features[kFirstOfConspicuity[2] + k];
        differences(direction_[k], centers_[0], scratch_);
    }
}

SaliencyMap SaliencyModel::map(SaliencyScale scale) {
    if (!has_looked_) return {};
    const bool has_salient = combine(maps_, scale);
    const Plane& map = maps_.saliency;
    return {{map.values, map.size()}, map.width, map.height, level_, scale, has_salient};
}

}  // namespace tedavis::perception
