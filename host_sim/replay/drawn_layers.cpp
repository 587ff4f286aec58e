#include "host_sim/replay/drawn_layers.hpp"

#include <algorithm>

#include "host_sim/layer_mask.hpp"
#include "host_sim/png_file.hpp"
#include "render_core/display/planner/picture_layer.hpp"

namespace tedavis::host_sim {

std::vector<std::uint8_t> drawn_layers(DisplaySession& session) {
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

display::ObstaclePlaces obstacles_of_frame(DisplaySession& session) {
    display::Display& display = session.display();
    return display.planner().obstacles_ahead(display.planned(), display.memory());
}

void write_drawn_layers(const std::string& picture, DisplaySession& session) {
    const std::vector<std::uint8_t> layers = drawn_layers(session);
    write_layer_mask(picture, {layers.data(), session.width(), session.height()});
}

}  // namespace tedavis::host_sim
