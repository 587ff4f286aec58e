/// Wind as vectors, and what may be said of several together.
///
/// Directions are where the wind comes from, clockwise from true north, as charts have them. Means are of vectors, so that a
/// direction is a mean by speed (Mardia and Jupp, Directional Statistics, 2000, section 2.2); where the vectors cancel, or there
/// is next to none, there is no direction. Pure functions; any thread.
#pragma once

#include <cstdint>

namespace tedavis::scene {

enum class WindState : std::uint8_t {
    steady,
    calm,      ///< below kCalm_mps: no direction
    variable,  ///< directions cancel each other: no direction
    unknown,   ///< nothing but what is not a number
};

inline constexpr double kCalm_mps = 0.5 * 1852.0 / 3600.0;  ///< half a knot
inline constexpr double kMinConstancy = 0.05;               ///< resultant over mean speed, below which it is variable

struct Wind {
    WindState state = WindState::unknown;
    double from_rad = 0;   ///< [0, 2 pi); of steady wind only
    double speed_mps = 0;  ///< mean speed, whatever the directions
    double constancy = 0;  ///< 0..1: how well the directions agree
};

/// Of one vector, blowing towards east and north.
[[nodiscard]] Wind wind_of(double east_mps, double north_mps) noexcept;

/// Of several vectors, by their mean vector and their mean speed.
[[nodiscard]] Wind wind_of_means(double east_mps, double north_mps, double speed_mps) noexcept;

/// Sums vectors; the order does not matter but for rounding.
class WindMean {
public:
    /// A vector with a number that is not finite is left out and counted.
    void add(double east_mps, double north_mps) noexcept;
    [[nodiscard]] Wind mean() const noexcept;
    [[nodiscard]] std::uint32_t count() const noexcept { return count_; }
    [[nodiscard]] std::uint32_t left_out() const noexcept { return left_out_; }
    /// Mean vector; zeros of none.
    [[nodiscard]] double east_mps() const noexcept { return count_ > 0 ? east_ / count_ : 0; }
    [[nodiscard]] double north_mps() const noexcept { return count_ > 0 ? north_ / count_ : 0; }

private:
    double east_ = 0, north_ = 0, speed_ = 0;
    std::uint32_t count_ = 0, left_out_ = 0;
};

/// Along a track and across it: head wind positive from ahead, cross wind positive from the right.
struct TrackWind {
    double head_mps = 0, cross_mps = 0;
};
[[nodiscard]] TrackWind along_track(double east_mps, double north_mps, double track_rad) noexcept;

}  // namespace tedavis::scene
