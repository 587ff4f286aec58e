#include "host_sim/replay/resolved_design.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "host_sim/input_file.hpp"
#include "host_sim/replay/design_files.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/design/design_settings.hpp"

namespace tedavis::host_sim {
namespace {

namespace fs = std::filesystem;

/// A path that a base in another folder states, from the folder of the design.
base::FixedString<1023> path_from_design(const base::StatedFile& stated, std::string_view design) {
    const std::string name(stated.name);
    if (design::is_short_name(name) || fs::path(name).is_absolute()) return base::FixedString<1023>(name);
    const fs::path folder = fs::absolute(design).lexically_normal().parent_path();
    const fs::path path = fs::absolute(path_from(std::string(stated.stated_in), name)).lexically_normal();
    return base::FixedString<1023>(path.lexically_relative(folder).string());
}

}  // namespace

nlohmann::ordered_json resolved_design(const std::string& path) {
    const std::string text = read_file(path);
    base::ConfigReader reader(text, path);
    DesignFiles files;
    const auto design = design::read_design_settings(reader, files);
    if (!design.ok()) throw UserError(std::string(design.error().message.view()));
    return nlohmann::ordered_json::parse(reader.json(&path_from_design));
}

}  // namespace tedavis::host_sim
