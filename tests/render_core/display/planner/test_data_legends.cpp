#include "render_core/display/planner/data_legends.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/display/grey_palettes.hpp"
#include "tests/support/files/flaky_bytes.hpp"
#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::display::test_data_legends {
namespace {

using test_support::LoadedScene;

constexpr std::int64_t kMinute_ns = 60'000'000'000, kHour_ns = 60 * kMinute_ns;
constexpr std::int64_t kDate_ns = 1'700'000'000'000'000'000 / kHour_ns * kHour_ns;  // 2023-11-14, 22:00

draw::DataLegend entry_of(const host_sim::LayerDraft& layer, std::int64_t now_ns, bool has_date = true) {
    const LoadedScene loaded(layer);
    return legend_of(loaded.layer(), loaded.attribute(), {base::Time{now_ns}, has_date, has_date}, {});
}

TEST(DataLegends, SaysWhatWhenAndWhereFrom) {
    host_sim::LayerDraft layer = test_support::small_grid();
    layer.title = "Air";
    layer.source = "weather/era5_wind.nc";
    layer.times_ns = {kDate_ns, kDate_ns + kHour_ns};
    const draw::DataLegend entry = entry_of(layer, kDate_ns + kHour_ns / 2);
    EXPECT_EQ(entry.title.view(), "AIR TEMPERATURE");
    EXPECT_EQ(entry.unit.view(), "°C");
    EXPECT_EQ(entry.source.view(), "ERA5 WIND.NC");
    layer.source = "weather/opera_20241126_0100_dbz.tif";
    EXPECT_EQ(entry_of(layer, kDate_ns).source.view(), "OPERA") << "no more than can be read";
    host_sim::LayerDraft named = layer;
    named.attributes[0].title = "K";
    EXPECT_EQ(entry_of(named, kDate_ns).title.view(), "AIR") << "a title that is the unit says nothing";
    EXPECT_EQ(draw::time_and_age(entry).view(), "22:00Z +30 MIN") << "a forecast, said then";
    EXPECT_EQ(draw::time_and_age(entry_of(layer, kDate_ns + kHour_ns + 12 * kMinute_ns)).view(), "23:00Z 12 MIN");
    EXPECT_EQ(draw::time_and_age(entry_of(layer, kDate_ns + 2 * kHour_ns)).view(), "23:00Z STALE 60 MIN");
    EXPECT_EQ(draw::time_and_age(entry_of(layer, kDate_ns - 40 * kMinute_ns)).view(), "22:00Z IN 40 MIN") << "a forecast";
    EXPECT_EQ(draw::time_and_age(entry_of(layer, 5, false)).view(), "22:00Z AGE ?") << "a source without a date";
    const test_support::LoadedScene loaded(layer);
    const flight::FlightTime unconfirmed{{kDate_ns + kHour_ns + 12 * kMinute_ns}, true, false};
    EXPECT_EQ(draw::time_and_age(legend_of(loaded.layer(), loaded.attribute(), unconfirmed, {})).view(), "23:00Z AGE ?")
        << "UTC that was lost goes on, but tells no age";
}

TEST(DataLegends, WithinItsTimesALayerSaysWhenItWasMadeOrMeasured) {
    host_sim::LayerDraft layer = test_support::small_grid();
    layer.times_ns = {kDate_ns, kDate_ns + kHour_ns};
    const auto text = [&](std::int64_t own_ns, std::int64_t now_ns) {
        layer.data_time_ns = own_ns;
        const draw::DataLegend entry = entry_of(layer, now_ns);
        EXPECT_FALSE(entry.is_stale);
        return std::string(draw::time_and_age(entry).view());
    };
    const std::int64_t now = kDate_ns + 25 * kMinute_ns;
    EXPECT_EQ(text(kDate_ns - kHour_ns, now), "21:00Z +85 MIN") << "however long ago, it is valid now";
    EXPECT_EQ(text(kDate_ns, now), "22:00Z +25 MIN");
    EXPECT_EQ(text(scene::kNoTime, now), "22:00Z +25 MIN");
    EXPECT_EQ(text(kDate_ns + kHour_ns, now), "22:00Z 25 MIN") << "the last that was measured";
    EXPECT_EQ(text(kDate_ns + 10 * kMinute_ns, now), "22:10Z +15 MIN") << "measured until then, and a forecast beyond";
}

TEST(DataLegends, NumbersAreInTheUnitThatPilotsRead) {
    host_sim::LayerDraft layer = test_support::small_grid();
    layer.attributes[0].unit = "m/s";
    const auto shown = [&](const char* name, base::DisplayUnits units) {
        layer.attributes[0].name = name;
        const LoadedScene loaded(layer);
        return shown_unit(*loaded.attribute().entry, units);
    };
    const ShownUnit knots = shown("speed", base::DisplayUnits::feet_and_knots);
    EXPECT_EQ(knots.name.view(), "KT");
    EXPECT_NEAR(knots.factor * 1852, 3600, 1e-9) << "a nautical mile an hour";
    const ShownUnit climb = shown("vertical_speed", base::DisplayUnits::feet_and_knots);
    EXPECT_EQ(climb.name.view(), "FT/MIN");
    EXPECT_NEAR(climb.factor * 5.08, 1000, 1e-9);
    EXPECT_EQ(shown("speed", base::DisplayUnits::metric).name.view(), "KM/H") << "as on the tape";
    EXPECT_NEAR(shown("speed", base::DisplayUnits::metric).factor, 3.6, 1e-12);
    EXPECT_EQ(shown("vertical_speed", base::DisplayUnits::metric).name.view(), "M/S");
    EXPECT_EQ(shown("vertical_speed", base::DisplayUnits::metric).factor, 1);
}

TEST(DataLegends, TitlesSayNothingTwice) {
    host_sim::LayerDraft layer = test_support::small_grid();
    const auto titled = [&](const char* of_layer, const char* of_attribute) {
        layer.title = of_layer;
        layer.attributes[0].title = of_attribute;
        return std::string(entry_of(layer, 0, false).title.view());
    };
    EXPECT_EQ(titled("Air", "Temperature"), "AIR TEMPERATURE");
    EXPECT_EQ(titled("WIND", "Wind speed"), "WIND SPEED");
    EXPECT_EQ(titled("Radar", "radar"), "RADAR");
    EXPECT_EQ(titled("Cloud", "K"), "CLOUD") << "the unit stands beside it";
    EXPECT_EQ(titled("", "Temperature"), "TEMPERATURE");
}

TEST(DataLegends, ALayerOfOneTimeAgesFromIt) {
    host_sim::LayerDraft layer = test_support::small_grid();
    layer.grid.times = 1;
    layer.times_ns.clear();
    host_sim::AttributeDraft& value = layer.attributes[0];
    value.values.resize(24);
    value.uncertainties.resize(24);
    value.states.resize(24);
    layer.data_time_ns = kDate_ns;
    EXPECT_EQ(draw::time_and_age(entry_of(layer, kDate_ns + 20 * kMinute_ns)).view(), "22:00Z 20 MIN");
    layer.data_time_ns = scene::kNoTime;
    EXPECT_FALSE(entry_of(layer, kDate_ns).has_time);
}

TEST(DataLegends, ClassesHaveTheirNamesAndAnglesAreDegrees) {
    const draw::DataLegend kinds = entry_of(test_support::small_points(), 0, false);
    ASSERT_EQ(kinds.class_names.size(), 2u);
    EXPECT_EQ(kinds.class_names[1].view(), "TURBINE");
    host_sim::LayerDraft layer = test_support::small_grid();
    layer.attributes[0].unit = "rad";
    const draw::DataLegend angle = entry_of(layer, 0, false);
    EXPECT_EQ(angle.unit.view(), "DEG");
    EXPECT_NEAR(angle.factor, 57.29578, 1e-4);
    EXPECT_TRUE(angle.class_names.empty());
}

TEST(DataLegends, OfKindsOnlyThoseInUseThatThePaletteNames) {
    host_sim::LayerDraft layer = test_support::small_points();
    layer.attributes[0].classes = {"rock", "light", "snow", "dark"};
    const LoadedScene loaded(layer);
    const auto kept = [&](std::uint32_t in_use, const design::Palette& palette) {
        draw::DataLegend entry = legend_of(loaded.layer(), loaded.attribute(), {}, {});
        entry.scale.palette = palette;
        keep_named_classes(loaded.attribute(), in_use, entry);
        std::string text;
        for (std::size_t n = 0; n < entry.class_names.size(); ++n)
            text += std::string(entry.class_names[n].view()) + " " +
                    std::to_string(scale_color(entry.scale, static_cast<double>(n)).red) + ";";
        return text;
    };
    const design::Palette kinds = test_support::kinds_palette();
    EXPECT_EQ(kept(0b1111, kinds), "LIGHT 210;DARK 40;") << "in the scene's order, in the colours of their names";
    EXPECT_EQ(kept(0b1001, kinds), "DARK 40;");
    EXPECT_EQ(kept(0b0101, kinds), "DARK 40;LIGHT 210;") << "none of them: all that the palette knows";
    EXPECT_EQ(kept(0, test_support::grey_palette()), "ROCK 0;LIGHT 3;SNOW 5;DARK 8;") << "numbers have no names to keep";
}

TEST(DataLegends, TheFullScaleIsInTheUnitOfItsKind) {
    const auto text = [](scene::UncertaintyKind kind, float full, const char* unit) {
        scene::AttributeEntry entry{};
        entry.uncertainty_kind = kind;
        entry.uncertainty_full = full;
        std::snprintf(entry.unit, sizeof entry.unit, "%s", unit);
        return std::string(full_uncertainty_text(entry, base::DisplayUnits::feet_and_knots).view());
    };
    EXPECT_EQ(text(scene::UncertaintyKind::standard_deviation, 4, "m/s"),
              "\xC2\xB1"
              "7.78 KT");
    EXPECT_EQ(text(scene::UncertaintyKind::interval, 2.5f, "K"),
              "\xC2\xB1"
              "2.5 °C");
    EXPECT_EQ(text(scene::UncertaintyKind::percent, 30, "m/s"),
              "\xC2\xB1"
              "30 %");
    EXPECT_EQ(text(scene::UncertaintyKind::ordinal, 1, "dBZ"), "UNCERTAIN");
    EXPECT_EQ(text(scene::UncertaintyKind::standard_deviation, 0, "K"), "UNCERTAIN");
    scene::AttributeEntry classes{};
    classes.uncertainty_kind = scene::UncertaintyKind::ordinal;
    EXPECT_EQ(uncertainty_text(classes, 0.5, base::DisplayUnits::feet_and_knots).view(), "50 %");
}

TEST(DataLegends, APaletteOfAnotherUnitIsNoticed) {
    const LoadedScene loaded(test_support::small_grid());
    design::Palette palette;
    for (const auto& [unit, is_other] : {std::pair{design::PaletteUnit::one, false},
                                         {design::PaletteUnit::kelvin, false},
                                         {design::PaletteUnit::metres_per_second, true},
                                         {design::PaletteUnit::metres, true},
                                         {design::PaletteUnit::degrees, true}}) {
        palette.unit = unit;
        EXPECT_EQ(is_in_another_unit(palette, *loaded.attribute().entry), is_other) << static_cast<int>(unit);
    }
}

class GroundLegendOf : public ::testing::Test {
protected:
    GroundLegendOf() {
        source_.content = host_sim::sdb_bytes(test_support::small_scene());
        EXPECT_EQ(data_.start(&source_, {scene_memory_, slice_memory_}, 64).message.view(), "");
        design::GroundData& ground = design_.data.ground;
        ground.is_shown = true;
        ground.layer = "air";
        ground.attribute = "temperature";
        ground.height_m = 1000;
        EXPECT_TRUE(ground.scale.palette.stops.try_push_back({260, {20, 30, 200}}));
        EXPECT_TRUE(ground.scale.palette.stops.try_push_back({300, {240, 250, 200}}));
    }
    draw::DataLegends legends() {
        draw::DataLegends found;
        const flight::FlightTime no_date{{12}, false, false};
        add_ground_legend(data_, data_.plan(design_.data, no_date), design_, no_date, found);
        return found;
    }

    std::vector<std::uint8_t> memory_ = std::vector<std::uint8_t>(1 << 17);
    base::Arena scene_memory_{memory_.data(), 1 << 16}, slice_memory_{memory_.data() + (1 << 16), 1 << 12};
    test_support::FlakyBytes source_{{}};
    SpatialData data_;
    design::DesignSettings design_ = design::default_design_settings();
};

TEST_F(GroundLegendOf, IsThereWhileTheDataAre) {
    ASSERT_EQ(legends().size(), 1u);
    EXPECT_EQ(legends()[0].title.view(), "AIR TEMPERATURE");
    EXPECT_EQ(legends()[0].scale.palette.stops[1].value, 300);
    ASSERT_EQ(legends()[0].signs.size(), 2u);
    EXPECT_EQ(legends()[0].signs[0].look, draw::SampleLook::dots);
    design_.data.ground.is_shown = false;
    EXPECT_TRUE(legends().empty());
    design_.data.ground.is_shown = true;
    design_.data.ground.layer = "nothing";
    EXPECT_TRUE(legends().empty());
}

TEST_F(GroundLegendOf, ShowsHowTheTechniqueLooksAndAlwaysWhatIsUnknown) {
    const auto looks = [this](design::IntrinsicUncertainty technique) {
        design_.data.ground.uncertainty.technique = technique;
        return legends()[0].uncertainty;
    };
    const auto none = looks(design::IntrinsicUncertainty::none);
    ASSERT_EQ(none.size(), 1u);
    EXPECT_EQ(none[0].look, draw::SampleLook::cut_stripes);
    for (std::size_t n = 1; n < design::kIntrinsicUncertainties; ++n) {
        const auto samples = looks(static_cast<design::IntrinsicUncertainty>(n));
        ASSERT_EQ(samples.size(), 3u) << n;
        EXPECT_EQ(samples[0].look, draw::SampleLook::plain);
        EXPECT_EQ(samples[1].text.view(),
                  "\xC2\xB1"
                  "4 °C");
        EXPECT_TRUE(samples[1].look != draw::SampleLook::plain || samples[1].color != samples[0].color) << n;
        EXPECT_EQ(samples[2].text.view(), "UNKNOWN");
    }
}

TEST_F(GroundLegendOf, SaysWhatThePlainGroundAmongTheDataMeans) {
    EXPECT_EQ(legends()[0].signs[0].text.view(), "MISSING") << "all values are shown";
    design_.data.ground.shown_from = 268.15;
    const draw::LegendSample none = legends()[0].signs[0];
    EXPECT_EQ(none.text.view(), "BELOW -5");
    EXPECT_EQ(none.color, design_.terrain.style.plain);
}

TEST_F(GroundLegendOf, ShowsTheOverlayBesideTheTechnique) {
    design::GroundData& ground = design_.data.ground;
    ground.overlay.threshold = 0.25;
    const auto entry = [&](design::IntrinsicUncertainty look, design::UncertaintyOverlay overlay) {
        ground.uncertainty.technique = look;
        ground.overlay.technique = overlay;
        return legends()[0];
    };
    for (std::size_t n = 1; n < design::kUncertaintyOverlays; ++n) {
        const auto overlay = static_cast<design::UncertaintyOverlay>(n);
        const draw::DataLegend alone = entry(design::IntrinsicUncertainty::none, overlay);
        ASSERT_EQ(alone.uncertainty.size(), 3u) << n;
        EXPECT_EQ(alone.uncertainty[1].text.view(), n < 3 ? "\xC2\xB1"
                                                            "4 °C"
                                                          : ">\xC2\xB1"
                                                            "1 °C");
        const draw::LegendSample &sure = alone.uncertainty[0], &unsure = alone.uncertainty[1];
        EXPECT_TRUE(sure.look != unsure.look || sure.color != unsure.color || sure.share != unsure.share) << n;
        EXPECT_EQ(alone.signs.size(), 2u);
        const draw::DataLegend both = entry(design::IntrinsicUncertainty::noise, overlay);
        EXPECT_EQ(both.uncertainty[1].look, draw::SampleLook::grains);
        ASSERT_EQ(both.signs.size(), 3u);
        EXPECT_EQ(both.signs[0].look, unsure.look);
    }
}

TEST(DataLegends, UncertaintyAsAValueIsInItsUnit) {
    host_sim::LayerDraft layer = test_support::small_grid();
    layer.title = "Air";
    const LoadedScene loaded(layer);
    draw::DataLegend entry = uncertainty_legend_of(loaded.layer(), loaded.attribute(), {}, {});
    EXPECT_EQ(entry.title.view(), "AIR TEMPERATURE \xC2\xB1");
    EXPECT_EQ(entry.factor, 4) << "a level of 1 is 4 K";
    EXPECT_EQ(entry.unit.view(), "°C");
    layer.attributes[0].uncertainty_full = 0;
    const LoadedScene unsaid(layer);
    entry = uncertainty_legend_of(unsaid.layer(), unsaid.attribute(), {}, {});
    EXPECT_EQ(entry.factor, 100);
    EXPECT_EQ(entry.unit.view(), "%") << "of a level that has no unit, never the data's";
    layer.attributes[0].uncertainty_full = 1;
    layer.attributes[0].uncertainty_kind = scene::UncertaintyKind::ordinal;
    const LoadedScene graded(layer);
    entry = uncertainty_legend_of(graded.layer(), graded.attribute(), {}, {});
    EXPECT_EQ(entry.factor, 100) << "no kelvin: classes of trust";
    EXPECT_EQ(entry.unit.view(), "%");
    layer.attributes[0].uncertainty_full = 50;
    layer.attributes[0].uncertainty_kind = scene::UncertaintyKind::percent;
    const LoadedScene relative(layer);
    entry = uncertainty_legend_of(relative.layer(), relative.attribute(), {}, {});
    EXPECT_EQ(entry.factor, 50);
    EXPECT_EQ(entry.unit.view(), "%") << "of the value";
}

TEST(DataLegends, WhatSaysTheSameIsThereOnce) {
    draw::DataLegends legends;
    draw::DataLegend entry = entry_of(test_support::small_grid(), 0, false);
    add_legend(entry, legends);
    add_legend(entry, legends);
    EXPECT_EQ(legends.size(), 1u);
    entry.part = member_text(2, 9);
    EXPECT_EQ(entry.part.view(), "MEMBER 3/9");
    add_legend(entry, legends);
    EXPECT_EQ(legends.size(), 2u) << "a member is not the mean";
    EXPECT_EQ(member_text(15, 16).view(), "MEMBER 16/16");
}

}  // namespace
}  // namespace tedavis::display::test_data_legends
