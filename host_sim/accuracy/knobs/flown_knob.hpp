/// A knob that draws poses of the default flight: a sample is a pose, and its work one further frame there.
#pragma once

#include <utility>

#include "host_sim/accuracy/knobs/flown_pictures.hpp"
#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_flight.hpp"

namespace tedavis::host_sim {

/// Small, so that a quick run has time for several poses.
inline constexpr PictureSize kFlownSize = {640, 360};

/// How many poses a knob is measured at.
[[nodiscard]] inline std::size_t flown_poses(bool is_quick) { return is_quick ? 4 : 24; }

class FlownKnob : public Knob {
public:
    [[nodiscard]] std::size_t samples() const override { return pictures_.poses().size(); }
    void prepare(std::size_t level, std::size_t sample) override { pictures_.show(level, sample); }
    void run(std::size_t level, std::size_t sample) override { pictures_.draw(level, sample); }
    [[nodiscard]] double build_ms(std::size_t level) const override { return pictures_.build_ms(level); }

protected:
    FlownKnob(KnobFacts facts, const std::vector<FlownLevel>& levels, std::vector<AircraftPose> poses)
        : Knob(std::move(facts)), pictures_(levels, std::move(poses)) {}

    [[nodiscard]] FlownPictures& pictures() { return pictures_; }
    /// A pixel of the picture from a pose.
    [[nodiscard]] std::string pixel_text(std::size_t sample, std::uint32_t x, std::uint32_t y) const {
        return "pixel " + std::to_string(x) + ", " + std::to_string(y) + " from --pose " + pose_text(pictures_.poses()[sample]);
    }

private:
    FlownPictures pictures_;
};

}  // namespace tedavis::host_sim
