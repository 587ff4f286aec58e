#include "host_sim/replay/layer_mask.hpp"

#include <algorithm>
#include <filesystem>

#include "host_sim/atomic_file.hpp"
#include "host_sim/png_file.hpp"
#include "render_core/display/picture_layer.hpp"

namespace tedavis::host_sim {

std::vector<std::uint8_t> layer_mask(DisplaySession& session) {
    std::vector<std::uint8_t> mask(std::size_t{session.width()} * session.height(), 0);
    session.draw_up_to(display::PictureLayer::terrain);
    RgbaPicture behind = upright(session.pixels());
    for (std::size_t layer = 1; layer < display::kPictureLayers; ++layer) {
        session.draw_up_to(static_cast<display::PictureLayer>(layer));
        RgbaPicture picture = upright(session.pixels());
        for (std::size_t n = 0; n < mask.size(); ++n)
            if (!std::equal(&picture.pixels[4 * n], &picture.pixels[4 * n] + 3, &behind.pixels[4 * n]))
                mask[n] = static_cast<std::uint8_t>(layer);
        behind = std::move(picture);
    }
    return mask;
}

std::string layer_mask_path(const std::string& picture) {
    return std::filesystem::path(picture).replace_extension(".layers.png").string();
}

void write_layer_mask(const std::string& picture, DisplaySession& session) {
    const std::vector<std::uint8_t> mask = layer_mask(session);
    write_file_atomically(layer_mask_path(picture), encode_grey_png({mask.data(), session.width(), session.height()}));
}

}  // namespace tedavis::host_sim
