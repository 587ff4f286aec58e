#include "host_sim/accuracy/knobs/output_knobs.hpp"

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "host_sim/accuracy/knobs/color_knob.hpp"
#include "host_sim/accuracy/knobs/seen_ground.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kSizeShares[] = {0.25, 0.375, 0.5, 0.75, 1};
constexpr double kRates_hz[] = {5, 10, 15, 30, 60};
constexpr double kFlownPart_s = 0.2;
constexpr int kMoments = 4;  // of the time that a picture stands

KnobFacts picture_size_facts(const FlownDisplay& display) {
    std::vector<KnobLevel> levels;
    for (const double share : kSizeShares) levels.push_back({size_text(display.share(share)), share});
    return {"picture_size",
            "Size of the picture that the display hardware scales to " + size_text(display.size),
            "width_px and height_px of a device, and --size",
            pixel_metric(display.size),
            kColorUnit,
            {"the picture of the full size", 0, "it is what the levels are scaled to"},
            "none: a smaller picture is compared with what it stands for",
            "Terrain alone is measured; text is never smaller than the design's dpi allows, so a small picture holds less of it.",
            "share of the width",
            std::nullopt,
            std::move(levels)};
}

ColorPlan picture_size_plan(const KnobGround& ground) {
    ColorPlan plan;
    plan.size = ground.display.size;
    plan.reference = std::size(kSizeShares) - 1;
    for (const double share : kSizeShares) {
        FlownLevel level = flown_level(ground.ground.path(), ground.display);
        level.picture.shown = ShownAspects::terrain;
        level.picture.symbology = false;
        level.picture.size = ground.display.share(share);
        plan.drawn.push_back(level);
    }
    return plan;
}

class PictureSizeKnob final : public ColorKnob {
public:
    PictureSizeKnob(const KnobGround& ground, std::vector<AircraftPose> poses)
        : ColorKnob(picture_size_facts(ground.display), picture_size_plan(ground), std::move(poses)), display_(ground.display) {}

    [[nodiscard]] std::uint64_t bytes(std::size_t level) const override {
        const PictureSize size = display_.share(kSizeShares[level]);
        return std::uint64_t{4} * size.width * size.height;
    }

private:
    FlownDisplay display_;
};

/// A recorded flight is by definition the one that goes straight from pose to pose.
KnobReference flight_reference(const KnobGround& ground) {
    if (ground.recorded != nullptr)
        return {"the poses of the recorded flight, and between them linearly", 0, "this is the flight that is drawn"};
    return {"the flight as it is generated, every 10 ms, and between linearly", 0.01 * pixel_scale(ground.display),
            "a turn of 1 rad/s2 is off by 0.0125 mrad between two states, which is 0.007 px of 640 over 60 degrees"};
}

KnobFacts output_rate_facts(const KnobGround& ground) {
    std::vector<KnobLevel> levels;
    for (const double rate_hz : kRates_hz) {
        char name[24];
        std::snprintf(name, sizeof name, "%g pictures/s", rate_hz);
        levels.push_back({name, rate_hz});
    }
    return {
        "output_rate",
        "Pictures a second; times are those of 0.2 s of flight",
        "frame_rate_hz of a device, and --step",
        "distance on the screen between the place of visible ground in the picture and where it is while the picture stands, " +
            size_text(ground.display.size) + " pixels",
        "px",
        flight_reference(ground),
        "none: the poses of the flight are given, so its places are known",
        "What a picture shows is the same at every rate.",
        "pictures a second",
        ExpectedLaw{-1, 0.1, "a place moves evenly while a picture stands"},
        std::move(levels)};
}

std::vector<FlownLevel> output_rate_level(const KnobGround& ground) {
    return {flown_level(ground.ground.path(), ground.display)};
}

/// One display draws all levels.
class OutputRateKnob final : public FlownKnob {
public:
    OutputRateKnob(const KnobGround& ground, std::unique_ptr<KnobFlight> flight, std::vector<SeenPose> seen)
        : FlownKnob(output_rate_facts(ground), output_rate_level(ground), poses_of(seen)),
          ground_(ground.ground),
          grid_(seen_grid(ground.display)),
          size_(ground.display.size),
          flight_(std::move(flight)),
          seen_(std::move(seen)) {}

    void prepare(std::size_t, std::size_t sample) override { pictures().show(0, sample); }
    void run(std::size_t level, std::size_t sample) override {
        const double rate_hz = kRates_hz[level];
        const auto frames = static_cast<int>(std::lround(kFlownPart_s * rate_hz));
        for (int n = 1; n <= frames; ++n) pictures().fly_to(0, pose_after(sample, n / rate_hz));
    }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        const terrain::View drawn = view_after(sample, 0);
        std::vector<terrain::View> later;
        for (int n = 0; n < kMoments; ++n) later.push_back(view_after(sample, (n + 0.5) / kMoments / kRates_hz[level]));
        for (const SeenPlace& place : seen_[sample].places)
            for (const terrain::View& view : later) {
                const auto here = pixel_at(drawn, place.position), there = pixel_at(view, place.position);
                errors.push_back(here && there ? glm::distance(*here, *there) : 0);
            }
    }
    [[nodiscard]] std::optional<KnobPixel> pixel_of(std::size_t sample, std::size_t error) const override {
        return seen_pixel(seen_[sample].places[error / kMoments], grid_, size_);
    }

private:
    [[nodiscard]] std::size_t shown_level(std::size_t /*level*/) const override { return 0; }
    [[nodiscard]] AircraftPose pose_after(std::size_t sample, double seconds) {
        const double at_s = (pictures().poses()[sample].time - flight_->begin()).to_seconds();
        return flight_->pose_at(at_s + seconds);
    }
    [[nodiscard]] terrain::View view_after(std::size_t sample, double seconds) {
        TracedShotPlan plan;
        plan.pose = pose_after(sample, seconds);
        plan.width = size_.width;
        plan.height = size_.height;
        plan.field_of_view_deg = grid_.field_of_view_deg;
        return view_of(ground_, plan);
    }

    const TracedGround& ground_;
    SeenGrid grid_;
    PictureSize size_;
    std::unique_ptr<KnobFlight> flight_;
    std::vector<SeenPose> seen_;
};

}  // namespace

std::unique_ptr<Knob> make_picture_size_knob(const KnobGround& ground) {
    return std::make_unique<PictureSizeKnob>(ground, KnobFlight(ground).poses(flown_poses(ground.is_quick)));
}

std::unique_ptr<Knob> make_output_rate_knob(const KnobGround& ground) {
    auto flight = std::make_unique<KnobFlight>(ground);
    std::vector<SeenPose> seen =
        seen_poses(ground.ground, flight->poses(flown_poses(ground.is_quick)), seen_grid(ground.display));
    return std::make_unique<OutputRateKnob>(ground, std::move(flight), std::move(seen));
}

}  // namespace tedavis::host_sim
