#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "render_core/draw/symbology/symbology.hpp"
#include "render_core/draw/symbology/tape_marks.hpp"
#include "tests/support/draw/batch_shapes.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_speed_and_altitude {
namespace {

using policy::Element;
using policy::ElementShow;
using policy::MinimumsState;
using test_support::BatchShape;
using test_support::BatchStore;
using test_support::bounds_of;
using test_support::scene_input;
using test_support::scene_state;
using test_support::shapes_in;
using test_support::text_in;

using Builder = void (*)(const Painter&, const SymbologyInput&);
struct Screen {
    std::uint32_t width, height;
};
constexpr Screen kScreens[] = {{640, 480}, {1280, 720}, {480, 640}};
constexpr Element kMarkElements[] = {Element::selected_airspeed, Element::selected_altitude, Element::selected_vertical_speed,
                                     Element::baro_minimum, Element::airspeed_trend};

/// 128 kt, 4520 ft, -500 ft/min; nothing selected, no trend, no minimum.
class Scene {
public:
    explicit Scene(const Screen& screen)
        : layout(make_layout(screen.width, screen.height, 96)),
          input(scene_input(scene_state(47, 0, 0), screen.width, screen.height)) {
        for (const Element element : kMarkElements) show(element, ElementShow::absent);
    }

    void show(Element element, ElementShow how) { input.decisions[element].show = how; }
    void build(Builder builder) {
        store.batch.clear();
        builder(Painter(store.batch, layout), input);
        EXPECT_EQ(store.batch.use().refused, 0u);
    }
    [[nodiscard]] std::vector<BatchShape> shapes(const Rect& where, design::Color color) const {
        return shapes_in(store.batch, where, color);
    }
    [[nodiscard]] std::string text(const Rect& where, design::Color color) const { return text_in(store.batch, where, color); }
    /// The ground below a scale, which is the scale's box.
    [[nodiscard]] Rect scale(const Rect& box) const {
        return bounds_of(shapes(box, test_support::day_color(SymbolRole::tape_ground)));
    }
    [[nodiscard]] Rect readout(const Rect& box) const {
        const Rect ground = scale(box);
        return {ground.x, ground.center().y - 1.1f * layout.text_px, ground.width, 2.2f * layout.text_px};
    }
    /// Lines whose middle is on the track of the trend, which is `inset` texts from the edge.
    [[nodiscard]] Rect trend(const Rect& box, bool ticks_right) const {
        const Rect ground = scale(box);
        const float inset = kTrendInset * layout.text_px, x = ticks_right ? ground.right() - inset : ground.x + inset;
        return bounds_of(shapes({x - 1, ground.y, 2, ground.height}, test_support::day_color(SymbolRole::scale)));
    }

    Layout layout;
    SymbologyInput input;
    BatchStore store;
};

/// Units that the scale has for each pixel, by its height.
double y_of(const Rect& scale, double above_middle, double span) {
    return static_cast<double>(scale.center().y) - above_middle * static_cast<double>(scale.height) / span;
}

TEST(Symbology, P11SpeedTapeStandsLeftAndItsLastDigitRolls) {
    for (const Screen& screen : kScreens) {
        Scene scene(screen);
        const Rect& box = scene.layout.airspeed;
        EXPECT_LT(box.right(), scene.layout.screen.center().x);
        scene.input.airspeed_mps = 128.5 * base::kMpsPerKnot;
        scene.build(build_airspeed);
        EXPECT_EQ(scene.text(scene.readout(box), test_support::day_color(SymbolRole::scale)), "1298")
            << "the nearest reading, then the digit that leaves";
        scene.input.airspeed_mps = 199.6 * base::kMpsPerKnot;
        scene.build(build_airspeed);
        EXPECT_EQ(scene.text(scene.readout(box), test_support::day_color(SymbolRole::scale)), "200199")
            << "tens and hundreds roll along";
        scene.input.airspeed_mps = 128.04 * base::kMpsPerKnot;
        scene.build(build_airspeed);
        EXPECT_EQ(scene.text(scene.readout(box), test_support::day_color(SymbolRole::scale)), "128")
            << "control: at rest only one is seen";
    }
}

/// Bands around the 128 kt of the scene, as those of a light aircraft.
policy::SpeedBands speed_bands_around() {
    using policy::SpeedBandRole;
    policy::SpeedBands bands;
    const auto add = [&](double low_kt, double high_kt, SpeedBandRole role) {
        EXPECT_TRUE(bands.bands.try_push_back({low_kt * base::kMpsPerKnot, high_kt * base::kMpsPerKnot, role}));
    };
    add(0, 90, SpeedBandRole::low_warning);
    add(90, 100, SpeedBandRole::low_caution);
    add(100, 140, SpeedBandRole::normal);
    add(140, 160, SpeedBandRole::caution);
    add(160, 777, SpeedBandRole::above_limit);
    add(95, 115, SpeedBandRole::flaps_range);
    EXPECT_TRUE(bands.flags.try_push_back({"V2", 110 * base::kMpsPerKnot}));
    return bands;
}

/// The part of the scale where its bands are.
Rect band_column(const Scene& scene, const Rect& scale) {
    const float t = scene.layout.text_px;
    return {scale.right() - (kFlagWidth + kBandWidth) * t, scale.y, kBandWidth * t, scale.height};
}
/// The highest shape of the color there.
Rect band_bounds(const Scene& scene, const Rect& scale, design::Color color) {
    Rect bounds;
    for (const BatchShape& shape : scene.shapes(band_column(scene, scale), color))
        if (shape.bounds.height > bounds.height && shape.bounds.width > 0.5f * scene.layout.stroke_px &&
            shape.bounds.right() < scale.right() - kFlagWidth * scene.layout.text_px + 0.01f)
            bounds = shape.bounds;
    return bounds;
}

TEST(Symbology, P12SpeedBandsAndFlagsStandAtTheirSpeeds) {
    for (const Screen& screen : kScreens) {
        Scene scene(screen);
        const Rect& box = scene.layout.airspeed;
        scene.input.bands = speed_bands_around();
        scene.build(build_airspeed);
        const Rect scale = scene.scale(box);
        const auto expect_between = [&](design::Color color, double low_kt, double high_kt) {
            const Rect band = band_bounds(scene, scale, color);
            EXPECT_NEAR(static_cast<double>(band.bottom()), y_of(scale, low_kt - 128, 100), 0.1) << low_kt;
            EXPECT_NEAR(static_cast<double>(band.y), y_of(scale, high_kt - 128, 100), 0.1) << high_kt;
        };
        expect_between(test_support::day_color(SymbolRole::engaged), 100, 140);
        expect_between(test_support::day_color(SymbolRole::reference), 140, 160);
        expect_between(test_support::day_color(SymbolRole::scale), 95, 115);
        EXPECT_LT(band_bounds(scene, scale, test_support::day_color(SymbolRole::scale)).width,
                  0.6f * band_bounds(scene, scale, test_support::day_color(SymbolRole::engaged)).width);
        const float t = scene.layout.text_px;
        const auto y = static_cast<float>(y_of(scale, 110 - 128, 100));
        EXPECT_EQ(scene.text({scale.right() - kFlagWidth * t, y - 0.5f * t, kFlagWidth * t, t},
                             test_support::day_color(SymbolRole::scale)),
                  "V2");
        scene.input.bands = {};
        scene.build(build_airspeed);
        for (const design::Color color :
             {test_support::day_color(SymbolRole::engaged), test_support::day_color(SymbolRole::reference),
              test_support::day_color(SymbolRole::warning), test_support::day_color(SymbolRole::caution)})
            EXPECT_TRUE(scene.shapes(box, color).empty()) << "control: no aircraft file";
    }
}

TEST(Symbology, P12AboveTheLimitIsRedAndAPoleHasWhiteStripes) {
    Scene scene(kScreens[0]);
    const Rect& box = scene.layout.airspeed;
    scene.input.bands = speed_bands_around();
    scene.input.airspeed_mps = 160 * base::kMpsPerKnot;
    const auto stripes = [&] {
        scene.build(build_airspeed);
        Rect column = band_column(scene, scene.scale(box));
        column.height /= 2;
        EXPECT_FALSE(scene.shapes(column, test_support::day_color(SymbolRole::warning)).empty());
        int count = 0;
        for (const BatchShape& shape : scene.shapes(column, test_support::day_color(SymbolRole::scale)))
            count += std::fabs(shape.bounds.width - column.width) < 0.1f ? 1 : 0;
        return count;
    };
    EXPECT_EQ(stripes(), 0);
    scene.input.bands.has_pole = true;
    EXPECT_GT(stripes(), 5);
}

TEST(Symbology, P13LowSpeedIsAmberThenRedDownToTheScalesEnd) {
    for (const Screen& screen : kScreens) {
        Scene scene(screen);
        const Rect& box = scene.layout.airspeed;
        scene.input.bands = speed_bands_around();
        scene.input.airspeed_mps = 95 * base::kMpsPerKnot;
        scene.build(build_airspeed);
        const Rect scale = scene.scale(box);
        const Rect amber = band_bounds(scene, scale, test_support::day_color(SymbolRole::caution)),
                   red = band_bounds(scene, scale, test_support::day_color(SymbolRole::warning));
        EXPECT_NEAR(static_cast<double>(amber.y), y_of(scale, 100 - 95, 100), 0.1);
        EXPECT_NEAR(static_cast<double>(amber.bottom()), y_of(scale, 90 - 95, 100), 0.1);
        EXPECT_NEAR(red.y, amber.bottom(), 0.1f);
        EXPECT_NEAR(red.bottom(), scale.bottom() - 2 * scene.layout.stroke_px, 0.1f) << "but for the rim";
        scene.input.airspeed_mps = 97 * base::kMpsPerKnot;
        scene.build(build_airspeed);
        EXPECT_GT(band_bounds(scene, scale, test_support::day_color(SymbolRole::caution)).y, amber.y) << "control: moved";
    }
}

TEST(Symbology, P14SpeedTrendIsWhereTheAirspeedWillBeInSixSeconds) {
    for (const Screen& screen : kScreens) {
        Scene scene(screen);
        const Rect& box = scene.layout.airspeed;
        scene.show(Element::airspeed_trend, ElementShow::normal);
        for (const double knots_per_s : {-3.0, 1.5, 4.0}) {
            scene.input.guidance.airspeed_rate_mps2 = knots_per_s * base::kMpsPerKnot;
            scene.build(build_airspeed);
            const Rect scale = scene.scale(box), trend = scene.trend(box, true);
            ASSERT_FALSE(trend.empty());
            const double end = static_cast<double>(knots_per_s > 0 ? trend.y : trend.bottom());
            EXPECT_NEAR(end, y_of(scale, 6 * knots_per_s, 100), static_cast<double>(scene.layout.stroke_px)) << knots_per_s;
            EXPECT_NEAR(static_cast<double>(knots_per_s > 0 ? trend.bottom() : trend.y), y_of(scale, 0, 100), 1.0);
        }
        scene.input.guidance.airspeed_rate_mps2 = 0.9 / 6 * base::kMpsPerKnot;
        scene.build(build_airspeed);
        EXPECT_TRUE(scene.trend(box, true).empty()) << "below 1 kt in 6 s";
        scene.input.guidance.airspeed_rate_mps2 = 4 * base::kMpsPerKnot;
        scene.show(Element::airspeed_trend, ElementShow::absent);
        scene.build(build_airspeed);
        EXPECT_TRUE(scene.trend(box, true).empty()) << "control: removed";
    }
}

/// Of the boldest tick at this height beside the edge, strokes.
float tick_strokes(const Scene& scene, const Rect& scale, double y) {
    float height = 0;
    for (const BatchShape& tick :
         scene.shapes({scale.x, static_cast<float>(y) - 1, scene.layout.text_px, 2}, test_support::day_color(SymbolRole::scale)))
        if (tick.bounds.width < scene.layout.text_px) height = std::max(height, tick.bounds.height);
    return height / scene.layout.stroke_px;
}

TEST(Symbology, P15AltitudeTapeStandsRightRollsAndEmphasizesFiveHundredsAndThousands) {
    for (const Screen& screen : kScreens) {
        Scene scene(screen);
        const Rect& box = scene.layout.altitude;
        EXPECT_GT(box.x, scene.layout.screen.center().x);
        scene.input.altitude_m = 4790 * base::kMetresPerFoot;
        scene.build(build_altitude);
        EXPECT_EQ(scene.text(scene.readout(box), test_support::day_color(SymbolRole::scale)), "4800780")
            << "the nearest reading, then what leaves";
        const Rect scale = scene.scale(box);
        EXPECT_NEAR(tick_strokes(scene, scale, y_of(scale, 5000 - 4790, 1000)), 3, 0.01);
        EXPECT_NEAR(tick_strokes(scene, scale, y_of(scale, 4500 - 4790, 1000)), 2, 0.01);
        EXPECT_NEAR(tick_strokes(scene, scale, y_of(scale, 4600 - 4790, 1000)), 1, 0.01) << "control";
        const std::string text = scene.text(scale, test_support::day_color(SymbolRole::scale));
        EXPECT_NE(text.find("5000"), std::string::npos) << text;
        EXPECT_NE(text.find("4500"), std::string::npos) << text;
        scene.input.altitude_m = -30 * base::kMetresPerFoot;
        scene.build(build_altitude);
        EXPECT_EQ(scene.text(scene.readout(box), test_support::day_color(SymbolRole::scale)), "-2040") << "below the sea";
    }
}

TEST(Symbology, P16AltitudeTrendIsWhereTheAltitudeWillBeInSixSeconds) {
    for (const Screen& screen : kScreens) {
        Scene scene(screen);
        const Rect& box = scene.layout.altitude;
        for (const double fpm : {-2000.0, 900.0}) {
            scene.input.vertical_speed_mps = fpm * base::kMpsPerFootPerMinute;
            scene.build(build_altitude);
            const Rect scale = scene.scale(box), trend = scene.trend(box, false);
            ASSERT_FALSE(trend.empty());
            EXPECT_NEAR(static_cast<double>(fpm > 0 ? trend.y : trend.bottom()), y_of(scale, fpm / 10, 1000),
                        static_cast<double>(scene.layout.stroke_px))
                << fpm;
        }
        scene.show(Element::vertical_speed, ElementShow::flagged);
        scene.build(build_altitude);
        EXPECT_TRUE(scene.trend(box, false).empty()) << "control: of a stale vertical speed there is none";
        scene.show(Element::vertical_speed, ElementShow::normal);
        scene.input.vertical_speed_mps = 190 * base::kMpsPerFootPerMinute;
        scene.build(build_altitude);
        EXPECT_TRUE(scene.trend(box, false).empty()) << "below 20 ft in 6 s";
    }
}

struct Selected {
    Builder build;
    Rect Layout::*box;
    Element element;
    double GuidanceInput::*value;
    double unit, at, above_middle;  ///< in display units
    const char* text;
    const char* name;
};
constexpr Selected kSelected[] = {
    {build_airspeed, &Layout::airspeed, Element::selected_airspeed, &GuidanceInput::selected_airspeed_mps, base::kMpsPerKnot, 145,
     17, "145", "SPDSEL"},
    {build_altitude, &Layout::altitude, Element::selected_altitude, &GuidanceInput::selected_altitude_m, base::kMetresPerFoot,
     4800, 280, "4800", "ALTSEL"},
    {build_vertical_speed, &Layout::vertical_speed, Element::selected_vertical_speed, &GuidanceInput::selected_vertical_speed_mps,
     base::kMpsPerFootPerMinute, -1200, -1200, "-1200", "VSSEL"},
};

/// Display units over the height of the scale.
double span_of(const Selected& selected, const Scene& scene, const Rect& scale) {
    if (selected.build == build_airspeed) return 100;
    if (selected.build == build_altitude) return 1000;
    // The ends of this scale keep off the box's.
    return 4000 / (1 - 1.6 * static_cast<double>(scene.layout.text_px / scale.height));
}

TEST(Symbology, P17SelectedValuesStandAboveTheirScalesAndHaveBugs) {
    for (const Screen& screen : kScreens)
        for (const Selected& selected : kSelected) {
            Scene scene(screen);
            const Rect& box = scene.layout.*selected.box;
            scene.build(selected.build);
            EXPECT_TRUE(scene.shapes(box, test_support::day_color(SymbolRole::selected)).empty())
                << "control: nothing is selected";
            scene.show(selected.element, ElementShow::normal);
            scene.input.guidance.*selected.value = selected.at * selected.unit;
            scene.build(selected.build);
            const Rect scale = scene.scale(box),
                       bug = bounds_of(scene.shapes(scale, test_support::day_color(SymbolRole::selected)));
            const Rect above{box.x, box.y, box.width, scale.y - box.y};
            EXPECT_EQ(scene.text(above, test_support::day_color(SymbolRole::selected)), selected.text);
            EXPECT_NEAR(static_cast<double>(bug.center().y), y_of(scale, selected.above_middle, span_of(selected, scene, scale)),
                        0.1);
            scene.input.guidance.*selected.value += 3 * selected.unit;
            scene.build(selected.build);
            EXPECT_LT(bounds_of(scene.shapes(scale, test_support::day_color(SymbolRole::selected))).y, bug.y) << "control: moved";
            scene.input.guidance.*selected.value = 90'000 * selected.unit;
            scene.build(selected.build);
            const Rect end = bounds_of(scene.shapes(scale, test_support::day_color(SymbolRole::selected)));
            EXPECT_NEAR(end.y, scale.y, 0.1f) << "off the scale";
            EXPECT_NEAR(end.height, kBugReach * scene.layout.text_px, 0.1f) << "one half of it is seen";
        }
}

TEST(Symbology, P17SelectedValuesThatAreStaleOrLostAreNeverCyan) {
    for (const Screen& screen : kScreens)
        for (const Selected& selected : kSelected) {
            Scene scene(screen);
            const Rect& box = scene.layout.*selected.box;
            scene.input.guidance.*selected.value = selected.at * selected.unit;
            scene.show(selected.element, ElementShow::flagged);
            scene.build(selected.build);
            EXPECT_EQ(scene.text(box, test_support::day_color(SymbolRole::caution)), selected.text);
            EXPECT_FALSE(scene.shapes(scene.scale(box), test_support::day_color(SymbolRole::caution)).empty())
                << "the bug's outline";
            EXPECT_TRUE(scene.shapes(box, test_support::day_color(SymbolRole::selected)).empty());
            EXPECT_EQ(scene.text(box, test_support::day_color(SymbolRole::selected)), "");
            scene.show(selected.element, ElementShow::failed);
            scene.build(selected.build);
            EXPECT_EQ(scene.text(box, test_support::day_color(SymbolRole::caution)), selected.name);
            EXPECT_TRUE(scene.shapes(scene.scale(box), test_support::day_color(SymbolRole::warning)).empty())
                << "the tape itself stays";
            EXPECT_FALSE(scene.text(scene.scale(box), test_support::day_color(SymbolRole::scale)).empty());
            EXPECT_TRUE(scene.shapes(box, test_support::day_color(SymbolRole::selected)).empty());
        }
}

TEST(Symbology, P17ASelectedValueHasNoBugOnTheScaleOfAnotherReference) {
    for (const Element element : {Element::airspeed, Element::altitude}) {
        const Selected& selected = kSelected[element == Element::airspeed ? 0 : 1];
        Scene scene(kScreens[0]);
        const Rect& box = scene.layout.*selected.box;
        scene.show(selected.element, ElementShow::normal);
        scene.input.guidance.*selected.value = selected.at * selected.unit;
        scene.show(element, ElementShow::substituted);
        scene.build(selected.build);
        EXPECT_EQ(scene.text(box, test_support::day_color(SymbolRole::selected)), selected.text);
        EXPECT_TRUE(scene.shapes(scene.scale(box), test_support::day_color(SymbolRole::selected)).empty());
        scene.show(element, ElementShow::failed);
        scene.build(selected.build);
        EXPECT_EQ(scene.text(box, test_support::day_color(SymbolRole::selected)), selected.text)
            << "it stays above the failed tape";
    }
}

TEST(Symbology, P18VerticalSpeedHasANeedleAndANumber) {
    for (const Screen& screen : kScreens) {
        Scene scene(screen);
        const Rect& box = scene.layout.vertical_speed;
        const auto needle = [&](double fpm) {
            scene.input.vertical_speed_mps = fpm * base::kMpsPerFootPerMinute;
            scene.build(build_vertical_speed);
            const Rect scale = scene.scale(box);
            Rect longest;
            for (const BatchShape& line : scene.shapes(scale, test_support::day_color(SymbolRole::scale)))
                if (line.bounds.width > longest.width) longest = line.bounds;
            return longest.center().y - scale.center().y;
        };
        const double reach = static_cast<double>(scene.layout.vertical_speed.height);
        EXPECT_NEAR(needle(0), 0, 0.1f);
        EXPECT_NEAR(needle(1500), -3 * needle(-500), 0.2f);
        EXPECT_NEAR(needle(9000), needle(2000), 0.01f) << "it stays at the end";
        EXPECT_LT(static_cast<double>(needle(2000)), -0.3 * reach);
        needle(-1234);
        EXPECT_EQ(scene.text({box.x, box.bottom() - 1.8f * scene.layout.text_px, box.width, 1.8f * scene.layout.text_px},
                             test_support::day_color(SymbolRole::scale)),
                  "-1230");
        EXPECT_NE(needle(-1000), needle(-500)) << "control: moved";
    }
}

TEST(Symbology, P19BaroMinimumHasABugInTheColorOfItsState) {
    const std::pair<MinimumsState, design::Color> states[] = {
        {MinimumsState::none, test_support::day_color(SymbolRole::selected)},
        {MinimumsState::above, test_support::day_color(SymbolRole::selected)},
        {MinimumsState::near, test_support::day_color(SymbolRole::scale)},
        {MinimumsState::at_or_below, test_support::day_color(SymbolRole::caution)}};
    for (const Screen& screen : kScreens)
        for (const auto& [state, color] : states) {
            Scene scene(screen);
            const Rect& box = scene.layout.altitude;
            scene.show(Element::radio_minimum, ElementShow::absent);
            scene.show(Element::baro_minimum, ElementShow::normal);
            scene.input.decisions.baro_minimum = state;
            scene.input.guidance.baro_minimum_m = 4310 * base::kMetresPerFoot;
            scene.input.vertical_speed_mps = 0;
            scene.build(build_altitude);
            const Rect scale = scene.scale(box);
            const Rect below{box.x, scale.bottom(), box.width, box.bottom() - scale.bottom()};
            EXPECT_EQ(scene.text(below, color), "MIN4310");
            const float y = static_cast<float>(y_of(scale, 4310 - 4520, 1000));
            const float t = scene.layout.text_px;
            // Nothing else is as wide as the pointer there.
            const auto pointer = scene.shapes({scale.x + 0.5f * t, y - 1, 0.05f * t, 2}, color);
            ASSERT_EQ(pointer.size(), 1u);
            EXPECT_NEAR(pointer[0].bounds.center().y, y, 0.1f);
            scene.show(Element::baro_minimum, ElementShow::absent);
            scene.build(build_altitude);
            EXPECT_TRUE(scene.shapes({scale.x + 0.5f * t, y - 1, 0.05f * t, 2}, color).empty()) << "control: removed";
            EXPECT_EQ(scene.text(box, test_support::day_color(SymbolRole::selected)), "");
        }
}

TEST(Symbology, P19EachMinimumHasTheColorOfItsOwnState) {
    Scene scene(kScreens[0]);
    scene.show(Element::baro_minimum, ElementShow::normal);
    scene.show(Element::radio_minimum, ElementShow::normal);
    scene.input.decisions.radio_minimum = MinimumsState::at_or_below;
    scene.build(build_altitude);
    EXPECT_EQ(scene.text(scene.layout.altitude, test_support::day_color(SymbolRole::selected)), "MIN0")
        << "the state is that of the other minimum";
    scene.input.decisions.baro_minimum = MinimumsState::at_or_below;
    scene.build(build_altitude);
    EXPECT_EQ(scene.text(scene.layout.altitude, test_support::day_color(SymbolRole::caution)), "MIN0")
        << "control: now it is this one's";
}

TEST(Symbology, P19TheRadioMinimumStandsByTheHeightAboveGround) {
    for (const Screen& screen : kScreens)
        for (const auto& [state, color] : {std::pair{MinimumsState::above, test_support::day_color(SymbolRole::selected)},
                                           {MinimumsState::near, test_support::day_color(SymbolRole::scale)},
                                           {MinimumsState::at_or_below, test_support::day_color(SymbolRole::caution)}}) {
            Scene scene(screen);
            scene.show(Element::radio_minimum, ElementShow::normal);
            scene.input.decisions.radio_minimum = state;
            scene.input.guidance.radio_minimum_m = 200 * base::kMetresPerFoot;
            scene.build(build_ground_height);
            EXPECT_NE(scene.text(scene.layout.ground_height, color).find("DH200"), std::string::npos) << screen.width;
            scene.show(Element::radio_minimum, ElementShow::failed);
            scene.build(build_ground_height);
            EXPECT_EQ(scene.text(scene.layout.ground_height, test_support::day_color(SymbolRole::caution)), "DH")
                << "crossed out";
            scene.show(Element::radio_minimum, ElementShow::absent);
            scene.build(build_ground_height);
            EXPECT_EQ(scene.text(scene.layout.ground_height, color).find("DH"), std::string::npos) << "control";
        }
}

TEST(Symbology, P19AMinimumThatIsStaleOrLostSaysSo) {
    for (const Screen& screen : kScreens) {
        Scene scene(screen);
        const Rect& box = scene.layout.altitude;
        scene.input.guidance.baro_minimum_m = 4310 * base::kMetresPerFoot;
        scene.show(Element::baro_minimum, ElementShow::flagged);
        scene.build(build_altitude);
        EXPECT_EQ(scene.text(box, test_support::day_color(SymbolRole::caution)), "MIN4310");
        EXPECT_FALSE(scene.shapes(scene.scale(box), test_support::day_color(SymbolRole::caution)).empty());
        scene.show(Element::baro_minimum, ElementShow::failed);
        scene.build(build_altitude);
        EXPECT_EQ(scene.text(box, test_support::day_color(SymbolRole::caution)), "MIN");
        EXPECT_TRUE(scene.shapes(scene.scale(box), test_support::day_color(SymbolRole::warning)).empty())
            << "the tape itself stays";
    }
}

TEST(Symbology, TapesStayInTheirBoxesWithEveryMarkAndHostileValues) {
    const double infinite = std::numeric_limits<double>::infinity();
    const std::pair<Builder, Rect Layout::*> tapes[] = {{build_airspeed, &Layout::airspeed},
                                                        {build_altitude, &Layout::altitude},
                                                        {build_vertical_speed, &Layout::vertical_speed}};
    for (const Screen& screen : {Screen{640, 480}, Screen{1280, 720}, Screen{480, 640}, Screen{320, 240}})
        for (const ElementShow show : {ElementShow::normal, ElementShow::flagged, ElementShow::failed})
            for (const double value : {0.0, 37.3, -250.0, 1234.5, 1e300, -1e300, std::nan(""), infinite, -infinite}) {
                Scene scene(screen);
                for (const Element element : kMarkElements) scene.show(element, show);
                GuidanceInput& guidance = scene.input.guidance;
                for (double GuidanceInput::*member :
                     {&GuidanceInput::selected_airspeed_mps, &GuidanceInput::selected_altitude_m, &GuidanceInput::baro_minimum_m,
                      &GuidanceInput::selected_vertical_speed_mps, &GuidanceInput::airspeed_rate_mps2})
                    guidance.*member = value;
                scene.input.bands = speed_bands_around();
                scene.input.bands.has_pole = true;
                for (const auto& [build, box] : tapes) {
                    scene.build(build);
                    const Rect room = (scene.layout.*box).shrunk(-2.5f);
                    for (const QuadVertex& v : scene.store.batch.vertices())
                        ASSERT_TRUE(std::isfinite(v.x) && room.contains(Point{v.x, v.y})) << value;
                }
            }
}

}  // namespace
}  // namespace tedavis::draw::test_speed_and_altitude
