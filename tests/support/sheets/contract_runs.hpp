/// A run as `replay --layers` leaves it, painted: ground, a bright area of data, a label, and an obstacle.
#pragma once

#include <functional>
#include <string>

#include "host_sim/layer_mask.hpp"
#include "render_core/display/planner/picture_layer.hpp"
#include "tests/support/files/run_folders.hpp"

namespace tedavis::test_support {

/// What is painted of a frame; each may be made worse by a test.
struct PaintedFrame {
    std::uint8_t label = 255;    ///< grey of a label on ground of 120
    std::uint8_t data = 230;     ///< of the area of data
    std::uint8_t obstacle = 20;  ///< of the obstacle's sign
    int stripe_px = 0;           ///< of lines over the ground; 0: none
    bool has_layers = true;
    display::ObstacleState obstacle_state = display::ObstacleState::drawn;
    std::string design = "default";
    flight::FlightPhase phase{flight::Scenario::cruise, 0};
};

class FramePainter {
public:
    static constexpr std::uint32_t kWidth = 240, kHeight = 180;

    explicit FramePainter(const PaintedFrame& painted)
        : picture{kWidth, kHeight, std::vector<std::uint8_t>(std::size_t{kWidth} * kHeight * 4, 120)},
          layers(std::size_t{kWidth} * kHeight, 0) {
        for (std::size_t n = 3; n < picture.pixels.size(); n += 4) picture.pixels[n] = 255;
        for (int x = 0; x < static_cast<int>(kWidth) && painted.stripe_px > 0; ++x)
            if (x / painted.stripe_px % 2 == 1) box(x, 0, x + 1, static_cast<int>(kHeight), 200, display::PictureLayer::terrain);
        box(30, 110, 80, 150, painted.data, display::PictureLayer::data);
        box(180, 130, 200, 136, painted.label, display::PictureLayer::labels);
        box(140, 40, 150, 50, painted.obstacle, display::PictureLayer::labels);
    }
    void box(int left, int top, int right, int bottom, std::uint8_t level, display::PictureLayer layer) {
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                const std::size_t at = static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
                std::fill_n(&picture.pixels[4 * at], 3, level);
                layers[at] = static_cast<std::uint8_t>(layer);
            }
    }
    host_sim::RgbaPicture picture;
    std::vector<std::uint8_t> layers;
};

inline host_sim::FrameResult painted_result(const PaintedFrame& painted, host_sim::FrameResult result) {
    result.record.time = base::Time{} + base::Duration::from_seconds(static_cast<double>(result.record.frame));
    result.record.phase.phase = painted.phase;
    result.record.design = base::FixedString<47>(painted.design);
    result.record.data_aspect.weight = 1;
    result.record.terrain_aspect.weight = result.record.uncertainty_aspect.weight = 0.3;
    result.record.scene_revision = 1;
    result.has_layers = painted.has_layers;
    display::ObstaclePlace mast;
    mast.name = base::FixedString<31>("Mast");
    mast.state = painted.obstacle_state;
    mast.ahead_s = 20;
    mast.box = {140, 40, 10, 10};
    static_cast<void>(result.obstacles.try_push_back(mast));
    return result;
}

/// One frame a second, each as `paint(n)` says.
inline void write_painted_run(const TemporaryFolder& place, const std::string& name, std::uint64_t frames,
                              const std::function<PaintedFrame(std::uint64_t)>& paint) {
    write_run(
        place, name, [&](host_sim::FrameResult& result) { result = painted_result(paint(result.record.frame), result); }, frames);
    place.write(name + "/" + host_sim::kSummaryName, "{\"design\": \"default\"}");
    for (std::uint64_t n = 0; n < frames; ++n) {
        const PaintedFrame painted = paint(n);
        const FramePainter painter(painted);
        write_picture(place, name, n, painter.picture);
        if (painted.has_layers)
            host_sim::write_layer_mask(host_sim::frame_picture_path(place.file(name), n),
                                       {painter.layers.data(), FramePainter::kWidth, FramePainter::kHeight});
    }
}

}  // namespace tedavis::test_support
