#include "host_sim/accuracy/knobs/terrain_tau_knob.hpp"

#include <glm/geometric.hpp>

#include "host_sim/accuracy/knobs/flown_knob.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kTaus_px[] = {16, 8, 4, 2, 1, 0.5};
constexpr std::size_t kTauPoses = 32, kQuickTauPoses = 8;

KnobFacts terrain_tau_facts(const FlownDisplay& display) {
    std::vector<KnobLevel> levels;
    for (const double tau_px : kTaus_px) {
        char name[16];
        std::snprintf(name, sizeof name, "%g px", tau_px);
        levels.push_back({name, tau_px});
    }
    return {
        "terrain_tau",
        "Error that the terrain may have on the screen",
        "tau_px of a design, and --tau",
        "distance on the screen between the drawn and the true place of ground that a pixel shows, " + size_text(display.size) +
            " pixels",
        "px",
        {"the database's own heights, two triangles a cell, projected in doubles", kSeenErrorBound_px * pixel_scale(display),
         "heights are interpolated from floats relative to a chunk, to 0.2 mm; ground is 50 m away or farther"},
        "the bound that the display states for each frame, which a test finds above every error; a proof over 10,000 poses from "
        "the elevation raster itself (tests/poses)",
        "Warnings and symbology are drawn at every level; beyond terrain_error_px of a design the display says that terrain is "
        "degraded.",
        "pixels",
        ExpectedLaw{1, 0.25, "errors of chunks are as large as they may be"},
        std::move(levels),
        std::nullopt,
        KnobWork{"triangles", {-1.66, 0.4, "Lindstrom and Pascucci (2001): 79,382 at 2 px and 25,100 at 4 px over Puget Sound"}}};
}

std::vector<FlownLevel> terrain_tau_levels(const KnobGround& ground) {
    std::vector<FlownLevel> levels;
    for (const double tau_px : kTaus_px) levels.push_back(terrain_level(ground.ground.path(), tau_px, ground.display));
    return levels;
}

class TerrainTauKnob final : public FlownKnob {
public:
    TerrainTauKnob(const KnobGround& ground, std::vector<SeenPose> seen)
        : FlownKnob(terrain_tau_facts(ground.display), terrain_tau_levels(ground), poses_of(seen)),
          grid_(seen_grid(ground.display)),
          size_(ground.display.size),
          seen_(std::move(seen)),
          triangles_(std::size(kTaus_px)),
          measured_(seen_.size()),
          proven_(std::size(kTaus_px)) {}

    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        display::Display& display = pictures().display(level, sample);
        if (sample == 0) triangles_[level] = 0;
        triangles_[level] += display.planned().counters.triangles;
        proven_[level] = std::max(proven_[level], display.record().terrain.worst_error_px);
        measured_[sample].clear();
        for (const SeenPlace& place : seen_[sample].places)
            if (const auto error = terrain_error_px(display, place)) {
                errors.push_back(*error);
                measured_[sample].push_back(place);
            }
    }
    [[nodiscard]] std::optional<KnobPixel> pixel_of(std::size_t sample, std::size_t error) const override {
        return seen_pixel(measured_[sample][error], grid_, size_);
    }
    [[nodiscard]] std::optional<double> proven(std::size_t level) const override { return proven_[level]; }
    [[nodiscard]] double work(std::size_t level) const override { return triangles_[level] / static_cast<double>(samples()); }

private:
    SeenGrid grid_;
    PictureSize size_;
    std::vector<SeenPose> seen_;
    std::vector<double> triangles_;                 ///< by level, of all poses
    std::vector<std::vector<SeenPlace>> measured_;  ///< by pose, of the level that was measured last
    std::vector<double> proven_;                    ///< by level, over the poses whose errors were found
};

}  // namespace

std::optional<double> terrain_error_px(display::Display& display, const SeenPlace& place) {
    const terrain::DrawnPoint drawn = display.planner().terrain().drawn_point(place.latitude_rad, place.longitude_rad);
    const terrain::View& view = display.planned().picture.camera.view;
    if (!drawn.found) return std::nullopt;
    const auto here = pixel_at(view, drawn.position), there = pixel_at(view, place.position);
    if (!here || !there) return std::nullopt;
    return glm::distance(*here, *there);
}

std::unique_ptr<Knob> make_terrain_tau_knob(const KnobGround& ground) {
    const std::vector<AircraftPose> poses = KnobFlight(ground).poses(ground.is_quick ? kQuickTauPoses : kTauPoses);
    return std::make_unique<TerrainTauKnob>(ground, seen_poses(ground.ground, poses, seen_grid(ground.display)));
}

}  // namespace tedavis::host_sim
