/// A knob that draws poses of a flight: a sample is a pose, and its work one further frame there.
#pragma once

#include <utility>

#include "host_sim/accuracy/knobs/flown_pictures.hpp"
#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_flight.hpp"
#include "host_sim/accuracy/knobs/seen_ground.hpp"

namespace tedavis::host_sim {

/// How many poses a knob is measured at.
[[nodiscard]] inline std::size_t flown_poses(bool is_quick) { return is_quick ? 4 : 24; }

/// The pixel of a picture in which a place of the grid is.
[[nodiscard]] inline KnobPixel seen_pixel(const SeenPlace& place, const SeenGrid& grid, const PictureSize& size) {
    return {(2 * place.x + 1) * size.width / (2 * grid.across), (2 * place.y + 1) * size.height / (2 * grid.down)};
}

class FlownKnob : public Knob {
public:
    [[nodiscard]] std::size_t samples() const override { return pictures_.poses().size(); }
    void prepare(std::size_t level, std::size_t sample) override { pictures_.show(level, sample); }
    void run(std::size_t level, std::size_t sample) override { pictures_.draw(level, sample); }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        const std::optional<KnobPixel> pixel = pixel_of(sample, error);
        return "pixel " + std::to_string(pixel->x) + ", " + std::to_string(pixel->y) + " from --pose " +
               pose_text(pictures_.poses()[sample]);
    }
    [[nodiscard]] std::optional<RgbaPicture> picture(std::size_t level, std::size_t sample) override {
        return upright(pictures_.picture(shown_level(level), sample));
    }
    /// Every such knob draws pictures, so it has a pixel for each error.
    [[nodiscard]] std::optional<KnobPixel> pixel_of(std::size_t sample, std::size_t error) const override = 0;
    [[nodiscard]] std::string command(std::size_t level, std::size_t sample) const override {
        const std::optional<std::string> shot = pictures_.shot_command(shown_level(level), sample);
        return shot ? *shot : Knob::command(level, sample);
    }
    [[nodiscard]] std::optional<std::uint64_t> uploaded_bytes(std::size_t level) const override {
        return pictures_.uploaded_bytes(shown_level(level));
    }
    [[nodiscard]] double build_ms(std::size_t level) const override { return pictures_.build_ms(shown_level(level)); }

protected:
    FlownKnob(KnobFacts facts, const std::vector<FlownLevel>& levels, std::vector<AircraftPose> poses)
        : Knob(std::move(facts)), pictures_(levels, std::move(poses)) {}

    /// The index in `pictures()` of the level that draws a level of the knob.
    [[nodiscard]] virtual std::size_t shown_level(std::size_t level) const { return level; }
    [[nodiscard]] FlownPictures& pictures() { return pictures_; }

private:
    FlownPictures pictures_;
};

}  // namespace tedavis::host_sim
