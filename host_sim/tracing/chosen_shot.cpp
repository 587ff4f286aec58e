#include "host_sim/tracing/chosen_shot.hpp"

#include <chrono>

#include "host_sim/tracing/ground_look.hpp"
#include "host_sim/tracing/shot_drawer.hpp"
#include "render_core/raytrace/picture/choose_settings.hpp"
#include "render_core/raytrace/picture/picture_error.hpp"
#include "render_core/raytrace/picture/trace_presets.hpp"

namespace tedavis::host_sim {
namespace {

using raytrace::PictureVariants;
using raytrace::RegionKind;
using raytrace::RegionView;
using Clock = std::chrono::steady_clock;

/// Draws frames one after the other, and keeps what the choice follows.
template <class Height>
class ChosenFrames {
public:
    ChosenFrames(const TracedGround& ground, const TracedShotPlan& plan, const ChoicePlan& choice, base::Workers& workers)
        : drawer_(ground, choice_levels(), plan),
          sun_(sun_at(plan.pose, plan.time)),
          look_(ground, sun_, plan.data),
          plan_(plan),
          workers_(workers),
          views_(std::size_t{PictureVariants::regions_across(plan.width)} * PictureVariants::regions_down(plan.height)),
          levels_(views_.size()),
          memory_(raytrace::SettingsChooser::bytes_needed(static_cast<std::uint32_t>(views_.size()))) {
        base::Arena arena(memory_.data(), memory_.size());
        if (!chooser_.start(static_cast<std::uint32_t>(views_.size()), arena))
            throw UserError("no memory to choose settings by region; name a smaller --size");
        limits_.deadline_ms = static_cast<float>(choice.deadline_ms);
        limits_.most_error = static_cast<float>(choice.most_error);
    }

    ChosenShot draw(const TracedGround& ground, std::uint32_t frames) {
        ChosenShot chosen;
        const auto begin = Clock::now();
        drawer_.build(ground, workers_);
        chosen.shot.build_ms = milliseconds_since(begin);
        measure_levels(chosen.levels);
        for (std::uint32_t n = 0; n < frames; ++n) chosen.frames.push_back(draw_frame(chosen.shot.rounds));
        std::vector<double> times;
        for (std::size_t n = chosen.frames.size() / 2; n < chosen.frames.size(); ++n)
            times.push_back(chosen.frames[n].picture_ms);
        std::sort(times.begin(), times.end());
        chosen.shot.picture_ms = times[times.size() / 2];
        chosen.shot.is_sun_too_low = sun_.is_too_low;
        drawer_.tell(chosen.shot);
        return chosen;
    }

private:
    static double milliseconds_since(Clock::time_point begin) {
        return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    }
    double draw_levels(std::uint32_t& rounds) {
        const auto begin = Clock::now();
        rounds = drawer_.draw(look_.look(), levels_, plan_.is_direct, workers_);
        return milliseconds_since(begin);
    }
    void look_at_regions() {
        const auto& stages = drawer_.stages();
        raytrace::view_regions(stages.hits(), stages.light(), plan_.width, plan_.height, stages.pixel_width_posts(), views_);
    }
    /// Each of them over the whole picture.
    void measure_levels(std::vector<ChoiceLevel>& measured) {
        std::vector<std::vector<glm::vec3>> light;
        std::uint32_t rounds = 0;
        (void)draw_levels(rounds);  // caches are warm when times count
        for (const raytrace::TraceSettings& settings : choice_levels()) {
            const auto level = static_cast<std::uint8_t>(light.size());
            std::fill(levels_.begin(), levels_.end(), level);
            const double ms = draw_levels(rounds);
            look_at_regions();
            expect(level, ms);
            const auto shown = drawer_.stages().light();
            light.emplace_back(shown.begin(), shown.end());
            measured.push_back({describe(settings), ms, 0});
        }
        best_ = light.back();
        limits_.levels = static_cast<std::uint32_t>(light.size());
        for (std::size_t n = 0; n < light.size(); ++n) {
            measured[n].error = raytrace::picture_error(light[n], best_);
            limits_.error[n] = static_cast<float>(measured[n].error);
        }
        std::fill(levels_.begin(), levels_.end(), std::uint8_t{0});
    }
    /// Regions of sky take a small part of what the others take; measurements correct that.
    void expect(std::uint8_t level, double picture_ms) {
        constexpr double kOfSky = 0.1;
        double shares = 0;
        for (const RegionView& view : views_) shares += view.kind == RegionKind::sky ? kOfSky : 1;
        for (const RegionKind kind : {RegionKind::sky, RegionKind::far, RegionKind::middle, RegionKind::near})
            costs_.expect(level, kind, static_cast<float>(picture_ms / shares * (kind == RegionKind::sky ? kOfSky : 1)));
    }
    ChosenFrame draw_frame(std::uint32_t& rounds) {
        const raytrace::Choice choice = chooser_.choose(views_, costs_, limits_, levels_);
        ChosenFrame frame;
        frame.expected_ms = choice.cost_ms;
        frame.keeps_deadline = choice.keeps_deadline;
        frame.picture_ms = draw_levels(rounds);
        look_at_regions();
        costs_.measure_picture(views_, levels_, static_cast<float>(frame.picture_ms));
        frame.error = raytrace::picture_error(drawer_.stages().light(), best_);
        frame.regions.resize(limits_.levels);
        for (const std::uint8_t level : levels_) ++frame.regions[level];
        return frame;
    }

    ShotDrawer<Height> drawer_;
    SunChoice sun_;
    GroundLook look_;
    TracedShotPlan plan_;
    base::Workers& workers_;
    std::vector<RegionView> views_;
    std::vector<std::uint8_t> levels_;
    std::vector<unsigned char> memory_;
    raytrace::SettingsChooser chooser_;
    raytrace::TraceCosts costs_;
    raytrace::ChoiceLimits limits_;
    std::vector<glm::vec3> best_;
};

template <class Height>
ChosenShot draw(const TracedGround& ground, const TracedShotPlan& plan, const ChoicePlan& choice, base::Workers& workers) {
    return ChosenFrames<Height>(ground, plan, choice, workers).draw(ground, choice.frames);
}

}  // namespace

std::vector<raytrace::TraceSettings> choice_levels() {
    raytrace::TraceSettings between = raytrace::time_preset();
    between.surface.kind = raytrace::SurfaceKind::bilinear;
    between.shading = raytrace::Shading::phong;
    between.ambient = raytrace::Ambient::apertures;
    return {raytrace::time_preset(), between, raytrace::quality_preset()};
}

ChosenShot draw_chosen_shot(const TracedGround& ground, const TracedShotPlan& plan, const ChoicePlan& choice,
                            base::Workers& workers) {
    return ground.is_whole() ? draw<std::int16_t>(ground, plan, choice, workers) : draw<float>(ground, plan, choice, workers);
}

}  // namespace tedavis::host_sim
