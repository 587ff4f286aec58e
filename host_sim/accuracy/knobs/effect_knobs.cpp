#include "host_sim/accuracy/knobs/effect_knobs.hpp"

#include "host_sim/accuracy/knobs/color_knob.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint32_t kShadowSizes_px[] = {32, 48, 64, 128, 256, 512, 1024}, kFineShadow_px = 4096;
constexpr std::uint64_t kShadowTexelBytes = 8, kShadowMaps = 3;
constexpr std::uint32_t kShaftSteps[] = {8, 12, 16, 24, 64}, kFineShaftSteps = 16384;
constexpr std::uint32_t kBlurTaps[] = {4, 8, 16, 32, 64}, kFineBlurTaps = 16384;
constexpr std::uint32_t kBlurSquares_px[] = {4, 3, 2, 1}, kKnobBlurTaps = 64;
constexpr PictureSize kSmallPicture = {160, 90};  // of which each pixel takes so many steps and places for the reference
constexpr std::size_t kSmallPoses = 8, kQuickSmallPoses = 2;
constexpr double kBlurredFrom_m = 500;
constexpr std::uint32_t kFocusLevels[] = {2, 3, 4, 8, 16}, kEvenFocus = 0;
constexpr std::uint32_t kMapPages[] = {4, 6, 9, 12, 24};
constexpr const char* kDarkFocus =
    "shape = \"circle\", at = \"own_ship\", radius_m = 1000, context.width_m = 8000, terrain.brightness = 0.3";

constexpr const char* kEffectsNeverTrade = "Warnings, symbology and the terrain's shape are the same at every level.";

class EffectKnob final : public ColorKnob {
public:
    EffectKnob(KnobFacts facts, const ColorPlan& plan, std::vector<AircraftPose> poses, std::vector<std::uint64_t> bytes = {})
        : ColorKnob(std::move(facts), plan, std::move(poses)), bytes_(std::move(bytes)) {}

    [[nodiscard]] std::uint64_t bytes(std::size_t level) const override { return bytes_.empty() ? 0 : bytes_[level]; }

private:
    std::vector<std::uint64_t> bytes_;  ///< by level; empty: all levels take the same
};

FlownLevel drawn_level(const KnobGround& ground, const std::string& scene, const char* design) {
    FlownLevel level;
    level.picture.terrain = ground.ground.path();
    level.picture.scene = scene;
    level.picture.design = design;
    level.picture.size = kFlownSize;
    return level;
}

template <std::size_t count>
std::vector<KnobLevel> amount_levels(const std::uint32_t (&amounts)[count], const char* unit) {
    std::vector<KnobLevel> levels;
    for (const std::uint32_t amount : amounts)
        levels.push_back({std::to_string(amount) + " " + unit, static_cast<double>(amount)});
    return levels;
}

/// The bound is that of the measured poses: those of a quick run show less of shadows than all.
KnobFacts shadow_map_facts(bool is_quick) {
    const KnobReference finest = is_quick
                                     ? KnobReference("a map of 4096 texels along a side", 0.016,
                                                     "2048 texels differ by 0.0141 at most, and errors fall with texels^-0.95")
                                     : KnobReference("a map of 4096 texels along a side", 0.071,
                                                     "2048 texels differ by 0.0658 at most, and errors fall with texels^-0.95");
    return {"shadow_map",
            "Size of the map of shadows that data cast",
            "shadow_map_px of a device",
            kPictureMetric,
            kColorUnit,
            finest,
            "the place and the penumbra of single shadows by geometry (tests/render_core/draw/drawers)",
            kEffectsNeverTrade,
            "texels along a side",
            ExpectedLaw{-1, 0.35, "what differs is the strip of a texel along an outline"},
            amount_levels(kShadowSizes_px, "texels")};
}

KnobFacts shaft_steps_facts() {
    return {"shaft_steps",
            "Steps along a ray through shaded air",
            "steps of [effects.shadows] of a design, 8 to 64",
            "difference of a pixel's colour, mean over a picture of 160 x 90 pixels",
            kColorUnit,
            {"16384 steps", 0.022, "4096 steps differ by 0.018 at most, and errors fall with steps^-0.43"},
            "none: the sum of many steps is the integral",
            kEffectsNeverTrade,
            "steps",
            ExpectedLaw{-0.5, 0.2, "as of random samples: whether a step meets a thin shadow is chance"},
            amount_levels(kShaftSteps, "steps")};
}

KnobFacts blur_taps_facts() {
    return {"blur_taps",
            "Places that the blur of a pixel reads",
            "taps of [effects.depth_of_field] of a design, 4 to 64",
            "difference of a pixel's colour, mean over a picture of 160 x 90 pixels",
            kColorUnit,
            {"16384 places", 0.0149, "4096 places differ by 0.0184 at most, and errors fall with places^-0.58"},
            "none: the sum over many places is the integral over the disc",
            kEffectsNeverTrade,
            "places",
            ExpectedLaw{-0.75, 0.25, "places on a spiral cover a disc more evenly than random ones, whose exponent is -0.5"},
            amount_levels(kBlurTaps, "places")};
}

KnobFacts blur_squares_facts() {
    return {"blur_squares",
            "Squares of pixels in which the blur is computed",
            "blur_square_px of a device, 1 to 4",
            pixel_metric(kFlownSize),
            kColorUnit,
            {"squares of one pixel", 0, "it is one of the levels"},
            "the blur of each pixel by its definition in double precision (tests/render_core/draw/drawers/test_scene_blur.cpp)",
            kEffectsNeverTrade,
            "pixels along a side",
            std::nullopt,
            amount_levels(kBlurSquares_px, "px")};
}

KnobFacts focus_levels_facts() {
    return {"focus_levels",
            "Steps from a focus to its context",
            "levels of [focus.context] of a design, 1 to 16; 0 is without steps",
            pixel_metric(kFlownSize),
            kColorUnit,
            {"a context without steps", 0.2, "its colours are rounded to 1/255, half of which is less than this for dark ground"},
            "none: the even course is what steps approximate",
            kEffectsNeverTrade,
            "steps",
            ExpectedLaw{-1, 0.25, "an even course in n steps is off by 1/4n in the mean"},
            amount_levels(kFocusLevels, "steps")};
}

KnobFacts map_pages_facts() {
    return {"map_pages",
            "Pages of baked maps of the terrain in memory",
            "attribute_pages of a device; normals = \"baked\" in a design",
            kTileMetric,
            kColorUnit,
            {"pages for every chunk in view", 0, "it is one of the levels"},
            "none: the maps in memory are what the finest level shows",
            "Warnings, symbology and the terrain's shape are the same at every level; a missing page gives way to a coarser one.",
            "pages",
            std::nullopt,
            amount_levels(kMapPages, "pages")};
}

ColorPlan shadow_map_plan(const KnobGround& ground, const std::string& scene, const std::string& folder) {
    ColorPlan plan;
    plan.tile = kFlownSize;
    plan.reference = std::size(kShadowSizes_px);
    for (std::size_t n = 0; n <= std::size(kShadowSizes_px); ++n) {
        const std::uint32_t size_px = n < std::size(kShadowSizes_px) ? kShadowSizes_px[n] : kFineShadow_px;
        const std::uint64_t more = kShadowMaps * kShadowTexelBytes * size_px * size_px;
        FlownLevel level = drawn_level(ground, scene, "effects/soft_shadows");
        level.has_own_device = true;
        level.picture.device = changed_device(folder, "shadows_" + std::to_string(size_px), "es3-mid",
                                              {{"", "max_texture_px", "16384"},
                                               {"", "shadow_map_px", std::to_string(size_px)},
                                               {"name = \"render_targets\"", "bytes", std::to_string((32u << 20) + more)}});
        plan.drawn.push_back(level);
    }
    return plan;
}

ColorPlan shaft_steps_plan(const KnobGround& ground, const std::string& scene) {
    ColorPlan plan;
    plan.size = plan.tile = kSmallPicture;
    plan.reference = std::size(kShaftSteps);
    for (std::size_t n = 0; n <= std::size(kShaftSteps); ++n) {
        const std::uint32_t steps = n < std::size(kShaftSteps) ? kShaftSteps[n] : kFineShaftSteps;
        FlownLevel level = drawn_level(ground, scene, "effects/volumetric_light");
        level.picture.size = kSmallPicture;
        level.change = [steps](design::DesignSettings& design) { design.effects.shadows.steps = steps; };
        plan.drawn.push_back(level);
    }
    return plan;
}

/// Everything from 500 m on is blurred, as widely as designs may ask for.
void blur_widely(design::DesignSettings& design, std::uint32_t taps) {
    design::DepthOfField& field = design.effects.depth_of_field;
    field.taps = taps;
    field.blur_px = design::kMaxBlur_px;
    field.focus_near_m = 0;
    field.focus_far_m = kBlurredFrom_m;
}

ColorPlan blur_taps_plan(const KnobGround& ground) {
    ColorPlan plan;
    plan.size = plan.tile = kSmallPicture;
    plan.reference = std::size(kBlurTaps);
    for (std::size_t n = 0; n <= std::size(kBlurTaps); ++n) {
        const std::uint32_t taps = n < std::size(kBlurTaps) ? kBlurTaps[n] : kFineBlurTaps;
        FlownLevel level = drawn_level(ground, "", "effects/depth_of_field");
        level.picture.size = kSmallPicture;
        level.change = [taps](design::DesignSettings& design) { blur_widely(design, taps); };
        plan.drawn.push_back(level);
    }
    return plan;
}

ColorPlan blur_squares_plan(const KnobGround& ground, const std::string& folder) {
    ColorPlan plan;
    plan.reference = std::size(kBlurSquares_px) - 1;
    for (const std::uint32_t square_px : kBlurSquares_px) {
        FlownLevel level = drawn_level(ground, "", "effects/depth_of_field");
        level.has_own_device = true;
        level.picture.device = changed_device(folder, "squares_" + std::to_string(square_px), "es3-mid",
                                              {{"", "blur_square_px", std::to_string(square_px)}});
        level.change = [](design::DesignSettings& design) { blur_widely(design, kKnobBlurTaps); };
        plan.drawn.push_back(level);
    }
    return plan;
}

ColorPlan focus_levels_plan(const KnobGround& ground) {
    ColorPlan plan;
    plan.reference = std::size(kFocusLevels);
    for (std::size_t n = 0; n <= std::size(kFocusLevels); ++n) {
        const std::uint32_t levels = n < std::size(kFocusLevels) ? kFocusLevels[n] : kEvenFocus;
        plan.drawn.push_back(drawn_level(ground, "", "default"));
        plan.drawn.back().picture.without.add(effects::Effect::warning_colors);  // which no focus darkens
        plan.drawn.back().picture.foci = {std::string(kDarkFocus) + ", context.levels = " + std::to_string(levels)};
    }
    return plan;
}

ColorPlan map_pages_plan(const KnobGround& ground, const std::string& folder) {
    ColorPlan plan;
    plan.tile = kTile;
    plan.reference = std::size(kMapPages) - 1;
    for (const std::uint32_t pages : kMapPages) {
        FlownLevel level = drawn_level(ground, "", "styles/ambient_occlusion");
        level.has_own_device = true;
        level.picture.device =
            changed_device(folder, "pages_" + std::to_string(pages), "es3-mid", {{"", "attribute_pages", std::to_string(pages)}});
        plan.drawn.push_back(level);
    }
    return plan;
}

}  // namespace

std::unique_ptr<Knob> make_shadow_map_knob(const KnobGround& ground) {
    KnobFlight flight(ground);
    const TemporaryFolder folder;
    std::vector<std::uint64_t> bytes;
    for (const std::uint64_t size_px : kShadowSizes_px) bytes.push_back(kShadowMaps * kShadowTexelBytes * size_px * size_px);
    return std::make_unique<EffectKnob>(shadow_map_facts(ground.is_quick), shadow_map_plan(ground, flight.scene(), folder.path()),
                                        flight.poses(flown_poses(ground.is_quick)), std::move(bytes));
}

std::unique_ptr<Knob> make_shaft_steps_knob(const KnobGround& ground) {
    KnobFlight flight(ground);
    return std::make_unique<EffectKnob>(shaft_steps_facts(), shaft_steps_plan(ground, flight.scene()),
                                        flight.poses(ground.is_quick ? kQuickSmallPoses : kSmallPoses));
}

std::unique_ptr<Knob> make_blur_taps_knob(const KnobGround& ground) {
    return std::make_unique<EffectKnob>(blur_taps_facts(), blur_taps_plan(ground),
                                        KnobFlight(ground).poses(ground.is_quick ? kQuickSmallPoses : kSmallPoses));
}

std::unique_ptr<Knob> make_blur_squares_knob(const KnobGround& ground) {
    const TemporaryFolder folder;
    return std::make_unique<EffectKnob>(blur_squares_facts(), blur_squares_plan(ground, folder.path()),
                                        KnobFlight(ground).poses(flown_poses(ground.is_quick)));
}

std::unique_ptr<Knob> make_focus_levels_knob(const KnobGround& ground) {
    return std::make_unique<EffectKnob>(focus_levels_facts(), focus_levels_plan(ground),
                                        KnobFlight(ground).poses(flown_poses(ground.is_quick)));
}

std::unique_ptr<Knob> make_map_pages_knob(const KnobGround& ground) {
    const TemporaryFolder folder;
    std::vector<std::uint64_t> bytes;
    for (const std::uint64_t pages : kMapPages) bytes.push_back(pages * sizeof(terrain::AttributePage));
    return std::make_unique<EffectKnob>(map_pages_facts(), map_pages_plan(ground, folder.path()),
                                        KnobFlight(ground).poses(flown_poses(ground.is_quick)), std::move(bytes));
}

}  // namespace tedavis::host_sim
