/// The picture of the frame that a display session planned last.
#pragma once

#include <optional>

#include "host_sim/flight_test/shown_picture.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/reports/frame_record_json.hpp"

namespace tedavis::host_sim {

class SessionPicture final : public ShownPicture {
public:
    /// Draws nothing. The session must outlive this object.
    explicit SessionPicture(DisplaySession& session) : session_(session) {}

    /// To be called after a frame was planned; discards the picture of the frame before.
    void begin_frame();
    /// Draws the frame, unless it was drawn already. Throws UserError where the picture cannot be read back.
    void draw();
    [[nodiscard]] bool is_drawn() const { return is_drawn_; }
    /// The result of the drawn frame for frame_record_json(), without hash and times.
    [[nodiscard]] FrameResult result();

    const RgbaPicture& pixels() override;
    /// Draws the frame once more for each layer.
    const LayerMask& layers() override;
    const FlightFrame& frame() override;

private:
    DisplaySession& session_;
    bool is_drawn_ = false;
    std::optional<RgbaPicture> pixels_;
    std::optional<LayerMask> layers_;
    std::optional<FlightFrame> frame_;
};

}  // namespace tedavis::host_sim
