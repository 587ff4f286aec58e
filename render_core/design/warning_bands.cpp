#include "render_core/design/warning_bands.hpp"

#include "render_core/base/units.hpp"

namespace tedavis::design {
namespace {

constexpr Color kGreen{0x00, 0x90, 0x20};

void add(WarningBands& bands, double lower_ft, double lower_gear_down_ft, Color color, double strength) noexcept {
    const bool added =
        bands.try_push_back({lower_ft * base::kMetresPerFoot, lower_gear_down_ft * base::kMetresPerFoot, color, strength});
    TEDAVIS_CHECK(added);
}

}  // namespace

WarningBands egpws_bands() noexcept {
    WarningBands bands;
    add(bands, 2000, 2000, kWarningGround, 0.75);
    add(bands, 1000, 1000, kCautionGround, 0.75);
    add(bands, -500, -250, kCautionGround, 0.45);
    add(bands, -1000, -1000, kGreen, 0.45);
    add(bands, -2000, -2000, kGreen, 0.22);
    return bands;
}

WarningBands garmin_bands() noexcept {
    WarningBands bands;
    add(bands, -100, -100, kWarningGround, 0.7);
    add(bands, -1000, -1000, kCautionGround, 0.55);
    return bands;
}

std::size_t first_band_out_of_order(const WarningBands& bands) noexcept {
    for (std::size_t i = 1; i < bands.size(); ++i)
        if (!(bands[i].lower_m < bands[i - 1].lower_m) || !(bands[i].lower_gear_down_m < bands[i - 1].lower_gear_down_m))
            return i;
    return bands.size();
}

std::size_t band_of(const WarningBands& bands, double terrain_above_aircraft_m, bool gear_down) noexcept {
    for (std::size_t i = 0; i < bands.size(); ++i)
        if (terrain_above_aircraft_m >= (gear_down ? bands[i].lower_gear_down_m : bands[i].lower_m)) return i;
    return bands.size();
}

}  // namespace tedavis::design
