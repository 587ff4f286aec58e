#include "host_sim/accuracy/knobs/crack_knob.hpp"

#include <algorithm>

#include "host_sim/accuracy/knobs/flown_knob.hpp"
#include "host_sim/accuracy/knobs/seen_ground.hpp"

namespace tedavis::host_sim {
namespace {

constexpr PictureSize kCrackPicture = {320, 180};
constexpr double kCrackTau_px = 0.9;  ///< less than the pixel by which inner_ground() keeps away from outlines
constexpr std::size_t kCrackPoses = 24, kQuickCrackPoses = 6;
constexpr double kPerMillion = 1e6;

KnobFacts crack_facts() {
    return {"terrain_cracks",
            "How chunks of different detail join",
            "render_core/terrain: no setting",
            "pixels of ground that show the background, 320 x 180 pixels, terrain within 0.9 px",
            "per million pixels",
            {"rays to the database's own surface; a pixel counts if its eight neighbours meet ground, too", 0,
             "no outline is off by a pixel, so none reaches such a pixel"},
            "tests/render_core/terrain compares the vertices of shared borders bit by bit",
            "Cracks are at no level traded for time.",
            "no scale: one level",
            std::nullopt,
            {{"shared borders", 0}},
            "a background that is seen through the ground is a wrong picture, whatever it saves"};
}

/// Everything that no terrain covers has one colour that no ground has.
void make_background_plain(design::DesignSettings& design) {
    constexpr design::Color kPlain{255, 0, 255};
    design.sky.zenith = design.sky.horizon = design.sky.ground = design.sky.ground_horizon = kPlain;
    design.sky.haze_distance_m = 0;
}

enum Side : std::size_t { kWithTerrain, kBackground };

std::vector<FlownLevel> crack_levels(const std::string& terrain) {
    FlownLevel level;
    level.picture.size = kCrackPicture;
    level.picture.tau_px = kCrackTau_px;
    level.picture.symbology = false;
    level.change = make_background_plain;
    FlownLevel background = level;
    level.picture.terrain = terrain;
    return {level, background};
}

class CrackKnob final : public FlownKnob {
public:
    CrackKnob(const TracedGround& ground, std::vector<AircraftPose> poses)
        : FlownKnob(crack_facts(), crack_levels(ground.path()), std::move(poses)) {
        TracedShotPlan plan;
        plan.width = kCrackPicture.width;
        plan.height = kCrackPicture.height;
        for (const AircraftPose& pose : pictures().poses()) {
            plan.pose = pose;
            inner_.push_back(inner_ground(seen_ground(ground, plan)));
        }
        worst_.resize(inner_.size());
    }

    void find_errors(std::size_t /*level*/, std::size_t sample, std::vector<double>& errors) override {
        if (inner_[sample].empty()) return;
        const RgbaPicture background = upright(pictures().picture(kBackground, sample));
        const RgbaView drawn = pictures().picture(kWithTerrain, sample);
        const std::vector<KnobPixel> cracks = cracks_among(inner_[sample], drawn, view_of(background));
        if (!cracks.empty()) worst_[sample] = cracks.front();
        errors.push_back(kPerMillion * static_cast<double>(cracks.size()) / static_cast<double>(inner_[sample].size()));
    }
    [[nodiscard]] std::optional<KnobPixel> pixel_of(std::size_t sample, std::size_t /*error*/) const override {
        return worst_[sample];
    }

private:
    /// Pixels that meet ground, as their neighbours do.
    static std::vector<KnobPixel> inner_ground(const std::vector<SeenPlace>& seen) {
        std::vector<bool> is_ground(std::size_t{kCrackPicture.width} * kCrackPicture.height);
        const auto at = [](std::uint32_t x, std::uint32_t y) { return std::size_t{y} * kCrackPicture.width + x; };
        for (const SeenPlace& place : seen) is_ground[at(place.x, place.y)] = true;
        std::vector<KnobPixel> inner;
        for (std::uint32_t y = 1; y + 1 < kCrackPicture.height; ++y)
            for (std::uint32_t x = 1; x + 1 < kCrackPicture.width; ++x) {
                bool all = true;
                for (std::uint32_t row = y - 1; row <= y + 1; ++row)
                    for (std::uint32_t column = x - 1; column <= x + 1; ++column) all = all && is_ground[at(column, row)];
                if (all) inner.push_back({x, y});
            }
        return inner;
    }

    std::vector<std::vector<KnobPixel>> inner_;  ///< by pose
    std::vector<KnobPixel> worst_;               ///< a crack of each pose, or the corner
};

}  // namespace

std::vector<KnobPixel> cracks_among(const std::vector<KnobPixel>& pixels, const RgbaView& drawn, const RgbaView& background) {
    std::vector<KnobPixel> cracks;
    for (const KnobPixel& pixel : pixels) {
        const std::size_t at = std::size_t{4} * pixel.x;
        const std::uint8_t *const a = drawn.row(pixel.y) + at, *const b = background.row(pixel.y) + at;
        const bool is_bare = b[0] > 200 && b[1] < 60 && b[2] > 200;  // no legend lies over it
        if (is_bare && std::equal(a, a + 3, b)) cracks.push_back(pixel);
    }
    return cracks;
}

std::unique_ptr<Knob> make_crack_knob(const KnobGround& ground) {
    return std::make_unique<CrackKnob>(ground.ground, KnobFlight(ground).poses(ground.is_quick ? kQuickCrackPoses : kCrackPoses));
}

}  // namespace tedavis::host_sim
