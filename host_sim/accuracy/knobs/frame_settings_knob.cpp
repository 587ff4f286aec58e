#include "host_sim/accuracy/knobs/frame_settings_knob.hpp"

#include <algorithm>
#include <memory>

#include "host_sim/accuracy/knobs/flown_knob.hpp"
#include "host_sim/accuracy/knobs/scaled_picture.hpp"
#include "host_sim/accuracy/knobs/terrain_tau_knob.hpp"
#include "host_sim/printed_text.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kFrameTaus_px[] = {8, 4, 2, 1, 0.5};
/// Parts of the window's width and height.
struct DrawnShare {
    double share;
    const char* name;
};
constexpr DrawnShare kDrawnShares[] = {{0.5, "half size"}, {0.75, "three quarters"}, {1, "full size"}};
constexpr double kBetweenFrames_s = 1.0 / 30;
constexpr std::size_t kFramePoses = 16, kQuickFramePoses = 5;
constexpr std::size_t kFrameMoments = 48, kQuickFrameMoments = 20;

struct FrameSetting {
    double tau_px;
    DrawnShare drawn;
};

std::vector<FrameSetting> frame_settings() {
    std::vector<FrameSetting> settings;
    for (const DrawnShare& drawn : kDrawnShares)
        for (const double tau_px : kFrameTaus_px) settings.push_back({tau_px, drawn});
    return settings;
}

KnobFacts frame_settings_facts(const FlownDisplay& display) {
    std::vector<KnobLevel> levels;
    for (const FrameSetting& setting : frame_settings()) {
        levels.push_back({printed("tau %g px, %s", setting.tau_px, setting.drawn.name), 0});
    }
    return {kFrameSettings,
            "Settings of a frame: the terrain's error and the share of the window that is drawn",
            "--tau and --size of replay, or tau_px of a design and the size of a device",
            "distance on the window between the drawn and the true place of ground, and half of what a drawn pixel is wider than "
            "one of the window of " +
                size_text(display.size) + " pixels",
            "px",
            {"the database's own heights, two triangles a cell, projected in doubles", 4e-3 * pixel_scale(display),
             "twice that of terrain_tau, since a pixel of half the size is two of the window"},
            "the bound that the display states for each frame, times the window's pixels in a drawn pixel",
            "Warnings and symbology are drawn with every setting. What a smaller picture does to colours, picture_size states.",
            "no scale: combinations of two settings",
            std::nullopt,
            std::move(levels)};
}

std::vector<AircraftPose> joined(std::vector<AircraftPose> poses, const std::vector<AircraftPose>& further) {
    poses.insert(poses.end(), further.begin(), further.end());
    return poses;
}

/// In the middle of equal parts of the flight, with its phases.
std::vector<AircraftPose> phased_poses(const KnobFlight& flight, std::size_t count) {
    std::vector<AircraftPose> poses = flight.poses(count);
    for (AircraftPose& pose : poses) pose.phase = flight.phase_at(pose);
    return poses;
}

std::vector<FlownLevel> flown_settings(const KnobGround& ground, const std::shared_ptr<const KnobFlight>& flight) {
    std::vector<FlownLevel> levels;
    for (const FrameSetting& setting : frame_settings()) {
        levels.push_back(terrain_level(ground.ground.path(), setting.tau_px, ground.display));
        levels.back().picture.size = ground.display.share(setting.drawn.share);
        levels.back().complete = [flight](const AircraftPose& pose, flight::AircraftState& state) {
            flight->add_signals(pose, state);
        };
    }
    return levels;
}

class FrameSettingsKnob final : public FlownKnob {
public:
    /// `moments`: poses that are only timed.
    FrameSettingsKnob(const KnobGround& ground, const std::shared_ptr<const KnobFlight>& flight, std::vector<SeenPose> seen,
                      const std::vector<AircraftPose>& moments)
        : FlownKnob(frame_settings_facts(ground.display), flown_settings(ground, flight), joined(poses_of(seen), moments)),
          display_(ground.display),
          grid_(seen_grid(ground.display)),
          settings_(frame_settings()),
          seen_(std::move(seen)),
          measured_(seen_.size()),
          proven_(settings_.size()) {
        for (const AircraftPose& pose : pictures().poses()) {
            before_.push_back(flight->pose_at((pose.time - flight->begin()).to_seconds() - kBetweenFrames_s));
            before_.back().phase = pose.phase;
        }
    }

    [[nodiscard]] std::size_t samples() const override { return seen_.size(); }
    [[nodiscard]] std::size_t moments() const override { return before_.size() - seen_.size(); }

    /// The frame before, so that the one that is timed moves as in flight: its terrain changes and its buffers are sent.
    void prepare(std::size_t level, std::size_t sample) override {
        FlownKnob::prepare(level, sample);
        pictures().fly_to(level, before_[sample]);
    }
    void run(std::size_t level, std::size_t sample) override { pictures().fly_to(level, pictures().poses()[sample]); }

    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        display::Display& display = pictures().display(level, sample);
        measured_[sample].clear();
        proven_[level] = std::max(proven_[level], on_window(level, display.record().terrain.worst_error_px));
        for (const SeenPlace& place : seen_[sample].places)
            if (const auto error = terrain_error_px(display, place)) {
                errors.push_back(on_window(level, *error));
                measured_[sample].push_back(place);
            }
    }
    [[nodiscard]] std::optional<double> proven(std::size_t level) const override { return proven_[level]; }
    [[nodiscard]] std::optional<KnobPixel> pixel_of(std::size_t sample, std::size_t error) const override {
        return seen_pixel(measured_[sample][error], grid_, display_.size);
    }
    [[nodiscard]] std::optional<RgbaPicture> picture(std::size_t level, std::size_t sample) override {
        return scaled_picture(pictures().picture(level, sample), display_.size);
    }
    [[nodiscard]] std::string options(std::size_t level) const override {
        const FrameSetting& setting = settings_[level];
        return printed("--tau %g --size ", setting.tau_px) + size_word(display_.share(setting.drawn.share));
    }

private:
    /// An error in drawn pixels, in pixels of the window, and half of what a drawn pixel is wider.
    [[nodiscard]] double on_window(std::size_t level, double drawn_px) const {
        const double wide = display_.share(settings_[level].drawn.share).width, scale = display_.size.width / wide;
        return drawn_px * scale + 0.5 * (scale - 1);
    }

    FlownDisplay display_;
    SeenGrid grid_;
    std::vector<FrameSetting> settings_;
    std::vector<SeenPose> seen_;
    std::vector<AircraftPose> before_;              ///< a frame earlier
    std::vector<std::vector<SeenPlace>> measured_;  ///< by pose, of the level that was measured last
    std::vector<double> proven_;                    ///< by level, over the poses whose errors were found
};

}  // namespace

std::unique_ptr<Knob> make_frame_settings_knob(const KnobGround& ground) {
    const auto flight = std::make_shared<const KnobFlight>(ground);
    const std::vector<AircraftPose> poses = phased_poses(*flight, ground.is_quick ? kQuickFramePoses : kFramePoses);
    return std::make_unique<FrameSettingsKnob>(ground, flight, seen_poses(ground.ground, poses, seen_grid(ground.display)),
                                               phased_poses(*flight, ground.is_quick ? kQuickFrameMoments : kFrameMoments));
}

}  // namespace tedavis::host_sim
