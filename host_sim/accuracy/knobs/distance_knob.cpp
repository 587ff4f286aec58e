#include "host_sim/accuracy/knobs/distance_knob.hpp"

#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>

#include "host_sim/scenario/seeded_random.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using earth::Geodetic;

constexpr double kMinApart_m = 10, kMaxApart_m = 400'000, kMaxPairLatitude_deg = 89;
constexpr std::size_t kPairsOfSample = 1024, kPairSamples = 32, kQuickPairSamples = 8;

/// A point of the geodesic's auxiliary sphere, after Vincenty.
template <class Real>
struct OnSphere {
    Real sine_u1, cosine_u1, sine_u2, cosine_u2;
    Real sine_sigma = 0, cosine_sigma = 1, sigma = 0, sine_alpha = 0, cosine2_alpha = 1, cosine_2m = 0;

    void turn_to(Real lambda) {
        const Real across = cosine_u2 * std::sin(lambda);
        const Real along = cosine_u1 * sine_u2 - sine_u1 * cosine_u2 * std::cos(lambda);
        sine_sigma = std::hypot(across, along);
        cosine_sigma = sine_u1 * sine_u2 + cosine_u1 * cosine_u2 * std::cos(lambda);
        sigma = std::atan2(sine_sigma, cosine_sigma);
        sine_alpha = sine_sigma > 0 ? cosine_u1 * cosine_u2 * std::sin(lambda) / sine_sigma : Real{0};
        cosine2_alpha = 1 - sine_alpha * sine_alpha;
        cosine_2m = cosine2_alpha > 0 ? cosine_sigma - 2 * sine_u1 * sine_u2 / cosine2_alpha : Real{0};
    }
    /// Longitude on the sphere less that on the ellipsoid.
    [[nodiscard]] Real longitude_excess() const {
        const Real f = earth::kFlattening;
        const Real c = f / 16 * cosine2_alpha * (4 + f * (4 - 3 * cosine2_alpha));
        return (1 - c) * f * sine_alpha *
               (sigma + c * sine_sigma * (cosine_2m + c * cosine_sigma * (2 * cosine_2m * cosine_2m - 1)));
    }
    [[nodiscard]] Real length_m() const {
        const Real a = earth::kSemiMajorAxis_m, b = a * (1 - static_cast<Real>(earth::kFlattening));
        const Real u2 = cosine2_alpha * (a * a - b * b) / (b * b);
        const Real big_a = 1 + u2 / 16384 * (4096 + u2 * (-768 + u2 * (320 - 175 * u2)));
        const Real big_b = u2 / 1024 * (256 + u2 * (-128 + u2 * (74 - 47 * u2)));
        const Real twice = 2 * cosine_2m * cosine_2m - 1;
        const Real sides = cosine_sigma * twice - big_b / 6 * cosine_2m * (4 * sine_sigma * sine_sigma - 3) * (2 * twice - 1);
        return b * big_a * (sigma - big_b * sine_sigma * (cosine_2m + big_b / 4 * sides));
    }
};

template <class Real>
Real vincenty_m(const Geodetic& from, const Geodetic& to) {
    constexpr int kMaxTurns = 30;
    const auto reduced = [](double latitude_rad) {
        return std::atan((1 - static_cast<Real>(earth::kFlattening)) * std::tan(static_cast<Real>(latitude_rad)));
    };
    const Real u1 = reduced(from.latitude_rad), u2 = reduced(to.latitude_rad);
    const Real longitude = earth::angle_difference(to.longitude_rad, from.longitude_rad);
    OnSphere<Real> sphere{std::sin(u1), std::cos(u1), std::sin(u2), std::cos(u2)};
    Real lambda = longitude, before = 0;
    for (int n = 0; n < kMaxTurns && (n == 0 || std::abs(lambda - before) > std::numeric_limits<Real>::epsilon()); ++n) {
        sphere.turn_to(lambda);
        before = lambda;
        lambda = longitude + sphere.longitude_excess();
    }
    return sphere.length_m();
}

double haversine_m(const Geodetic& from, const Geodetic& to) {
    const double north = std::sin(0.5 * (to.latitude_rad - from.latitude_rad));
    const double east = std::sin(0.5 * (to.longitude_rad - from.longitude_rad));
    const double square = north * north + std::cos(from.latitude_rad) * std::cos(to.latitude_rad) * east * east;
    return 2 * earth::kMeanRadius_m * std::asin(std::sqrt(square));
}

double plane_m(const Geodetic& from, const Geodetic& to) {
    const double latitude = 0.5 * (from.latitude_rad + to.latitude_rad);
    const double north_m = earth::meridian_radius_m(latitude) * (to.latitude_rad - from.latitude_rad);
    const double east_m = earth::prime_vertical_radius_m(latitude) * std::cos(latitude) *
                          earth::angle_difference(to.longitude_rad, from.longitude_rad);
    return std::hypot(north_m, east_m);
}

struct DistanceLevel {
    const char* name;
    double (*distance_m)(const Geodetic& from, const Geodetic& to);
};
constexpr DistanceLevel kDistanceLevels[] = {
    {"arc over the chord", earth::surface_distance_m},
    {"plane at the middle latitude", plane_m},
    {"haversine of the mean sphere", haversine_m},
    {"Vincenty's iteration", vincenty_m<double>},
};

KnobFacts surface_distance_facts() {
    std::vector<KnobLevel> levels;
    for (const DistanceLevel& level : kDistanceLevels) levels.push_back({level.name, 0});
    return {"surface_distance",
            "Distance along the surface of the Earth",
            "earth::surface_distance_m() of legs, cues along a trajectory and imported flights",
            "difference from the geodesic's length, of places 10 m to 400 km apart",
            "m",
            {"the geodesic after Vincenty, iterated in long double", 1e-5,
             "its series leave out less than 1e-10 of the length; a test compares it with GeographicLib"},
            "GeographicLib::Geodesic (tests/host_sim/accuracy, tests/render_core/earth)",
            "Heights above the terrain come from the database's own triangles and no distance.",
            "no scale: four formulas",
            std::nullopt,
            std::move(levels),
            "a millionth of the distance is more than a display or a log states, and the chord has neither a pole nor an "
            "iteration"};
}

struct PlacePair {
    Geodetic from, to;
};

/// On the mean sphere; the true distance follows from the places.
PlacePair pair_of(SeededRandom& numbers) {
    PlacePair pair;
    pair.from.latitude_rad = base::radians(numbers.within(0, kMaxPairLatitude_deg));
    pair.from.longitude_rad = numbers.within(0, base::kPi);
    const double angle = kMinApart_m * std::pow(kMaxApart_m / kMinApart_m, numbers.unit()) / earth::kMeanRadius_m;
    const double azimuth = numbers.within(0, base::kPi), sine = std::sin(pair.from.latitude_rad);
    const double north = std::cos(pair.from.latitude_rad) * std::sin(angle) * std::cos(azimuth);
    pair.to.latitude_rad = std::asin(sine * std::cos(angle) + north);
    const double east = std::sin(azimuth) * std::sin(angle) * std::cos(pair.from.latitude_rad);
    const double turn = std::atan2(east, std::cos(angle) - sine * std::sin(pair.to.latitude_rad));
    pair.to.longitude_rad = earth::wrap_longitude(pair.from.longitude_rad + turn);
    return pair;
}

class SurfaceDistanceKnob final : public Knob {
public:
    explicit SurfaceDistanceKnob(const KnobGround& ground) : Knob(surface_distance_facts()) {
        SeededRandom numbers(21);
        const std::size_t count = kPairsOfSample * (ground.is_quick ? kQuickPairSamples : kPairSamples);
        for (std::size_t n = 0; n < count; ++n) pairs_.push_back(pair_of(numbers));
    }

    [[nodiscard]] std::size_t samples() const override { return pairs_.size() / kPairsOfSample; }
    void run(std::size_t level, std::size_t sample) override {
        for (std::size_t n = 0; n < kPairsOfSample; ++n) {
            const PlacePair& pair = pairs_[sample * kPairsOfSample + n];
            found_m_ += kDistanceLevels[level].distance_m(pair.from, pair.to);
        }
    }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        for (std::size_t n = 0; n < kPairsOfSample; ++n) {
            const PlacePair& pair = pairs_[sample * kPairsOfSample + n];
            const double distance_m = kDistanceLevels[level].distance_m(pair.from, pair.to);
            errors.push_back(std::abs(distance_m - distance_by_vincenty_m(pair.from, pair.to)));
        }
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        const PlacePair& pair = pairs_[sample * kPairsOfSample + error];
        char text[120];
        std::snprintf(text, sizeof text, "latitude %.4f, longitude %.4f to %.4f, %.4f", base::degrees(pair.from.latitude_rad),
                      base::degrees(pair.from.longitude_rad), base::degrees(pair.to.latitude_rad),
                      base::degrees(pair.to.longitude_rad));
        return text;
    }

private:
    std::vector<PlacePair> pairs_;
    double found_m_ = 0;  ///< so that no compiler leaves the distances out
};

}  // namespace

double distance_by_vincenty_m(const Geodetic& from, const Geodetic& to) {
    return static_cast<double>(vincenty_m<long double>(from, to));
}

std::unique_ptr<Knob> make_surface_distance_knob(const KnobGround& ground) {
    return std::make_unique<SurfaceDistanceKnob>(ground);
}

}  // namespace tedavis::host_sim
