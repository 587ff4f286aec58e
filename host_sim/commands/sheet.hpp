/// `tedavis sheet NAME`: contact sheets with one labelled picture per technique, all of the same view.
#pragma once

#include <optional>
#include <string>

#include "host_sim/console.hpp"
#include "host_sim/options/picture_options.hpp"
#include "host_sim/reports/drawn_sheet.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"

namespace tedavis::host_sim {

struct SheetOptions {
    std::string sheet;   ///< shipped name of configs/sheets, or a path
    std::string output;  ///< folder
    /// Its design is replaced by that of each picture. If it names neither terrain nor scene, databases are first built from the
    /// sheet's raster and scene.
    PictureOptions picture;
    bool layers = false;               ///< writes a layer mask beside every picture
    std::optional<AircraftPose> pose;  ///< nothing: the sheet's
    std::optional<base::Time> time;    ///< nothing: the sheet's
};

/// Writes each picture, all of them as sheet.png and index.html, and sheet.json; nothing where one of them cannot be written.
void write_sheet(const DrawnSheet& sheet, const std::string& output);

/// Writes each picture, all of them as sheet.png and index.html, and sheet.json; nothing where one of them fails. Returns the
/// exit code, 2 also where a part of the terrain failed; throws UserError and Interrupted.
[[nodiscard]] int run_sheet(const SheetOptions& options, Console& console);

}  // namespace tedavis::host_sim
