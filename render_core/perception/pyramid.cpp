#include "render_core/perception/pyramid.hpp"

#include <algorithm>

namespace tedavis::perception {
namespace {

void add_rows_1331(const Plane& fine, int y, float* __restrict sums) {
    const auto row = [&](int at) { return fine.row(std::clamp(at, 0, fine.height - 1)); };
    const float *first = row(y - 1), *second = row(y), *third = row(y + 1), *fourth = row(y + 2);
    for (int x = 0; x < fine.width; ++x) sums[x] = (first[x] + fourth[x]) + 3 * (second[x] + third[x]);
}

/// `fractions` of the way from each element to the next; as many elements as there are levels' pixels between.
template <int Levels>
void expand_between(const float* __restrict from, int intervals, float* __restrict out) {
    constexpr int kPixels = 1 << Levels;
    float fractions[kPixels];
    for (int n = 0; n < kPixels; ++n) fractions[n] = (static_cast<float>(n) + 0.5f) / kPixels;
    for (int j = 0; j < intervals; ++j)
        for (int n = 0; n < kPixels; ++n) out[j * kPixels + n] = from[j] + (from[j + 1] - from[j]) * fractions[n];
}

void soften_across(const float* from, int width, float share, float* __restrict out) {
    const float kept = 1 - 2 * share;
    const int last = width - 1;
    for (int x = 1; x < last; ++x) out[x] = kept * from[x] + share * (from[x - 1] + from[x + 1]);
    out[0] = kept * from[0] + share * (from[0] + from[last > 0 ? 1 : 0]);
    if (last > 0) out[last] = kept * from[last] + share * (from[last - 1] + from[last]);
}

void soften_down(const float* __restrict above, const float* __restrict here, const float* __restrict below, int width,
                 float share, float* __restrict out) {
    const float kept = 1 - 2 * share;
    for (int x = 0; x < width; ++x) out[x] = kept * here[x] + share * (above[x] + below[x]);
}

}  // namespace

void soften(const Plane& plane, float share, base::Span<float> scratch) noexcept {
    const auto row = [&](int y) { return scratch.data() + static_cast<std::ptrdiff_t>(y % 3) * plane.width; };
    const int last = plane.height - 1;
    soften_across(plane.row(0), plane.width, share, row(0));
    for (int y = 0; y <= last; ++y) {
        if (y < last) soften_across(plane.row(y + 1), plane.width, share, row(y + 1));
        soften_down(row(std::max(y - 1, 0)), row(y), row(std::min(y + 1, last)), plane.width, share, plane.row(y));
    }
}

void halve(const Plane& fine, const Plane& coarse, base::Span<float> scratch) noexcept {
    float* sums = scratch.data() + 1;
    for (int y = 0; y < coarse.height; ++y) {
        add_rows_1331(fine, 2 * y, sums);
        sums[-1] = sums[0];
        sums[fine.width] = sums[fine.width + 1] = sums[fine.width - 1];
        const float* __restrict from = sums;
        float* __restrict out = coarse.row(y);
        for (int x = 0; x < coarse.width; ++x)
            out[x] = ((from[2 * x - 1] + from[2 * x + 2]) + 3 * (from[2 * x] + from[2 * x + 1])) * (1.0f / 64);
    }
}

const float* expanded_row(const Plane& coarse, int levels, int y, int width, base::Span<float> scratch) noexcept {
    // Middles of coarse rows lie half a coarse pixel from their border.
    const int pixels = 1 << levels, from_middle = y - pixels / 2;
    const int upper = from_middle >> levels;
    const float fraction = (static_cast<float>(from_middle - upper * pixels) + 0.5f) / static_cast<float>(pixels);
    const float* __restrict above = coarse.row(std::clamp(upper, 0, coarse.height - 1));
    const float* __restrict below = coarse.row(std::clamp(upper + 1, 0, coarse.height - 1));
    float* __restrict blended = scratch.data() + 1;
    for (int x = 0; x < coarse.width; ++x) blended[x] = above[x] + (below[x] - above[x]) * fraction;
    blended[-1] = blended[0];
    blended[coarse.width] = blended[coarse.width - 1];
    float* out = blended + coarse.width + 1;
    const int intervals = std::min((width + pixels / 2 + pixels - 1) / pixels, coarse.width + 1);
    switch (levels) {
        case 1: expand_between<1>(blended - 1, intervals, out); break;
        case 2: expand_between<2>(blended - 1, intervals, out); break;
        case 3: expand_between<3>(blended - 1, intervals, out); break;
        default: expand_between<kMaxExpansion>(blended - 1, intervals, out); break;
    }
    return out + pixels / 2;
}

}  // namespace tedavis::perception
