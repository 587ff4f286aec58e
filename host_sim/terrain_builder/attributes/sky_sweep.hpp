/// Visibility from posts: the search of horizons in 16 directions, and integrals over its results.
#pragma once

#include <array>
#include <cstddef>

#include "host_sim/terrain_builder/attributes/direct_light.hpp"
#include "host_sim/terrain_builder/attributes/far_horizons.hpp"
#include "host_sim/terrain_builder/attributes/row_directions.hpp"

namespace tedavis::host_sim {

/// The openness of level ground without a horizon, radians.
inline constexpr float kHalfPi = 1.57079632679f;

/// Results for four neighbouring posts.
struct SkyLanes {
    Lanes horizon[terrain::kHorizonDirections];  ///< tangent of the horizon's elevation, not below 0
    Lanes sky_view, aperture_east, aperture_north, aperture_cosine, openness_above, openness_below;
    Lanes bounce;  ///< light from the ground in view, for ground of albedo 1 under a beam of strength 1
};

/// Definitions. With H the zenith angle of the limit of the sky in a direction - the highest of the terrain's horizon, the
/// horizontal and the post's own tangent plane - and n the normal:
/// - sky view is the part of an isotropic sky's irradiance that arrives, the mean over azimuths of n_up sin²H +
///   (n_h · u)(H - sin H cos H): Dozier and Frew, "Rapid Calculation of Terrain Parameters for Radiation Modeling", IEEE
///   Trans. Geosci. Remote Sensing 28(5), 1990. Level open ground has exactly 1, an open plane of slope s (1 + cos s)/2.
/// - the aperture is the direction of the mean of all unit vectors to the visible sky and the cap round it that has as much
///   solid angle, whose radius' cosine is the mean of cos H: Oat and Sander, "Ambient Aperture Lighting", I3D 2007. Where the
///   mean direction vanishes the normal stands for it.
/// - openness is the mean zenith (above) or nadir (below) angle within kHorizonReach posts: Yokoyama, Shirasawa, Pike,
///   "Visualizing Topography by Openness", PE&RS 68(3), 2002; Doneus, "Openness as Visualization Technique", Remote Sensing
///   5, 2013. The Earth is taken as flat here, so that level ground has 90° at every scale. Directions without any post do
///   not count.
/// - bounce gathers, strip by strip of elevation in each direction, the direct light on the post that bounds the strip,
///   weighted as the sky is above. Ground beyond the reach, and below the horizontal, is lit as level open ground.
class SkySweep {
public:
    /// All arguments must outlive this object. `direct` is direct_light(), `level_light` what it gives on level open ground.
    SkySweep(const HeightPlanes& planes, const Gradients& gradients, const HalfPlanes& direct, float level_light,
             const FarView& above);

    void begin_row(int row);
    /// For inner posts `column` to column + 3 of the row begun.
    void sweep(int column, SkyLanes& sky) const;

private:
    struct Found;
    struct Sums;
    [[nodiscard]] Found look(std::size_t direction, std::size_t at, std::size_t column) const;

    const HeightPlanes& planes_;
    const Gradients& gradients_;
    const HalfPlanes& direct_;
    const float level_light_;
    const std::array<SamplePlaces, terrain::kHorizonDirections> places_;
    std::array<RowDirection, terrain::kHorizonDirections> directions_;
    FarRow far_;
    int row_ = 0;
};

}  // namespace tedavis::host_sim
