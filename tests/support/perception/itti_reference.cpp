#include "tests/support/perception/itti_reference.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::test_support {
namespace {

using Pyramid = std::vector<Field>;

double linear(std::uint8_t level) {
    const double s = level / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

double lab_f(double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; }

Pyramid pyramid_of(const Field& field, int levels) {
    Pyramid pyramid{field};
    for (int n = 1; n < levels; ++n) pyramid.push_back(reference_halved(pyramid.back()));
    return pyramid;
}

constexpr int kFinestCenterLevels = 7;

/// Of the pyramid from the finest centre on: the mean over centres 0, 1, 2 and surrounds three and four levels coarser of
/// part(centre - surround), seen at the finest centre's size. Differences are interpolated from their centre's level, one level
/// at a time.
template <class Part>
Field across_scales(const Pyramid& feature, const Part& part) {
    Field sum(1, 1);
    for (int center = 2; center >= 0; --center) {
        const Field& fine = feature[static_cast<std::size_t>(center)];
        Field here(fine.width, fine.height);
        for (int y = 0; y < fine.height; ++y)
            for (int x = 0; x < fine.width; ++x) {
                double mean = 0;
                for (const int coarser : {3, 4}) {
                    const double scale = 1 << coarser;
                    const int surround = center + coarser;
                    mean += part(fine(x, y) -
                                 feature[static_cast<std::size_t>(surround)].between((x + 0.5) / scale, (y + 0.5) / scale)) /
                            6;
                }
                here.at(x, y) = mean + (center == 2 ? 0 : sum.between((x + 0.5) / 2, (y + 0.5) / 2));
            }
        sum = here;
    }
    return sum;
}

/// -log2 of the share of pixels above a threshold, by (n + 1) / (N + 2).
double bits_of(const Field& map, double threshold, const ReferenceOptions& options) {
    if (options.without_entropy) return 1;
    const auto above = std::count_if(map.values.begin(), map.values.end(), [&](double v) { return v > threshold; });
    return -std::log2((static_cast<double>(above) + 1) / (static_cast<double>(map.values.size()) + 2));
}

double weight_of(const Field& map, const ReferenceOptions& options) {
    const double most = map.most();
    if (!options.fixed_scale) return most < 1e-4 && !options.without_guard ? 0 : bits_of(map, most / 2, options) * most;
    return most > 0.023 ? bits_of(map, 0.023, options) / std::log2(static_cast<double>(map.values.size()) + 2) : 0;
}

Field weighted_sum(const std::vector<Field>& maps, const ReferenceOptions& options) {
    Field sum(maps[0].width, maps[0].height);
    for (const Field& map : maps) {
        const double weight = weight_of(map, options);
        for (std::size_t n = 0; n < sum.values.size(); ++n) sum.values[n] += weight * map.values[n];
    }
    return sum;
}

std::vector<Field> signed_maps(const Pyramid& feature) {
    return {across_scales(feature, [](double d) { return std::max(d, 0.0); }),
            across_scales(feature, [](double d) { return std::max(-d, 0.0); })};
}

Field directions(const Pyramid& lightness, const ReferenceOptions& options) {
    std::vector<Field> maps;
    for (const double angle : {0.0, 0.25, 0.5, 0.75}) {
        Pyramid answers;
        for (const Field& level : lightness) answers.push_back(reference_gabor(level, angle * std::acos(-1.0), options.wave_px));
        maps.push_back(across_scales(answers, [](double d) { return std::fabs(d); }));
    }
    return weighted_sum(maps, options);
}

}  // namespace

double Field::operator()(int x, int y) const {
    return values[perception::pixels_of(width, std::clamp(y, 0, height - 1)) +
                  static_cast<std::size_t>(std::clamp(x, 0, width - 1))];
}

double Field::between(double x, double y) const {
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
    const double u = x - 0.5 - left, v = y - 0.5 - top;
    const int i = static_cast<int>(left), j = static_cast<int>(top);
    return (1 - v) * ((1 - u) * (*this)(i, j) + u * (*this)(i + 1, j)) +
           v * ((1 - u) * (*this)(i, j + 1) + u * (*this)(i + 1, j + 1));
}

double Field::most() const {
    double most = 0;
    for (const double value : values) most = std::max(most, value);
    return most;
}

std::array<Field, 3> reference_lab(const perception::PictureView& picture) {
    std::array<Field, 3> lab{Field(picture.width, picture.height), Field(picture.width, picture.height),
                             Field(picture.width, picture.height)};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::uint8_t* pixel = picture.row(y) + picture.channels * x;
            const double r = linear(pixel[0]), g = linear(pixel[1]), b = linear(pixel[2]);
            const double fx = lab_f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.9504700);
            const double fy = lab_f(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
            const double fz = lab_f((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.0888300);
            lab[0].at(x, y) = (116 * fy - 16) / 100;
            lab[1].at(x, y) = 500 * (fx - fy) / 100;
            lab[2].at(x, y) = 200 * (fy - fz) / 100;
        }
    return lab;
}

Field reference_halved(const Field& field) {
    Field half((field.width + 1) / 2, (field.height + 1) / 2);
    const double weights[4] = {1.0 / 8, 3.0 / 8, 3.0 / 8, 1.0 / 8};
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x)
            for (int v = 0; v < 4; ++v)
                for (int u = 0; u < 4; ++u) half.at(x, y) += weights[u] * weights[v] * field(2 * x - 1 + u, 2 * y - 1 + v);
    return half;
}

Field reference_gabor(const Field& field, double angle_rad, double wave_px) {
    constexpr double kSigma_px = 1.6;
    constexpr int kReach = 4;
    std::array<std::complex<double>, 81> waves;
    std::array<double, 81> bell{};
    std::complex<double> flat = 0;
    double sum = 0;
    for (int v = -kReach, n = 0; v <= kReach; ++v)
        for (int u = -kReach; u <= kReach; ++u, ++n) {
            const auto at = static_cast<std::size_t>(n);
            bell[at] = std::exp(-(u * u + v * v) / (2 * kSigma_px * kSigma_px));
            waves[at] = std::polar(bell[at], 2 * std::acos(-1.0) / wave_px * (u * std::cos(angle_rad) + v * std::sin(angle_rad)));
            sum += bell[at];
            flat += waves[at];
        }
    Field lengths(field.width, field.height);
    for (int y = 0; y < field.height; ++y)
        for (int x = 0; x < field.width; ++x) {
            std::complex<double> answer = 0;
            for (int v = -kReach, n = 0; v <= kReach; ++v)
                for (int u = -kReach; u <= kReach; ++u, ++n) {
                    const auto at = static_cast<std::size_t>(n);
                    answer += (waves[at] - flat / sum * bell[at]) / sum * field(x + u, y + v);
                }
            lengths.at(x, y) = 4 * std::abs(answer);
        }
    return lengths;
}

Field itti_reference(const perception::PictureView& picture, const ReferenceOptions& options) {
    std::array<Field, 3> lab = reference_lab(picture);
    const int side = std::min(picture.width, picture.height), level = side >= 64 ? 2 : side >= 32 ? 1 : 0;
    std::vector<Field> parts;
    std::array<Pyramid, 3> pyramids;
    for (std::size_t c = 0; c < 3; ++c) {
        for (int n = 0; n < level; ++n) lab[c] = reference_halved(lab[c]);
        pyramids[c] = pyramid_of(lab[c], kFinestCenterLevels);
    }
    parts.push_back(weighted_sum(signed_maps(pyramids[0]), options));
    if (!options.without_colors) {
        std::vector<Field> colors = signed_maps(pyramids[1]);
        for (const Field& map : signed_maps(pyramids[2])) colors.push_back(map);
        parts.push_back(weighted_sum(colors, options));
    }
    parts.push_back(directions(pyramids[0], options));
    Field saliency(parts[0].width, parts[0].height);
    for (const Field& part : parts) {
        if (part.most() <= 0) continue;
        const double weight = options.fixed_scale ? 1 : bits_of(part, part.most() / 2, options);
        for (std::size_t n = 0; n < saliency.values.size(); ++n) saliency.values[n] += weight * part.values[n];
    }
    const double most = saliency.most();
    const bool is_divided = most > 0 || options.without_guard;
    for (double& value : saliency.values) value = options.fixed_scale ? std::min(2 * value, 1.0) : is_divided ? value / most : 0;
    return saliency;
}

}  // namespace tedavis::test_support
