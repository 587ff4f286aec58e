/// The skyline of a flight's picture, on a display of the garish design.
#pragma once

#include <optional>
#include <vector>

#include "render_core/display/preroll.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/terrain/raster_ray_caster.hpp"
#include "tests/support/terrain/terrain_picture.hpp"

namespace tedavis::test_support {

class SkylinePicture {
public:
    /// Draws the state twice: once to learn the own view, then from there without symbols.
    SkylinePicture(HeadlessDisplay& headless, const flight::AircraftState& state, base::Time now)
        : width_(headless.surface().width()), height_(headless.surface().height()) {
        display::Display& display = headless.display();
        display.planner().clear_free_view();
        display::preroll(display, {state, {}, now});
        display.planner().set_free_view(display.planned().picture.camera.view);
        rgba_ = settled_pixels(headless, state, now);
        record_ = display.record();
    }
    /// Row of the uppermost pixel that is no sky, from the top.
    [[nodiscard]] std::optional<int> skyline_px(int column) const {
        for (std::uint32_t row = 0; row < height_; ++row) {
            const std::uint8_t* p =
                rgba_.data() + (std::size_t{height_ - 1 - row} * width_ + static_cast<std::size_t>(column)) * 4;
            if (p[0] > 0) return static_cast<int>(row);
        }
        return std::nullopt;
    }
    /// The camera of the pose that the record states, at the design's field of view.
    [[nodiscard]] OracleCamera camera() const {
        const earth::Geodetic& place = record_.own_ship.position;
        const double undulation = host_sim::GeoidEgm96::installed().undulation(place.latitude_rad, place.longitude_rad).m;
        return {base::degrees(place.latitude_rad),
                base::degrees(place.longitude_rad),
                record_.altitude_msl_m + undulation,
                base::degrees(record_.heading_rad),
                base::degrees(record_.pitch_rad),
                base::degrees(record_.roll_rad),
                base::degrees(garish_design().view.horizontal_field_of_view_rad),
                double(width_),
                double(height_)};
    }
    [[nodiscard]] const display::FrameRecord& record() const { return record_; }

private:
    std::uint32_t width_, height_;
    std::vector<std::uint8_t> rgba_;
    display::FrameRecord record_;
};

}  // namespace tedavis::test_support
