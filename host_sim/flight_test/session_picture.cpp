#include "host_sim/flight_test/session_picture.hpp"

#include "host_sim/replay/drawn_layers.hpp"
#include "render_core/display/planner/picture_layer.hpp"

namespace tedavis::host_sim {

void SessionPicture::begin_frame() {
    is_drawn_ = false;
    pixels_.reset();
    layers_.reset();
    frame_.reset();
}

void SessionPicture::draw() {
    if (is_drawn_) return;
    session_.draw();
    is_drawn_ = true;
}

FrameResult SessionPicture::result() {
    draw();
    FrameResult drawn;
    drawn.record = session_.display().record();
    return drawn;
}

const RgbaPicture& SessionPicture::pixels() {
    draw();
    if (!pixels_) pixels_ = upright(session_.pixels());
    return *pixels_;
}

const LayerMask& SessionPicture::layers() {
    draw();
    if (layers_) return *layers_;
    layers_.emplace();
    layers_->width = session_.width();
    layers_->height = session_.height();
    layers_->layers = drawn_layers(session_);
    layers_->names.assign(display::kPictureLayerNames.begin(), display::kPictureLayerNames.end());
    return *layers_;
}

const FlightFrame& SessionPicture::frame() {
    if (frame_) return *frame_;
    FrameResult drawn = result();
    drawn.has_layers = true;
    drawn.obstacles = obstacles_of_frame(session_);
    // Contracts read what a run wrote: so there is one reader for both.
    frame_ = flight_frame_of(nlohmann::ordered_json::parse(frame_record_json(drawn, drawn.record.time)));
    return *frame_;
}

}  // namespace tedavis::host_sim
