#include "host_sim/evaluation/layer_mask.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "host_sim/evaluation/flight_run.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/png_file.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

std::string layer_mask_path(const std::string& picture) {
    return std::filesystem::path(picture).replace_extension(".layers.png").string();
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
    const std::string path = std::filesystem::path(picture).replace_extension(".json").string();
    if (!std::filesystem::is_regular_file(path) || !std::filesystem::exists(layer_mask_path(picture))) return {};
    const auto record = nlohmann::ordered_json::parse(read_file(path), nullptr, false);
    return record.is_object() ? layer_names(record) : std::vector<std::string>();
}

}  // namespace tedavis::host_sim
