#include "host_sim/commands/sheet_plan.hpp"

#include <cmath>
#include <filesystem>
#include <set>

#include "host_sim/replay/load_design.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/config_reader.hpp"
#include "render_core/base/utc_time.hpp"

namespace tedavis::host_sim {
namespace {

using base::ConfigSection;

constexpr std::size_t kMostGroups = 16, kMostPictures = 64;
constexpr std::size_t kLongestTitle = 60;

AircraftPose read_pose(ConfigSection section) {
    AircraftPose pose;
    pose.latitude_deg = section.number("latitude_deg", -90, 90);
    pose.longitude_deg = section.number("longitude_deg", -360, 360);
    pose.altitude_msl_m = section.number("altitude_msl_m", -1000, 100'000);
    pose.heading_deg = section.number("heading_deg", 0, 360);
    pose.pitch_deg = section.number("pitch_deg", -90, 90, 0);
    pose.roll_deg = section.number("roll_deg", -180, 180, 0);
    return pose;
}

base::Time read_time(ConfigSection& section) {
    base::Time time;
    if (!base::parse_utc(section.text("time"), time)) section.fault("time", "must be UTC such as 2026-06-01T14:00:00Z");
    return time;
}

std::string read_title(ConfigSection& section) {
    const std::string_view title = section.text("title");
    if (title.empty() || title.size() > kLongestTitle) section.fault("title", "must be 1 to 60 characters long");
    return std::string(title);
}

SheetPlan::Picture read_picture(ConfigSection section, std::set<std::string>& files) {
    SheetPlan::Picture picture;
    picture.title = read_title(section);
    picture.design = std::string(section.text("design"));
    picture.file = std::filesystem::path(picture.design).stem().string();
    if (section.has("detail")) {
        picture.detail = section.number("detail", 0, 1);
        picture.file += "_" + std::to_string(std::lround(100 * *picture.detail));
    }
    picture.file += ".png";
    if (ConfigSection pose = section.section("pose"); pose.present()) picture.pose = read_pose(pose);
    if (!files.insert(picture.file).second || picture.file == "sheet.png")
        section.fault("design",
                      "gives a picture '" + picture.file + "', whose name is taken; name the design's file differently");
    return picture;
}

SheetPlan::Group read_group(ConfigSection section, std::set<std::string>& files) {
    SheetPlan::Group group;
    group.title = read_title(section);
    const std::size_t count = section.table_count("picture");
    if (count == 0 || count > kMostPictures) section.fault("picture", "1 to 64 tables [[group.picture]] are needed");
    for (std::size_t i = 0; i < count && i < kMostPictures; ++i)
        group.pictures.push_back(read_picture(section.table_at("picture", i), files));
    return group;
}

}  // namespace

SheetPlan parse_sheet_plan(std::string_view text, const std::string& file_name) {
    base::ConfigReader reader(text, file_name);
    ConfigSection root = reader.root();
    SheetPlan plan;
    plan.title = read_title(root);
    plan.columns = static_cast<std::uint32_t>(root.integer("columns", 1, 12));
    plan.terrain = std::string(root.text("terrain"));
    plan.scene = std::string(root.text("scene", ""));
    plan.scenario = std::string(root.text("scenario", ""));
    if (!plan.scene.empty() && !plan.scenario.empty()) root.fault("scenario", "and 'scene' both say what is shown; keep one");
    if (root.has("time")) plan.time = read_time(root);
    plan.generated_image = root.boolean("generated_image", false);
    plan.size.width = static_cast<std::uint32_t>(root.integer("width_px", 64, 4096));
    plan.size.height = static_cast<std::uint32_t>(root.integer("height_px", 48, 4096));
    plan.symbology = root.boolean("symbology", false);
    plan.pose = read_pose(root.section("pose"));
    const std::size_t groups = root.table_count("group");
    if (groups == 0 || groups > kMostGroups) root.fault("group", "1 to 16 tables [[group]] are needed");
    std::set<std::string> files;
    for (std::size_t i = 0; i < groups && i < kMostGroups; ++i)
        plan.groups.push_back(read_group(root.table_at("group", i), files));
    if (!reader.finish()) throw UserError(std::string(reader.error().sentence.view()));
    return plan;
}

std::size_t SheetPlan::picture_count() const {
    std::size_t count = 0;
    for (const Group& group : groups) count += group.pictures.size();
    return count;
}

void require_designs(const SheetPlan& plan, const std::string& file_name) {
    PictureOptions options;
    for (const SheetPlan::Group& group : plan.groups) {
        for (const SheetPlan::Picture& picture : group.pictures) {
            options.design = picture.design;
            try {
                (void)load_design(options);
            } catch (const UserError& error) {
                throw UserError(file_name + ": picture '" + picture.title + "': " + error.what());
            }
        }
    }
}

}  // namespace tedavis::host_sim
