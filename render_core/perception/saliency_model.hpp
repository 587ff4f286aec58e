/// What draws the eye: the model of Itti, Koch and Niebur as the thesis has it (5.3.3, Itti-CIO2): lightness, two colours of
/// CIE-Lab and four directions, compared with their surroundings across scales, weighted by how rare and how strong they are
/// (conspicuity.hpp).
///
/// The map has a pixel for each 4 x 4 of the picture (the finest centre is two levels below it); where the smaller side has fewer
/// than 64 pixels one for 2 x 2, below 32 for each. Levels end at one pixel: whatever is smaller is compared with the mean.
///
/// A start level of 0 converts each pixel to CIE-Lab: the reference. 1 and 2 convert means of 2 x 2 or 4 x 4 pixels' levels
/// instead, and leave out the levels below; README.md says what that costs and saves.
///
/// Equal pictures give equal maps; those of two machines differ by the last places of their libraries' pow and log2.
/// Memory from an arena, at start(). One thread. Bounded by the pixels.
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

/// Lies in the model that made it, until its next map.
struct SaliencyMap {
    base::Span<const float> values;  ///< 0..1, rows from the top
    int width = 0, height = 0;
    int level = 0;  ///< a pixel is 2^level of the picture's across and down
    SaliencyScale scale = SaliencyScale::per_picture;
    bool has_salient = false;  ///< false: nothing differs from anything, and all values are 0
};

/// Of the map of a picture of that size: 0..2.
[[nodiscard]] int saliency_level(int width, int height) noexcept;

class SaliencyModel {
public:
    /// Memory that start() takes. A start level of 0 takes thirteen bytes a pixel more than 2 does.
    [[nodiscard]] static std::size_t bytes(int most_width, int most_height, int least_start_level);
    [[nodiscard]] bool start(base::Arena& arena, int most_width, int most_height, int least_start_level);

    /// Finds the features; map() makes a map of them, on either scale. A start level above the map's own is that. False where the
    /// picture is not valid or larger than at start, or the start level less than there.
    [[nodiscard]] bool look(const PictureView& picture, int start_level);
    /// Of the last picture.
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
