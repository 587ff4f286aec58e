#include "host_sim/evaluation/steerable_bands.hpp"

#include <cmath>

#include "host_sim/evaluation/fourier_transform.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

double angular_frequency(int index, int length) {
    const int wrapped = 2 * index < length ? index : index - length;
    return 2 * base::kPi * wrapped / length;
}

/// From 0 up to half of `end` to 1 from `end` on, a cosine over the octave between.
double highpass_share(double frequency, double end) {
    if (frequency <= end / 2) return 0;
    return frequency >= end ? 1 : std::cos(base::kPi / 2 * std::log2(frequency / end));
}

double lowpass_share(double frequency, double end) {
    const double high = highpass_share(frequency, end);
    return std::sqrt(1 - high * high);
}

struct BandHeading {
    double across, down;  // of length 1
};

BandHeading heading_of(int direction) {
    const double angle = base::kPi * direction / kBandDirections;
    return {std::cos(angle), std::sin(angle)};
}

double frequency_length(double across, double down) { return std::sqrt(across * across + down * down); }

/// Their squares add up to 1 over the directions; odd, so that with the factor i a band is real.
double direction_share(double across, double down, const BandHeading& heading) {
    static const double kScale = std::sqrt(0.8);
    const double radius = frequency_length(across, down);
    const double cosine = radius > 0 ? (across * heading.across + down * heading.down) / radius : 0;
    return kScale * cosine * cosine * cosine;
}

/// `share` of both frequencies, in rad a pixel.
template <class Share>
void weigh(Spectrum& spectrum, const Share& share) {
    for (int y = 0; y < spectrum.height; ++y) {
        const double down = angular_frequency(y, spectrum.height);
        for (int x = 0; x < spectrum.width; ++x) spectrum.row(y)[x] *= share(angular_frequency(x, spectrum.width), down);
    }
}

/// Half the sides; what is above the new pixels' frequencies must be 0. Samples lie between two old ones.
Spectrum halved_spectrum(const Spectrum& fine) {
    Spectrum coarse(fine.width / 2, fine.height / 2);
    const auto from = [](int index, int coarse_length) { return 2 * index < coarse_length ? index : index + coarse_length; };
    for (int y = 0; y < coarse.height; ++y)
        for (int x = 0; x < coarse.width; ++x) {
            const int u = from(x, coarse.width), v = from(y, coarse.height);
            const double shift = 0.5 * (angular_frequency(u, fine.width) + angular_frequency(v, fine.height));
            coarse.row(y)[x] = fine.row(v)[u] * std::polar(0.25, shift);
        }
    return coarse;
}

/// Two real bands by one transform: the second one is the imaginary part.
void add_pair(const Spectrum& size, int direction, std::vector<ValueMap>& bands) {
    Spectrum pair = size;
    const BandHeading first_heading = heading_of(direction), second_heading = heading_of(direction + 1);
    weigh(pair, [&](double across, double down) {
        const double high = highpass_share(frequency_length(across, down), base::kPi / 2);
        // i times the first, and i times i times the second
        return Complex(-direction_share(across, down, second_heading), direction_share(across, down, first_heading)) * high;
    });
    pair.transform_backward();
    ValueMap first(pair.width, pair.height), second(pair.width, pair.height);
    for (std::size_t n = 0; n < pair.values.size(); ++n) {
        first.values[n] = pair.values[n].real();
        second.values[n] = pair.values[n].imag();
    }
    bands.push_back(std::move(first));
    bands.push_back(std::move(second));
}

}  // namespace

std::vector<ValueMap> steerable_bands(const ValueMap& picture) {
    Spectrum size(picture.width, picture.height);
    for (std::size_t n = 0; n < size.values.size(); ++n) size.values[n] = picture.values[n];
    size.transform_forward();
    weigh(size, [](double across, double down) { return lowpass_share(frequency_length(across, down), base::kPi); });
    std::vector<ValueMap> bands;
    for (int n = 0; n < kBandSizes; ++n) {
        for (int direction = 0; direction < kBandDirections; direction += 2) add_pair(size, direction, bands);
        weigh(size, [](double across, double down) { return lowpass_share(frequency_length(across, down), base::kPi / 2); });
        size = halved_spectrum(size);
    }
    size.transform_backward();
    ValueMap rest(size.width, size.height);
    for (std::size_t n = 0; n < rest.values.size(); ++n) rest.values[n] = size.values[n].real();
    bands.push_back(std::move(rest));
    return bands;
}

}  // namespace tedavis::host_sim
