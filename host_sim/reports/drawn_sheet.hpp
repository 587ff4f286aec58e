/// The pictures of one contact sheet with their records, from which the sheet's picture, page and JSON are made.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/measure/aspect_measures.hpp"
#include "host_sim/png_file.hpp"
#include "host_sim/reports/frame_record_json.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"

namespace tedavis::host_sim {

inline constexpr char kSheetPictureName[] = "sheet.png";
inline constexpr char kSheetPageName[] = "index.html";
inline constexpr char kSheetJsonName[] = "sheet.json";

struct DrawnSheet {
    struct Picture {
        std::string title, design;
        std::string caption;  ///< a sentence; empty: the label has the design's name alone
        std::string file;     ///< name in the sheet's folder
        FrameResult result;
        RgbaPicture pixels;
        std::vector<std::uint8_t> layers;  ///< layer of each pixel (replay/drawn_layers.hpp); empty where not requested
        std::optional<AspectMeasures> measures;
        std::optional<double> flight_s;  ///< of a picture of a flight: seconds since the begin of the flight
    };
    struct Group {
        std::string title;
        std::vector<Picture> pictures;
    };
    std::string name, title;
    std::string terrain;  ///< the raster or database that was shown
    std::string device;
    std::string gl;                    ///< GL and renderer that drew it
    std::optional<AircraftPose> pose;  ///< nothing: pictures of a flight
    std::uint32_t columns = 1;
    std::vector<Group> groups;
};

}  // namespace tedavis::host_sim
