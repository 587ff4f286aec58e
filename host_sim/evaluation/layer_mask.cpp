#include "host_sim/evaluation/layer_mask.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "host_sim/atomic_file.hpp"
#include "host_sim/evaluation/flight_run.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/reports/drawn_sheet.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

std::string layer_mask_path(const std::string& picture) {
    return std::filesystem::path(picture).replace_extension(".layers.png").string();
}

void write_layer_mask(const std::string& picture, const GreyView& layers) {
    write_file_atomically(layer_mask_path(picture), encode_grey_png(layers));
}

bool is_layer_mask(const std::string& file) {
    const std::filesystem::path path(file);
    return path.extension() == ".png" && path.stem().extension() == ".layers";
}

std::optional<LayerMask> read_layer_mask(const std::string& picture, const std::vector<std::string>& names, std::uint32_t width,
                                         std::uint32_t height) {
    const std::string path = layer_mask_path(picture);
    if (names.empty() || !std::filesystem::exists(path)) return std::nullopt;
    const RgbaPicture image = read_png(path);
    if (image.width != width || image.height != height)
        throw UserError(path + ": " + std::to_string(image.width) + "x" + std::to_string(image.height) +
                        " pixels where its picture has " + std::to_string(width) + "x" + std::to_string(height) +
                        "; write both again");
    LayerMask mask{width, height, {}, names};
    mask.layers.reserve(std::size_t{width} * height);
    for (std::size_t at = 0; at < image.pixels.size(); at += 4) mask.layers.push_back(image.pixels[at]);
    return mask;
}

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
