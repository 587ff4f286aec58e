#include "render_core/perception/center_surround.hpp"

#include <cmath>

namespace tedavis::perception {
namespace {

constexpr float kShare = 1.0f / (kCenters * kSurrounds);

struct Surrounds {
    const float *near, *far;
};

Surrounds surrounds_of(const FeaturePyramid& feature, int center, int y, base::Span<float> scratch) {
    const int width = feature[center].width;
    const std::size_t half = expansion_scratch(feature[0].width);
    const Plane &near = feature[center + kNearestSurround], &far = feature[center + kNearestSurround + 1];
    return {expanded_row(near, kNearestSurround, y, width, scratch.subspan(0, half)),
            expanded_row(far, kNearestSurround + 1, y, width, scratch.subspan(half, half))};
}

void part(const float* __restrict center, const Surrounds& surrounds, int width, float* __restrict above,
          float* __restrict below) {
    const float *near = surrounds.near, *far = surrounds.far;
    for (int x = 0; x < width; ++x) {
        const float first = center[x] - near[x], second = center[x] - far[x];
        const float either = std::fabs(first) + std::fabs(second), sum = first + second;
        above[x] = kShare / 2 * (either + sum);
        below[x] = kShare / 2 * (either - sum);
    }
}

void measure(const float* __restrict center, const Surrounds& surrounds, int width, float* __restrict out) {
    const float *near = surrounds.near, *far = surrounds.far;
    for (int x = 0; x < width; ++x) out[x] = kShare * (std::fabs(center[x] - near[x]) + std::fabs(center[x] - far[x]));
}

/// Adds each plane to the next finer one.
void add_across(const CenterPlanes& planes, base::Span<float> scratch) {
    for (int center = kCenters - 1; center > 0; --center) {
        const Plane& finer = planes[center - 1];
        for (int y = 0; y < finer.height; ++y) {
            const float* __restrict coarse = expanded_row(planes[center], 1, y, finer.width, scratch);
            float* __restrict row = finer.row(y);
            for (int x = 0; x < finer.width; ++x) row[x] += coarse[x];
        }
    }
}

}  // namespace

void signed_differences(const FeaturePyramid& feature, const CenterPlanes& above, const CenterPlanes& below,
                        base::Span<float> scratch) noexcept {
    for (int center = 0; center < kCenters; ++center)
        for (int y = 0; y < feature[center].height; ++y)
            part(feature[center].row(y), surrounds_of(feature, center, y, scratch), feature[center].width, above[center].row(y),
                 below[center].row(y));
    add_across(above, scratch);
    add_across(below, scratch);
}

void differences(const FeaturePyramid& feature, const CenterPlanes& out, base::Span<float> scratch) noexcept {
    for (int center = 0; center < kCenters; ++center)
        for (int y = 0; y < feature[center].height; ++y)
            measure(feature[center].row(y), surrounds_of(feature, center, y, scratch), feature[center].width, out[center].row(y));
    add_across(out, scratch);
}

}  // namespace tedavis::perception
