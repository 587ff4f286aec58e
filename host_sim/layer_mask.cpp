#include "host_sim/layer_mask.hpp"

#include <filesystem>

#include "host_sim/atomic_file.hpp"
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

}  // namespace tedavis::host_sim
