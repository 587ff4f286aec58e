/// The content of a contact sheet (`configs/sheets/*.toml`): one view, and its pictures in groups.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/options/picture_options.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"

namespace tedavis::host_sim {

struct SheetPlan {
    struct Picture {
        std::string title;
        std::string design;             ///< shipped name or path
        std::optional<double> detail;   ///< of all its data, instead of the design's
        AskedWeights weights;           ///< of aspects; override the design's
        std::vector<std::string> foci;  ///< PictureOptions::foci
        std::string view;               ///< name of one of `views`; empty: the sheet's pose
        /// Picture file, "lambert.png", from the stated name, else from the last part of the design's; with a detail
        /// "barbs_30.png".
        std::string file;
    };
    struct Group {
        std::string title;
        std::vector<Picture> pictures;
    };
    std::string title;
    std::uint32_t columns = 0;
    std::string terrain;             ///< path of the raster that the sheet shows unless a database is given
    std::string scene;               ///< path of the recipe that is shown over that terrain; empty: none
    std::string scenario;            ///< instead of a scene: path of the scenario that makes one
    std::optional<base::Time> time;  ///< time for the age of data; nothing: data are shown at their own time
    bool generated_image = false;    ///< a generated image is draped over that terrain
    PictureSize size;                ///< of each picture, unless --size states another
    bool symbology = false;          ///< PictureOptions::symbology
    bool measures_aspects = false;   ///< measures aspects, for which each picture is drawn three more times
    AircraftPose pose;
    std::map<std::string, AircraftPose> views;  ///< poses by name; with a time of their own, or kPosedTime: the sheet's
    std::string groups_of;  ///< path of the sheet whose groups are shown before own ones; empty: own ones alone
    std::string designs;    ///< path of the folder whose designs stand in for those of their names; empty: none
    std::vector<Group> groups;

    [[nodiscard]] std::size_t picture_count() const;
    /// Returns the pose of the picture's view, else that of the sheet.
    [[nodiscard]] const AircraftPose& pose_of(const Picture& picture) const;
};

/// Parses a sheet. `file_name` is the file's path, for messages and for the names in it with a slash or a dot, which are relative
/// to its folder. Throws UserError with the line.
[[nodiscard]] SheetPlan parse_sheet_plan(std::string_view text, const std::string& file_name);
/// Reads the file and the one that `groups_of` names. If the sheet has a folder of designs, designs of pictures that are in it
/// are replaced by their paths there. Throws UserError, also where no picture uses a design of the folder.
[[nodiscard]] SheetPlan read_sheet_plan(const std::string& path);
/// Reads every design of the plan. Throws UserError with the sheet's file, the picture and the error.
void require_designs(const SheetPlan& plan, const std::string& file_name);

}  // namespace tedavis::host_sim
