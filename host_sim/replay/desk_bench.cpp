#include "host_sim/replay/desk_bench.hpp"

#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/load_design.hpp"
#include "host_sim/user_error.hpp"
#include "platform/clock/monotonic_clock.hpp"
#include "render_core/base/units.hpp"
#include "render_core/effects/design_effects.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/readback.hpp"

namespace tedavis::host_sim {
namespace {

using effects::Effect;
using effects::Overhead;
using platform::BenchNote;
using platform::BenchPicture;

constexpr const char* kGlyphDesign = "data/wind_arrows";
constexpr const char* kElementDesign = "default";  // with few glyphs, whose cost is taken off
constexpr const char* kBlurDesign = "focus/blur";
enum QualityPicture : std::size_t { kWithEmbellishments, kWithGlyphs, kWithFocus, kWithSaliency, kQualityPictureCount };

/// Of effects that need more of a design than to be asked for.
struct RequestingDesign {
    Effect effect;
    const char* design;
};
constexpr RequestingDesign kRequestingDesigns[] = {
    {Effect::surface_grid, "styles/line_texture"},   {Effect::warning_colors, "styles/relative_height"},
    {Effect::ridges, "styles/ridges_and_valleys"},   {Effect::moving_sun, "styles/moving_sun"},
    {Effect::drape, "styles/aerial_image"},          {Effect::ground_data, "data/ground_continuous"},
    {Effect::adjacent, "data/adjacent_uncertainty"}, {Effect::vertical_lines, "effects/vertical_lines"},
    {Effect::projections, "effects/projections"},    {Effect::curtains, "effects/curtains"},
    {Effect::soft_shadows, "effects/soft_shadows"},  {Effect::volumetric_light, "effects/volumetric_light"},
    {Effect::focus_ground, "focus/brightness"},      {Effect::focus_blur, kBlurDesign}};

void embellish(design::DesignSettings& design) {
    for (std::size_t n = 0; n < effects::kEffectCount; ++n) {
        const effects::EffectRow& row = effects::row_of(static_cast<Effect>(n));
        if (row.may_be_given_up && row.contribution != effects::Contribution::content)
            design = effects::with_effect(design, row.effect);
    }
}

}  // namespace

std::string design_requesting(Effect effect) {
    for (const RequestingDesign& requesting : kRequestingDesigns)
        if (requesting.effect == effect) return requesting.design;
    const bool is_free = effect == Effect::terrain || effects::row_of(effect).cost == "none";
    return is_free ? "" : "default";
}

DeskBench::DeskBench(const PictureOptions& picture, Events events)
    : picture_(picture), events_(std::move(events)), device_(load_device(picture)), aircraft_(load_aircraft(picture.aircraft)) {
    for (const char* const design : {picture.design.c_str(), kGlyphDesign, kElementDesign, kBlurDesign}) load(design);
    for (const RequestingDesign& requesting : kRequestingDesigns) load(requesting.design);
    const PictureSize size = picture.size.value_or(PictureSize{device_.width_px, device_.height_px});
    pixels_.resize(std::size_t{4} * size.width * size.height);
}

void DeskBench::load(const std::string& design) {
    PictureOptions options = picture_;
    options.design = design;
    designs_[design] = effects::design_on(device_, load_design(options));
}

void DeskBench::set(const std::string& design, BenchPicture& picture) const {
    picture.name = std::string_view(design);
    picture.design = designs_.at(design);
    picture.has_terrain = picture.has_scene = true;
}

void DeskBench::own_picture(BenchPicture& picture) const { set(picture_.design, picture); }

BenchNote DeskBench::picture_with(Effect effect, BenchPicture& picture) const {
    own_picture(picture);
    if (platform::asks_for(picture.design, effect)) return {};
    set(design_requesting(effect), picture);
    picture.design = effects::with_effect(picture.design, effect);
    return {};
}

BenchNote DeskBench::picture_with(Overhead overhead, BenchPicture& picture) const {
    set(overhead == Overhead::glyphs ? kGlyphDesign : kElementDesign, picture);
    return {};
}

std::size_t DeskBench::quality_pictures() const { return kQualityPictureCount; }

void DeskBench::quality_picture(std::size_t n, BenchPicture& picture) const {
    own_picture(picture);
    if (n == kWithEmbellishments) embellish(picture.design);
    if (n == kWithGlyphs) set(kGlyphDesign, picture);
    if (n == kWithFocus) set(kBlurDesign, picture);
    if (n == kWithSaliency) picture.design = effects::with_effect(picture.design, Effect::saliency);
}

platform::DisplayHostSettings DeskBench::settings_of(const BenchPicture& picture) const {
    platform::DisplayHostSettings settings = host_settings(picture_, device_);
    settings.display.design = picture.design;
    settings.display.aircraft = aircraft_;
    if (!picture.has_terrain) settings.terrain.path = "";
    if (!picture.has_scene) settings.scene.path = "";
    return settings;
}

/// A device without a compiler has its programs made first.
base::Error DeskBench::open(const BenchPicture& picture, std::unique_ptr<platform::DisplayHost>& host) {
    platform::DisplayHostSettings settings = settings_of(picture);
    MadePrograms programs;
    if (!gl::has_compiler(device_.capability)) {
        platform::DisplayHostSettings of_maker = settings;
        of_maker.display.device.capability = gl::with_compiler(device_.capability);
        settings.display.programs = of_maker.display.programs = &programs;
        if (const platform::HostFault fault = platform::DisplayHost().start(of_maker))
            return base::make_error(host_fault_text(fault, picture_));
    }
    host = std::make_unique<platform::DisplayHost>();
    const platform::HostFault fault = host->start(settings);
    return fault ? base::make_error(host_fault_text(fault, picture_)) : base::Error();
}

bool DeskBench::draw(platform::DisplayHost& host) {
    host.display().draw(host.surface());
    return gl::read_pixels(host.display().gl(), host.surface().width(), host.surface().height(),
                           {pixels_.data(), pixels_.size()});
}

base::Time DeskBench::now() const { return platform::monotonic_now(); }

void DeskBench::progress(std::size_t done, std::size_t total) {
    if (events_.progress) events_.progress(done, total);
}

effects::MeasuredCosts DeskBench::measure(const AircraftPose& place, std::uint32_t rounds) {
    platform::BenchPlace bench_place;
    bench_place.pose = stated_pose(place);
    bench_place.time = place.time;
    const auto bench = std::make_unique<platform::CostBench>(*this, bench_place, rounds);
    effects::MeasuredCosts measured;
    const base::Error error = bench->measure(measured);
    if (is_stopped()) throw Interrupted("interrupted; nothing was written");
    if (error) throw UserError(std::string(error.message.view()));
    measured.program = "tedavis calibrate";
    return measured;
}

}  // namespace tedavis::host_sim
