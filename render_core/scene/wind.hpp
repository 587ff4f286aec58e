/// Wind vectors and their means.
///
/// Directions are those the wind comes from, clockwise from true north. Means are vector means, so directions are weighted by
/// speed (Mardia and Jupp, Directional Statistics, 2000, section 2.2); where the vectors cancel or are nearly zero, there is no
/// direction. Pure functions; any thread.
#pragma once

#include <cstdint>

namespace tedavis::scene {

enum class WindState : std::uint8_t {
    steady,
    calm,      ///< below kCalm_mps: no direction
    variable,  ///< directions cancel each other: no direction
    unknown,   ///< there is no finite value
};

inline constexpr double kCalm_mps = 0.5 * 1852.0 / 3600.0;  ///< half a knot
inline constexpr double kMinConstancy = 0.05;               ///< resultant over mean speed; below it the wind is variable

struct Wind {
    WindState state = WindState::unknown;
    double from_rad = 0;   ///< [0, 2 pi); valid for steady wind only
    double speed_mps = 0;  ///< mean speed, regardless of direction
    double constancy = 0;  ///< 0..1, agreement of the directions
};

/// Returns the wind of one vector, given by its components towards east and north.
[[nodiscard]] Wind wind_of(double east_mps, double north_mps) noexcept;

/// Returns the wind of several vectors from their mean vector and their mean speed.
[[nodiscard]] Wind wind_of_means(double east_mps, double north_mps, double speed_mps) noexcept;

/// Averages vectors; their order only affects rounding.
class WindMean {
public:
    /// Adds a vector; one with a component that is not finite is left out and counted.
    void add(double east_mps, double north_mps) noexcept;
    [[nodiscard]] Wind mean() const noexcept;
    [[nodiscard]] std::uint32_t count() const noexcept { return count_; }
    [[nodiscard]] std::uint32_t left_out() const noexcept { return left_out_; }
    /// Mean vector; zero where there are no vectors.
    [[nodiscard]] double east_mps() const noexcept { return count_ > 0 ? east_ / count_ : 0; }
    [[nodiscard]] double north_mps() const noexcept { return count_ > 0 ? north_ / count_ : 0; }

private:
    double east_ = 0, north_ = 0, speed_ = 0;
    std::uint32_t count_ = 0, left_out_ = 0;
};

/// Wind components along a track: head wind positive from ahead, cross wind positive from the right.
struct TrackWind {
    double head_mps = 0, cross_mps = 0;
};
[[nodiscard]] TrackWind along_track(double east_mps, double north_mps, double track_rad) noexcept;

}  // namespace tedavis::scene
