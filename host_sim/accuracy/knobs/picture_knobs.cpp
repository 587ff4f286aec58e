#include "host_sim/accuracy/knobs/picture_knobs.hpp"

#include "host_sim/accuracy/knobs/small_picture.hpp"

namespace tedavis::host_sim {
namespace {

using raytrace::TraceSettings;

constexpr std::uint32_t kRaysAlong[] = {1, 2, 4, 8};
constexpr std::uint32_t kPaths[] = {2, 4, 8, 16};
constexpr std::uint32_t kManyPaths = 2048;
constexpr std::uint32_t kPartsOfPixel = 16, kRaysAlongOfPart = 2;
constexpr std::size_t kViews = 4, kQuickViews = 1;
constexpr double kTurnOfView_deg = 90;
constexpr SmallView kRaysView = {24, 18}, kPathsView = {12, 9};
constexpr const char* kPicturesNeverTrade =
    "The display's warnings and symbology are not traced; they are drawn over every picture.";

TraceSettings with_rays(std::uint32_t along) {
    TraceSettings settings;
    settings.surface.kind = raytrace::SurfaceKind::two_triangles;
    settings.antialiasing = along > 1 ? raytrace::Antialiasing::supersampling : raytrace::Antialiasing::none;
    settings.rays_along = along;
    return settings;
}

TraceSettings with_paths(std::uint32_t paths) {
    TraceSettings settings;
    settings.surface.kind = raytrace::SurfaceKind::two_triangles;
    settings.paths = paths;
    return settings;
}

KnobFacts antialias_rays_facts() {
    return {"antialias_rays",
            "Rays of a pixel that covers more than half a post",
            "raytrace::TraceSettings::rays_along of `tedavis trace`: presets time 1, memory 2, quality 3",
            "root mean square of the difference of a pixel's linear light",
            "of the display's white",
            {"256 parts of each pixel, each with up to 4 rays", 0.012,
             "an outline is off by half a part, 1/32 of a contrast below 0.4; a test with 576 parts finds less"},
            "none: other tracers have other surfaces and lights; a test draws the reference with more parts",
            kPicturesNeverTrade,
            "rays of a pixel at most",
            ExpectedLaw{-0.6, 0.25, "NUMERICS K8: n^-0.5 at random to n^-0.75 for edges in strata"},
            {{"1 ray", 1}, {"4 rays", 4}, {"16 rays", 16}, {"64 rays", 64}}};
}

KnobFacts light_paths_facts() {
    return {"light_paths",
            "Paths of light from a pixel",
            "raytrace::TraceSettings::paths of `tedavis sheet trace`, two bounces; presets have local light instead",
            "root mean square of the difference of a pixel's linear light",
            "of the display's white",
            {"2048 paths of two bounces", 2e-4, "a test with 8192 paths finds less"},
            "closed form of an even sky over a plane (tests/render_core/raytrace/shading)",
            kPicturesNeverTrade,
            "paths",
            ExpectedLaw{-0.75, 0.3, "Monte Carlo: n^-0.5 at random, up to n^-1 for Sobol's sequence (Owen 1997)"},
            {{"2 paths", 2}, {"4 paths", 4}, {"8 paths", 8}, {"16 paths", 16}}};
}

class PictureKnob : public Knob {
public:
    PictureKnob(KnobFacts facts, const KnobGround& ground, const std::vector<TraceSettings>& settings, SmallView view)
        : Knob(std::move(facts)) {
        for (std::size_t n = 0; n < (ground.is_quick ? kQuickViews : kViews); ++n) {
            pictures_.push_back(std::make_unique<SmallPicture>(ground.ground, settings, view));
            view.heading_deg += kTurnOfView_deg;
        }
    }

    [[nodiscard]] std::size_t samples() const override { return pictures_.size(); }
    void run(std::size_t level, std::size_t sample) override { pictures_[sample]->draw(level); }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        run(level, sample);
        const base::Span<const glm::vec3> light = pictures_[sample]->light();
        for (std::size_t n = 0; n < light.size(); ++n) errors.push_back(light_difference(light[n], exact_[sample][n]));
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        const SmallView& view = pictures_[sample]->view();
        return "heading " + std::to_string(static_cast<int>(view.heading_deg)) + " degrees, pixel " +
               std::to_string(error % view.width) + ", " + std::to_string(error / view.width);
    }

protected:
    [[nodiscard]] const SmallView& view(std::size_t sample) const { return pictures_[sample]->view(); }
    void add_exact(std::vector<glm::vec3> light) { exact_.push_back(std::move(light)); }

private:
    std::vector<std::unique_ptr<SmallPicture>> pictures_;
    std::vector<std::vector<glm::vec3>> exact_;
};

class AntialiasRaysKnob final : public PictureKnob {
public:
    explicit AntialiasRaysKnob(const KnobGround& ground) : PictureKnob(antialias_rays_facts(), ground, levels(), kRaysView) {
        for (std::size_t sample = 0; sample < samples(); ++sample)
            add_exact(light_of_finer(ground.ground, with_rays(kRaysAlongOfPart), view(sample), kPartsOfPixel));
    }

private:
    static std::vector<TraceSettings> levels() {
        std::vector<TraceSettings> all;
        for (const std::uint32_t along : kRaysAlong) all.push_back(with_rays(along));
        return all;
    }
};

class LightPathsKnob final : public PictureKnob {
public:
    explicit LightPathsKnob(const KnobGround& ground) : PictureKnob(light_paths_facts(), ground, levels(), kPathsView) {
        for (std::size_t sample = 0; sample < samples(); ++sample)
            add_exact(light_of_finer(ground.ground, with_paths(kManyPaths), view(sample), 1));
    }

private:
    static std::vector<TraceSettings> levels() {
        std::vector<TraceSettings> all;
        for (const std::uint32_t paths : kPaths) all.push_back(with_paths(paths));
        return all;
    }
};

}  // namespace

std::unique_ptr<Knob> make_antialias_rays_knob(const KnobGround& ground) { return std::make_unique<AntialiasRaysKnob>(ground); }
std::unique_ptr<Knob> make_light_paths_knob(const KnobGround& ground) { return std::make_unique<LightPathsKnob>(ground); }

}  // namespace tedavis::host_sim
