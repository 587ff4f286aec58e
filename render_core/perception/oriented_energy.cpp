#include "render_core/perception/oriented_energy.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/perception/independent_loop.hpp"

namespace tedavis::perception {
namespace {

constexpr int kRadius = kGaborRadius, kRows = 2 * kGaborRadius + 1;
constexpr float kWholeGrating = 4;  // of which the filter sees half the amplitude, half the contrast

/// A row filtered across in the five ways that the directions need.
struct AcrossRows {
    float *bell, *cosine, *sine, *slant_cosine, *slant_sine;
};

/// Columns that are filtered together.
struct Strip {
    int first = 0, width = 0;
};

/// Buffers of a strip's last rows, and one for the source with what lies beside it.
class RowRing {
public:
    explicit RowRing(float* scratch) : scratch_(scratch) {}
    [[nodiscard]] AcrossRows at(int y) const {
        float* first = scratch_ + static_cast<std::size_t>(y % kRows) * 5 * kStride;
        return {first, first + kStride, first + 2 * kStride, first + 3 * kStride, first + 4 * kStride};
    }
    [[nodiscard]] float* source() const { return scratch_ + 5 * kRows * kStride + kRadius; }

private:
    static constexpr std::size_t kStride = std::size_t{kGaborStrip} + 2 * kRadius;
    float* scratch_;
};

void filter_across(const Plane& plane, const Strip& strip, int y, const GaborTaps& taps, const RowRing& ring) {
    float* source = ring.source();
    const float* row = plane.row(y);
    std::copy_n(row + strip.first, strip.width, source);
    for (int k = 1; k <= kRadius; ++k) {
        source[-k] = row[std::max(strip.first - k, 0)];
        source[strip.width - 1 + k] = row[std::min(strip.first + strip.width - 1 + k, plane.width - 1)];
    }
    const AcrossRows out = ring.at(y);
    float *bell = out.bell, *cosine = out.cosine, *sine = out.sine;
    float *slant_cosine = out.slant_cosine, *slant_sine = out.slant_sine;
    const GaborTaps t = taps;
    TEDAVIS_INDEPENDENT_LOOP
    for (int x = 0; x < strip.width; ++x) {
        float b = t.bell[0] * source[x], c = t.cosine[0] * source[x], d = t.slant_cosine[0] * source[x], s = 0, u = 0;
        for (int k = 1; k <= kRadius; ++k) {
            const float sum = source[x - k] + source[x + k], difference = source[x + k] - source[x - k];
            b += t.bell[k] * sum;
            c += t.cosine[k] * sum;
            d += t.slant_cosine[k] * sum;
            s += t.sine[k] * difference;
            u += t.slant_sine[k] * difference;
        }
        bell[x] = b;
        cosine[x] = c;
        slant_cosine[x] = d;
        sine[x] = s;
        slant_sine[x] = u;
    }
}

struct Tall {
    const float* rows[kRows];
};

float even(const Tall& from, const float* taps, int x) {
    float sum = taps[0] * from.rows[kRadius][x];
    for (int k = 1; k <= kRadius; ++k) sum += taps[k] * (from.rows[kRadius - k][x] + from.rows[kRadius + k][x]);
    return sum;
}
float odd(const Tall& from, const float* taps, int x) {
    float sum = 0;
    for (int k = 1; k <= kRadius; ++k) sum += taps[k] * (from.rows[kRadius + k][x] - from.rows[kRadius - k][x]);
    return sum;
}
float length(float real, float imaginary) { return kWholeGrating * std::sqrt(real * real + imaginary * imaginary); }

void filter_straight(const Tall (&across)[5], const GaborTaps& t, int width, float* flat, float* upright, float* level) {
    TEDAVIS_INDEPENDENT_LOOP
    for (int x = 0; x < width; ++x) {
        const float mean = even(across[0], t.bell, x);
        flat[x] = mean;
        upright[x] = length(even(across[1], t.bell, x) - t.flat_share * mean, even(across[2], t.bell, x));
        level[x] = length(even(across[0], t.cosine, x) - t.flat_share * mean, odd(across[0], t.sine, x));
    }
}

/// The product of two waves along the sides: the sum of their phases one way, the difference the other.
void filter_slanted(const Tall& cosines, const Tall& sines, const GaborTaps& t, int width, const float* flat, float* falling,
                    float* rising) {
    TEDAVIS_INDEPENDENT_LOOP
    for (int x = 0; x < width; ++x) {
        const float cc = even(cosines, t.slant_cosine, x), cs = odd(cosines, t.slant_sine, x);
        const float sc = even(sines, t.slant_cosine, x), ss = odd(sines, t.slant_sine, x);
        const float mean = t.slant_flat * flat[x];
        falling[x] = length(cc - ss - mean, sc + cs);
        rising[x] = length(cc + ss - mean, sc - cs);
    }
}

void filter_strip(const Plane& plane, const Strip& strip, const GaborTaps& taps, const std::array<Plane, kDirections>& out,
                  const RowRing& ring) {
    int filtered = 0;
    for (int y = 0; y < plane.height; ++y) {
        for (; filtered <= std::min(y + kRadius, plane.height - 1); ++filtered) filter_across(plane, strip, filtered, taps, ring);
        Tall across[5];
        for (int k = 0; k < kRows; ++k) {
            const AcrossRows rows = ring.at(std::clamp(y + k - kRadius, 0, plane.height - 1));
            across[0].rows[k] = rows.bell;
            across[1].rows[k] = rows.cosine;
            across[2].rows[k] = rows.sine;
            across[3].rows[k] = rows.slant_cosine;
            across[4].rows[k] = rows.slant_sine;
        }
        const auto row = [&](int direction) { return out[direction].row(y) + strip.first; };
        float* flat = ring.source();
        filter_straight(across, taps, strip.width, flat, row(0), row(2));
        filter_slanted(across[3], across[4], taps, strip.width, flat, row(1), row(3));
    }
}

}  // namespace

GaborTaps gabor_taps() noexcept {
    GaborTaps taps;
    double sum = 0;
    for (int k = -kRadius; k <= kRadius; ++k) sum += std::exp(-k * k / (2 * kGaborSigma_px * kGaborSigma_px));
    double flat = 0, slant_flat = 0;
    const double wave = 2 * base::kPi / kGaborWave_px, slant = wave * std::sqrt(0.5);
    for (int k = 0; k <= kRadius; ++k) {
        const double bell = std::exp(-k * k / (2 * kGaborSigma_px * kGaborSigma_px)) / sum;
        taps.bell[k] = static_cast<float>(bell);
        taps.cosine[k] = static_cast<float>(bell * std::cos(wave * k));
        taps.sine[k] = static_cast<float>(bell * std::sin(wave * k));
        taps.slant_cosine[k] = static_cast<float>(bell * std::cos(slant * k));
        taps.slant_sine[k] = static_cast<float>(bell * std::sin(slant * k));
        flat += (k == 0 ? 1 : 2) * bell * std::cos(wave * k);
        slant_flat += (k == 0 ? 1 : 2) * bell * std::cos(slant * k);
    }
    taps.flat_share = static_cast<float>(flat);
    taps.slant_flat = static_cast<float>(slant_flat * slant_flat);
    return taps;
}

void oriented_energy(const Plane& plane, const GaborTaps& taps, const std::array<Plane, kDirections>& out,
                     base::Span<float> scratch) noexcept {
    for (int first = 0; first < plane.width; first += kGaborStrip)
        filter_strip(plane, {first, std::min(kGaborStrip, plane.width - first)}, taps, out, RowRing(scratch.data()));
}

}  // namespace tedavis::perception
