/// The costs and the quality levels of one device on one machine: a calibration file that `tedavis calibrate` writes, and
/// `tedavis-display --calibrate` on a board (calibration_text.hpp).
///
///     device = "es3-mid"              name in the device file
///     renderer = "llvmpipe (...)"     as the driver calls itself
///     width_px = 1024                 of the picture
///     height_px = 768
///     date = "2026-11-22T22:57:48Z"   when it was measured; read, but not checked
///     [cost.terrain]                  one table for every effect of effect_table.cpp, and for each of kOverheadNames; `rays` may
///                                     be missing: it was not measured then
///     fixed_ms = 0.4                  the three of them from 0 on
///     ms_per_megapixel = 6.1
///     ms_per_thousand = 0.03
///     [[quality]]                     one table for every quality level, at most kQualityLevelCount, the richest one first
///     tau_factor = 2.5                the six of them as in QualityLevel
///     detail_factor = 0.5
///     given_up = ["antialiasing"]     names of effects that may be given up
///     ms = 21.4
///     error_px = 2.31                 the proven bound of the drawn terrain's error
///     error_color = 0.84
///
/// Memory  reading allocates (start-up only); the result is plain data. Failure  one sentence with file and line.
#pragma once

#include "render_core/base/config_reader.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/result.hpp"
#include "render_core/effects/quality_level.hpp"

namespace tedavis::effects {

/// The device, renderer and size for which costs were measured.
struct CalibrationSubject {
    base::FixedString<31> device;
    base::FixedString<127> renderer;
    std::uint32_t width_px = 0, height_px = 0;
};

struct Calibration {
    CalibrationSubject subject;
    base::FixedString<31> date;
    CostTable costs;
    QualityLevels quality;
};

/// Reads a calibration file; one that lacks a table, has costs below 0, or has levels that fault_of() refuses, is refused.
[[nodiscard]] base::Result<Calibration, base::Error> read_calibration(std::string_view text, std::string_view file_name);
/// The same; also refuses a file that was measured for another device, renderer or size than `display`.
[[nodiscard]] base::Result<Calibration, base::Error> read_calibration(std::string_view text, std::string_view file_name,
                                                                      const CalibrationSubject& display);

}  // namespace tedavis::effects
