#include "host_sim/commands/sheet_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

#include "host_sim/input_file.hpp"
#include "host_sim/replay/load_design.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/config_reader.hpp"
#include "render_core/base/utc_time.hpp"
#include "render_core/scene/focus_region.hpp"

namespace tedavis::host_sim {
namespace {

using base::ConfigSection;

constexpr std::size_t kMaxGroups = 16, kMaxPictures = 64, kMaxViews = 64;
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

SheetPlan::Picture read_picture(ConfigSection& section) {
    SheetPlan::Picture picture;
    picture.title = read_title(section);
    picture.design = std::string(section.text("design"));
    picture.view = std::string(section.text("view", ""));
    ConfigSection weights = section.section("weights");
    for (std::size_t n = 0; n < weights.key_count(); ++n)
        picture.weights[std::string(weights.key_at(n))] = weights.number(weights.key_at(n), 0, 1);
    std::array<std::string_view, scene::kMaxFoci> foci;
    const std::size_t count = section.texts("foci", foci);
    picture.foci.assign(foci.begin(), foci.begin() + static_cast<std::ptrdiff_t>(std::min(count, foci.size())));
    picture.file = std::string(section.text("name", std::filesystem::path(picture.design).stem().string()));
    return picture;
}

SheetPlan::Picture with_detail(SheetPlan::Picture picture, double detail, std::string_view words) {
    picture.title += words;
    picture.detail = detail;
    picture.file += "_" + std::to_string(std::lround(100 * detail));
    return picture;
}

/// Pictures of a group; the names of their files are unique in the sheet.
class GroupReader {
public:
    explicit GroupReader(double little_detail) : little_detail_(little_detail) {}

    SheetPlan::Group read(ConfigSection section) {
        SheetPlan::Group group;
        group.title = read_title(section);
        const std::size_t count = section.table_count("picture");
        if (count == 0 || count > kMaxPictures)
            section.fault("picture", "1 to 64 tables [[group.picture]] are needed; add one for each picture");
        for (std::size_t i = 0; i < count && i < kMaxPictures; ++i) add_pictures(section.table_at("picture", i), group);
        return group;
    }

private:
    /// One, or a pair of which the second has all detail.
    void add_pictures(ConfigSection section, SheetPlan::Group& group) {
        const SheetPlan::Picture picture = read_picture(section);
        const double little = section.number("little_detail", 0, 0.99, little_detail_);
        if (little <= 0) return add(picture, section, group);
        add(with_detail(picture, little, ", little detail"), section, group);
        add(with_detail(picture, 1, ", all detail"), section, group);
    }
    void add(SheetPlan::Picture picture, ConfigSection& section, SheetPlan::Group& group) {
        picture.file += ".png";
        if (!files_.insert(picture.file).second || picture.file == "sheet.png")
            section.fault("design", "gives a picture '" + picture.file + "', whose name is taken; give it another 'name'");
        group.pictures.push_back(std::move(picture));
    }

    double little_detail_;
    std::set<std::string> files_;
};

FlownHistory read_history(ConfigSection section) {
    FlownHistory flown;
    flown.seconds = section.number("seconds", kHistoryStep_s, 600);
    flown.speed_mps = section.number("speed_mps", 1, 300);
    flown.turn_deg_per_s = section.number("turn_deg_per_s", -6, 6, 0);
    flown.climb_mps = section.number("climb_mps", -50, 50, 0);
    flown.wind_mps = section.number("wind_mps", 0, 100);
    flown.wind_from_deg = section.number("wind_from_deg", 0, 360);
    flown.temperature_c = section.number("temperature_c", -90, 60);
    flown.accuracy_m = section.number("accuracy_m", 0, 100'000);
    flown.accuracy_before_m = section.number("accuracy_before_m", 0, 100'000, flown.accuracy_m);
    return flown;
}

void read_views(ConfigSection root, SheetPlan& plan) {
    const std::size_t count = root.table_count("view");
    if (count > kMaxViews) root.fault("view", "no more than 64 tables [[view]] are read");
    for (std::size_t i = 0; i < count && i < kMaxViews; ++i) {
        ConfigSection section = root.table_at("view", i);
        const std::string name(section.text("name"));
        AircraftPose pose = read_pose(section);
        if (section.has("time")) pose.time = read_time(section);
        if (section.has("flown")) pose.flown = read_history(section.section("flown"));
        if (name.empty() || !plan.views.emplace(name, pose).second)
            section.fault("name", "must be there, and of this view alone");
    }
}

void read_groups(ConfigSection root, const std::string& file_name, SheetPlan& plan) {
    const std::string other(root.text("groups_of", ""));
    if (!other.empty())
        plan.groups_of = stated_config(other, "sheets", file_name);
    else
        plan.columns = static_cast<std::uint32_t>(root.integer("columns", 1, 12));
    const std::string designs(root.text("designs", ""));
    if (!designs.empty()) plan.designs = path_from(file_name, designs);
    const std::size_t groups = root.table_count("group");
    if ((groups == 0 && other.empty()) || groups > kMaxGroups)
        root.fault("group", "1 to 16 tables [[group]] are needed, or 'groups_of'; add either");
    GroupReader reader(root.number("little_detail", 0, 0.99, 0));
    for (std::size_t i = 0; i < groups && i < kMaxGroups; ++i) plan.groups.push_back(reader.read(root.table_at("group", i)));
}

/// What the ground shows and what stands over it.
void read_sources(ConfigSection root, const std::string& file_name, SheetPlan& plan) {
    const std::string terrain(root.text("terrain"));
    plan.terrain =
        terrain.find('/') == std::string::npos ? shipped_root() + "/configs/data/" + terrain : path_from(file_name, terrain);
    const std::string scene(root.text("scene", "")), scenario(root.text("scenario", ""));
    if (!scene.empty()) plan.scene = stated_config(scene, "scenes", file_name);
    if (!scenario.empty()) plan.scenario = stated_config(scenario, "scenarios", file_name);
    if (!scene.empty() && !scenario.empty()) root.fault("scenario", "and 'scene' both say what is shown; keep one");
}

void require_views(const SheetPlan& plan, const std::string& file_name) {
    for (const SheetPlan::Group& group : plan.groups) {
        for (const SheetPlan::Picture& picture : group.pictures) {
            if (picture.view.empty() || plan.views.count(picture.view) != 0) continue;
            throw UserError(file_name + ": picture '" + picture.title + "' asks for the view '" + picture.view +
                            "', which is not there; add a table [[view]] of this name");
        }
    }
}

/// Of what two sheets name.
void require_own_names(const SheetPlan& plan, const std::string& file_name) {
    std::set<std::string> files;
    for (const SheetPlan::Group& group : plan.groups)
        for (const SheetPlan::Picture& picture : group.pictures)
            if (!files.insert(picture.file).second)
                throw UserError(file_name + ": picture '" + picture.title + "' would be the second '" + picture.file +
                                "', which is in " + plan.groups_of + " too; give it another 'name'");
}

void take_groups(SheetPlan& plan, const std::string& path) {
    const SheetPlan other = parse_sheet_plan(read_file(plan.groups_of), plan.groups_of);
    if (!other.groups_of.empty())
        throw UserError(path + ": 'groups_of' names " + plan.groups_of +
                        ", which has no groups of its own; name the sheet that has");
    plan.columns = other.columns;
    plan.groups.insert(plan.groups.begin(), other.groups.begin(), other.groups.end());
    require_views(plan, path);
    require_own_names(plan, path);
}

/// What sizes and ranges of values show well depends on the data.
void take_designs(SheetPlan& plan, const std::string& file_name) {
    if (plan.designs.empty()) return;
    namespace fs = std::filesystem;
    std::set<std::string> in_folder;
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(plan.designs, error))
        if (entry.path().extension() == ".toml") in_folder.insert(entry.path().lexically_normal().string());
    if (in_folder.empty())
        throw UserError(file_name + ": 'designs' names " + plan.designs + ", where no design is; name a folder of them");
    std::set<std::string> unused = in_folder;
    for (SheetPlan::Group& group : plan.groups)
        for (SheetPlan::Picture& picture : group.pictures) {
            const std::string own = (fs::path(plan.designs) / (picture.design + ".toml")).lexically_normal().string();
            unused.erase(own);
            if (in_folder.count(own) != 0) picture.design = own;
        }
    if (!unused.empty())
        throw UserError(*unused.begin() + ": no picture of " + file_name + " names this design; call it as one of them does");
}

}  // namespace

SheetPlan parse_sheet_plan(std::string_view text, const std::string& file_name) {
    base::ConfigReader reader(text, file_name);
    ConfigSection root = reader.root();
    SheetPlan plan;
    plan.title = read_title(root);
    read_sources(root, file_name, plan);
    if (root.has("time")) plan.time = read_time(root);
    plan.generated_image = root.boolean("generated_image", false);
    plan.size.width = static_cast<std::uint32_t>(root.integer("width_px", 64, 4096));
    plan.size.height = static_cast<std::uint32_t>(root.integer("height_px", 48, 4096));
    plan.symbology = root.boolean("symbology", false);
    plan.measures_aspects = root.boolean("measures_aspects", false);
    plan.pose = read_pose(root.section("pose"));
    read_views(root, plan);
    read_groups(root, file_name, plan);
    if (!reader.finish()) throw UserError(std::string(reader.error().message.view()));
    if (plan.groups_of.empty()) require_views(plan, file_name);
    return plan;
}

SheetPlan read_sheet_plan(const std::string& path) {
    SheetPlan plan = parse_sheet_plan(read_file(path), path);
    if (!plan.groups_of.empty()) take_groups(plan, path);
    take_designs(plan, path);
    return plan;
}

const AircraftPose& SheetPlan::pose_of(const Picture& picture) const {
    return picture.view.empty() ? pose : views.at(picture.view);
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
            options.weights = picture.weights;
            options.foci = picture.foci;
            try {
                (void)load_design(options);
            } catch (const UserError& error) {
                throw UserError(file_name + ": picture '" + picture.title + "': " + error.what());
            }
        }
    }
}

}  // namespace tedavis::host_sim
