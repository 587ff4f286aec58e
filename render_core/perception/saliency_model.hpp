/// Visual saliency: the model of Itti, Koch and Niebur in the thesis's variant (5.3.3, Itti-CIO2). Lightness, the two colour
/// axes of CIE-Lab and four directions are compared with their surroundings across scales and weighted by how rare and how
/// strong they are (conspicuity.hpp).
///
/// The map has one pixel for 4 x 4 pixels of the picture (the finest centre is two levels below it); where the smaller side has
/// fewer than 64 pixels one for 2 x 2, below 32 one for each pixel. The pyramid ends at one pixel, the mean.
///
/// A start level of 0 converts each pixel to CIE-Lab: the reference. 1 and 2 convert means of 2 x 2 or 4 x 4 pixels instead and
/// omit the finer levels; README.md states the error and the time saved.
///
/// Equal pictures give equal maps; maps of two machines may differ in the last digits of their libraries' pow and log2.
/// Memory  from an arena, at start(). Thread  one. Bounded by the pixels.
///
/// Source: L. Itti, C. Koch, E. Niebur, "A Model of Saliency-Based Visual Attention for Rapid Scene Analysis", IEEE PAMI 20
/// (1998); B. Han, B. Zhou, "High Speed Visual Saliency Computation on GPU", ICIP 2007.
#pragma once

#include <array>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/span.hpp"
#include "render_core/perception/center_surround.hpp"
#include "render_core/perception/conspicuity.hpp"
#include "render_core/perception/lab_planes.hpp"
#include "render_core/perception/oriented_energy.hpp"
#include "render_core/perception/picture_view.hpp"

namespace tedavis::perception {

/// A saliency map. Its values are owned by the model and valid until the next map.
struct SaliencyMap {
    base::Span<const float> values;  ///< 0..1, rows from the top
    int width = 0, height = 0;
    int level = 0;  ///< a pixel is 2^level of the picture's across and down
    SaliencyScale scale = SaliencyScale::per_picture;
    bool has_salient = false;  ///< false: the picture is uniform, and all values are 0
};

/// Returns SaliencyMap::level for a picture of this size, 0..2.
[[nodiscard]] int saliency_level(int width, int height) noexcept;

class SaliencyModel {
public:
    /// Bytes that start() allocates. A start level of 0 takes thirteen bytes per pixel more than 2.
    [[nodiscard]] static std::size_t bytes(int most_width, int most_height, int least_start_level);
    [[nodiscard]] bool start(base::Arena& arena, int most_width, int most_height, int least_start_level);

    /// Computes the features, from which map() makes a map on either scale. A start level above the map's own level is reduced
    /// to it. Returns false where the picture is not valid or larger than at start(), or the start level is lower than at
    /// start().
    [[nodiscard]] bool look(const PictureView& picture, int start_level);
    /// Returns the map of the last picture.
    [[nodiscard]] SaliencyMap map(SaliencyScale scale);

private:
    void lay_out(int width, int height, int start_level);
    void build_pyramid(const Plane& base);
    void measure_color(const Plane& base, int first_map);
    void measure_directions();

    int most_width_ = 0, most_height_ = 0, least_start_level_ = 0;
    int start_level_ = 0, level_ = 0;
    GaborTaps taps_;
    LabConversion lab_;
    base::Span<float> room_, scratch_;
    LabPlanes colors_;        ///< of the start level
    Plane between_;           ///< where the map is two levels coarser, the one between
    FeaturePyramid feature_;  ///< of one feature at a time
    std::array<FeaturePyramid, kDirections> direction_;
    std::array<CenterPlanes, 2> centers_;  ///< coarser planes: scratch of one feature
    SaliencyMaps maps_;
    bool has_looked_ = false;
};

}  // namespace tedavis::perception
