#include "host_sim/measure/perceptual_difference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"
#include "render_core/design/color_difference.hpp"

namespace tedavis::host_sim {
namespace {

using base::kPi;
using design::Lab;
using design::LinearRgb;

/// The paper's exponents and limits: of the difference of colours (equation 3), and of features (equation 8).
constexpr double kColorExponent = 0.7, kLowPart = 0.4, kLowShare = 0.95, kFeatureExponent = 0.5;
constexpr double kEdgeWidth_deg = 0.082;  ///< of the lines that the eye sees best

/// Light that the eye receives, relative to white: a row for each of X, Y and Z, which sums to 1.
using LightMatrix = std::array<std::array<double, 3>, 3>;
constexpr LightMatrix kWhiteShares = {{{0.4124564 / 0.9504700, 0.3575761 / 0.9504700, 0.1804375 / 0.9504700},
                                       {0.2126729, 0.7151522, 0.0721750},
                                       {0.0193339 / 1.0888300, 0.1191920 / 1.0888300, 0.9503041 / 1.0888300}}};

constexpr LightMatrix inverse_of(const LightMatrix& m) {
    LightMatrix out{};
    const double determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                               m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column) {
            const std::size_t r1 = (column + 1) % 3, r2 = (column + 2) % 3, c1 = (row + 1) % 3, c2 = (row + 2) % 3;
            out[row][column] = (m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]) / determinant;
        }
    return out;
}
constexpr LightMatrix kLightOfShares = inverse_of(kWhiteShares);

/// A number a pixel.
struct ChannelPlane {
    std::int64_t width, height;
    std::vector<double> values;

    ChannelPlane(std::int64_t w, std::int64_t h) : width(w), height(h), values(static_cast<std::size_t>(w * h)) {}
    [[nodiscard]] double at(std::int64_t x, std::int64_t y) const { return values[static_cast<std::size_t>(y * width + x)]; }
    double& at(std::int64_t x, std::int64_t y) { return values[static_cast<std::size_t>(y * width + x)]; }
};

/// The opponent channels YCxCz of a picture: lightness 0..100, red against green, yellow against blue; linear in the light.
using OpponentPicture = std::array<ChannelPlane, 3>;

OpponentPicture opponents_of(const RgbaView& view) {
    const ChannelPlane empty(view.width, view.height);
    OpponentPicture picture = {empty, empty, empty};
    for (std::uint32_t y = 0; y < view.height; ++y)
        for (std::uint32_t x = 0; x < view.width; ++x) {
            const std::uint8_t* const p = view.row(y) + std::size_t{x} * 4;
            const LinearRgb light = design::linear_rgb({p[0], p[1], p[2]});
            std::array<double, 3> shares{};
            for (std::size_t n = 0; n < 3; ++n)
                shares[n] = kWhiteShares[n][0] * light.red + kWhiteShares[n][1] * light.green + kWhiteShares[n][2] * light.blue;
            picture[0].at(x, y) = 116 * shares[1] - 16;
            picture[1].at(x, y) = 500 * (shares[0] - shares[1]);
            picture[2].at(x, y) = 200 * (shares[1] - shares[2]);
        }
    return picture;
}

/// Weights at -r..r.
using EyeKernel = std::vector<double>;

template <class WeightAt>
EyeKernel eye_kernel(int radius, WeightAt weight_at) {
    EyeKernel weights;
    for (int n = -radius; n <= radius; ++n) weights.push_back(weight_at(static_cast<double>(n)));
    return weights;
}

EyeKernel scaled_to_one(EyeKernel weights) {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double& weight : weights) weight /= sum;
    return weights;
}

/// The positive weights sum to 1, the negative ones to -1.
EyeKernel balanced(EyeKernel weights) {
    double positive = 0, negative = 0;
    for (const double weight : weights) (weight > 0 ? positive : negative) += weight;
    for (double& weight : weights) weight /= weight > 0 ? positive : -negative;
    return weights;
}

/// The picture goes on beyond its border as it ends there.
ChannelPlane filtered_plane(const ChannelPlane& plane, const EyeKernel& across, const EyeKernel& down) {
    const auto radius_of = [](const EyeKernel& weights) { return static_cast<std::int64_t>(weights.size() / 2); };
    ChannelPlane rows(plane.width, plane.height), both(plane.width, plane.height);
    const std::int64_t across_radius = radius_of(across), down_radius = radius_of(down);
    for (std::int64_t y = 0; y < plane.height; ++y)
        for (std::int64_t x = 0; x < plane.width; ++x) {
            double sum = 0;
            for (std::int64_t n = -across_radius; n <= across_radius; ++n)
                sum += across[static_cast<std::size_t>(n + across_radius)] *
                       plane.at(std::clamp<std::int64_t>(x + n, 0, plane.width - 1), y);
            rows.at(x, y) = sum;
        }
    for (std::int64_t y = 0; y < plane.height; ++y)
        for (std::int64_t n = -down_radius; n <= down_radius; ++n) {
            const double weight = down[static_cast<std::size_t>(n + down_radius)];
            const std::int64_t row = std::clamp<std::int64_t>(y + n, 0, plane.height - 1);
            for (std::int64_t x = 0; x < plane.width; ++x) both.at(x, y) += weight * rows.at(x, row);
        }
    return both;
}

/// The eye's sensitivity to contrast, as a sum of two Gaussians over the angle (table 1 of the paper): a * sqrt(pi / b) *
/// exp(-pi^2 x^2 / b) each.
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr std::array<Sensitivity, 3> kSensitivities = {{{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}}};
constexpr double kWidestB = 0.04;

ChannelPlane as_seen(const ChannelPlane& plane, const Sensitivity& eye, ViewingDistance distance) {
    const double pixels = distance.pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(kWidestB / (2 * kPi * kPi)) * pixels));
    const auto gaussian = [&](double b) {
        return eye_kernel(radius, [&](double n) { return std::exp(-kPi * kPi * (n / pixels) * (n / pixels) / b); });
    };
    const auto volume = [&](double a, double b) {
        const EyeKernel weights = gaussian(b);
        const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
        return a * std::sqrt(kPi / b) * sum * sum;
    };
    const EyeKernel first = scaled_to_one(gaussian(eye.b1));
    ChannelPlane seen = filtered_plane(plane, first, first);
    if (eye.a2 == 0) return seen;
    const double share = volume(eye.a1, eye.b1) / (volume(eye.a1, eye.b1) + volume(eye.a2, eye.b2));
    const EyeKernel second = scaled_to_one(gaussian(eye.b2));
    const ChannelPlane other = filtered_plane(plane, second, second);
    for (std::size_t n = 0; n < seen.values.size(); ++n) seen.values[n] = share * seen.values[n] + (1 - share) * other.values[n];
    return seen;
}

/// L*a*b* whose colours count less in the dark (Hunt).
Lab hunt_adjusted(Lab color) {
    const double weight = 0.01 * color.lightness;
    return {color.lightness, weight * color.a, weight * color.b};
}

/// Of large differences in colour: lightness and colour by themselves (HyAB).
double hyab(const Lab& first, const Lab& second) {
    return std::fabs(first.lightness - second.lightness) + std::hypot(first.a - second.a, first.b - second.b);
}

Lab seen_color(const OpponentPicture& seen, std::size_t pixel) {
    const double y = (seen[0].values[pixel] + 16) / 116;
    const std::array<double, 3> shares = {y + seen[1].values[pixel] / 500, y, y - seen[2].values[pixel] / 200};
    std::array<double, 3> light{};
    for (std::size_t n = 0; n < 3; ++n)
        light[n] = std::clamp(
            kLightOfShares[n][0] * shares[0] + kLightOfShares[n][1] * shares[1] + kLightOfShares[n][2] * shares[2], 0.0, 1.0);
    return hunt_adjusted(design::lab_of({light[0], light[1], light[2]}));
}

/// 0..1; the largest difference is that of green and blue.
double color_share(const Lab& first, const Lab& second) {
    static const double greatest =
        std::pow(hyab(hunt_adjusted(design::lab_of({0, 1, 0})), hunt_adjusted(design::lab_of({0, 0, 1}))), kColorExponent);
    const double difference = std::pow(hyab(first, second), kColorExponent), knee = kLowPart * greatest;
    if (difference < knee) return kLowShare / knee * difference;
    return kLowShare + (difference - knee) / (greatest - knee) * (1 - kLowShare);
}

/// How strong edges and points are at each pixel.
struct EyeFeatures {
    ChannelPlane edges, points;
};

ChannelPlane lengths(const ChannelPlane& across, const ChannelPlane& down) {
    ChannelPlane both(across.width, across.height);
    for (std::size_t n = 0; n < both.values.size(); ++n) both.values[n] = std::hypot(across.values[n], down.values[n]);
    return both;
}

EyeFeatures features_of(const ChannelPlane& opponent, ViewingDistance distance) {
    ChannelPlane lightness = opponent;
    for (double& value : lightness.values) value = (value + 16) / 116;
    const double deviation = 0.5 * kEdgeWidth_deg * distance.pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    const auto bell = [&](double n) { return std::exp(-n * n / (2 * deviation * deviation)); };
    const EyeKernel along = scaled_to_one(eye_kernel(radius, bell));
    const EyeKernel edge = balanced(eye_kernel(radius, [&](double n) { return -n * bell(n); }));
    const EyeKernel point =
        balanced(eye_kernel(radius, [&](double n) { return (n * n / (deviation * deviation) - 1) * bell(n); }));
    return {lengths(filtered_plane(lightness, edge, along), filtered_plane(lightness, along, edge)),
            lengths(filtered_plane(lightness, point, along), filtered_plane(lightness, along, point))};
}

double feature_share(const EyeFeatures& first, const EyeFeatures& second, std::size_t pixel) {
    const double edges = std::fabs(first.edges.values[pixel] - second.edges.values[pixel]);
    const double points = std::fabs(first.points.values[pixel] - second.points.values[pixel]);
    return std::pow(std::min(std::max(edges, points) / std::sqrt(2.0), 1.0), kFeatureExponent);
}

OpponentPicture as_seen(const OpponentPicture& picture, ViewingDistance distance) {
    return {as_seen(picture[0], kSensitivities[0], distance), as_seen(picture[1], kSensitivities[1], distance),
            as_seen(picture[2], kSensitivities[2], distance)};
}

}  // namespace

PerceptualDifference perceptual_difference(const RgbaView& first, const RgbaView& second, ViewingDistance distance) {
    if (first.width != second.width || first.height != second.height)
        throw UserError("pictures of different sizes cannot be compared");
    const OpponentPicture a = opponents_of(first), b = opponents_of(second);
    const OpponentPicture seen_a = as_seen(a, distance), seen_b = as_seen(b, distance);
    const EyeFeatures features_a = features_of(a[0], distance), features_b = features_of(b[0], distance);
    PerceptualDifference found{first.width, first.height, std::vector<double>(a[0].values.size()), 0};
    for (std::size_t n = 0; n < found.map.size(); ++n) {
        const double color = color_share(seen_color(seen_a, n), seen_color(seen_b, n));
        found.map[n] = std::pow(color, 1 - feature_share(features_a, features_b, n));
    }
    if (!found.map.empty())
        found.mean = std::accumulate(found.map.begin(), found.map.end(), 0.0) / static_cast<double>(found.map.size());
    return found;
}

}  // namespace tedavis::host_sim
