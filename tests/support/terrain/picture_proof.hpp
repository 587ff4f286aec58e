/// Holds pictures of terrain against the full raster: skylines, and background where there should be ground.
#pragma once

#include "tests/support/terrain/hard_poses.hpp"
#include "tests/support/terrain/terrain_picture.hpp"
#include "tests/support/terrain/true_view.hpp"

namespace tedavis::test_support {

struct PictureProof {
    int pictures = 0, met = 0, columns = 0;
    int unsettled = 0;              ///< pictures for which something never arrived
    int too_high = 0, too_low = 0;  ///< columns whose skyline is off by more than the stated error and half a pixel
    int below_true = 0;             ///< columns whose skyline is below the true one by more than rasterising explains
    int cracks = 0;                 ///< background pixels where the raster has ground
    double worst_px = 0;            ///< of columns, beyond half a pixel
    std::uint32_t worst_pose = 0;

    /// Draws a pose's view as large as the display, and leaves it out where void ground is in it. `turned_px` moves the true
    /// skyline sideways: the control. Returns the background pixels that are enclosed by ground.
    int include(HeadlessDisplay& headless, const GdalTerrain& truth, const HardPose& pose, std::uint32_t number,
                int turned_px = 0) {
        const terrain::View view = resized(pose.view, headless.surface().width(), headless.surface().height());
        const TerrainPicture picture(headless, view, truth.middle());
        if (shows_void(picture)) return 0;
        include(picture, TrueView(truth, view), number, turned_px);
        return picture.enclosed_background();
    }
    void include(const TerrainPicture& picture, const TrueView& seen, std::uint32_t number, int turned_px = 0) {
        const display::TerrainRecord& terrain = picture.record().terrain;
        ++pictures;
        met += terrain.limit.view() == "met" ? 1 : 0;
        unsettled += terrain.limit.view() == "not_arrived" ? 1 : 0;
        for (int column = 2; column < picture.width() - 2; ++column)
            include_column(picture, seen, terrain.tau_reached_px, column, turned_px, number);
        include_cracks(picture, seen, static_cast<int>(std::ceil(terrain.tau_reached_px)) + 1);
    }
    [[nodiscard]] std::string text() const {
        return std::to_string(pictures) + " pictures, " + std::to_string(met) + " met tau, " + std::to_string(columns) +
               " columns: " + std::to_string(too_high) + " too high, " + std::to_string(too_low) + " too low, worst " +
               std::to_string(worst_px) + " px and half a pixel (pose " + std::to_string(worst_pose) + "); " +
               std::to_string(below_true) + " below the true one; " + std::to_string(cracks) + " pixels of cracks";
    }

private:
    /// Ground without data is drawn, is no part of the true surface and hides what lies behind it.
    [[nodiscard]] static bool shows_void(const TerrainPicture& picture) {
        for (const display::Name& flag : picture.record().flags)
            if (flag.view() == "terrain.void") return true;
        return false;
    }

    static constexpr double kRasterising_px = 0.02;

    void include_column(const TerrainPicture& picture, const TrueView& seen, double reach_px, int column, int turned_px,
                        std::uint32_t pose) {
        const double bottom = picture.height(), truth = std::max(seen.at_centre(column + turned_px), 0.0);
        const double drawn = picture.skyline(column).value_or(picture.height());
        ++columns;
        // A covered pixel's centre is on or below the drawn skyline, that of the pixel above it is not.
        if (drawn < bottom && drawn + 0.5 < seen.highest_within(column + turned_px, reach_px) - kRasterising_px) ++too_high;
        const int reach = static_cast<int>(std::ceil(reach_px));
        double highest = drawn;
        for (int n = -std::min(reach, column); n <= std::min(reach, picture.width() - 1 - column); ++n)
            highest = std::min<double>(highest, picture.skyline(column + n).value_or(picture.height()));
        if (truth + reach_px + 0.5 < bottom && highest - 0.5 > truth + reach_px + kRasterising_px) ++too_low;
        const double lowest = seen.lowest_at_centre(column + turned_px);
        if (lowest + 0.5 < bottom && drawn - 0.5 > std::max(lowest, 0.0) + kRasterising_px) ++below_true;
        const double off_px = truth < bottom && drawn < bottom ? std::abs(drawn - truth) - 0.5 : 0;
        if (off_px > worst_px) worst_px = off_px, worst_pose = pose;
    }
    void include_cracks(const TerrainPicture& picture, const TrueView& truth, int margin) {
        for (int column = 0; column < picture.width(); ++column)
            for (int row = 0; row < picture.height(); ++row)
                if (picture.is_background(column, row) && truth.covers(column, row, margin)) ++cracks;
    }
};

/// Poses inside the terrain that look level, or nearly: those have a skyline. From outside, the last slopes may turn their back.
[[nodiscard]] inline bool has_skyline(PoseKind kind) {
    switch (kind) {
        case PoseKind::random:
        case PoseKind::random_low:
        case PoseKind::on_the_ground:
        case PoseKind::in_a_valley:
        case PoseKind::on_a_peak:
        case PoseKind::in_a_box:
        case PoseKind::over_a_corner:
        case PoseKind::over_an_edge:
        case PoseKind::along_the_horizon: return true;
        default: return false;
    }
}

}  // namespace tedavis::test_support
