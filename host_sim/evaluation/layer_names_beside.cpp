#include "host_sim/evaluation/layer_names_beside.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "host_sim/evaluation/flight_run.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/layer_mask.hpp"
#include "host_sim/reports/drawn_sheet.hpp"

namespace tedavis::host_sim {

std::vector<std::string> layer_names_beside(const std::string& picture) {
    if (!std::filesystem::exists(layer_mask_path(picture))) return {};
    const std::filesystem::path file(picture);
    for (const std::filesystem::path& path :
         {std::filesystem::path(file).replace_extension(".json"), file.parent_path() / kSheetJsonName}) {
        if (!std::filesystem::is_regular_file(path)) continue;
        const auto record = nlohmann::ordered_json::parse(read_file(path.string()), nullptr, false);
        if (record.is_object()) return layer_names(record);
    }
    return {};
}

}  // namespace tedavis::host_sim
