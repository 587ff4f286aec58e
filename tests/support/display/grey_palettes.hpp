/// The palettes "grey" and "kinds" for designs in tests.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "render_core/design/data_scale.hpp"

namespace tedavis::test_support {

/// From black at 0 to white at 100.
[[nodiscard]] inline design::Palette grey_palette() {
    design::Palette palette;
    palette.name = "grey";
    palette.kind = design::PaletteKind::sequential;
    palette.unit = design::PaletteUnit::one;
    EXPECT_TRUE(palette.stops.try_push_back({0, {0, 0, 0}}) && palette.stops.try_push_back({100, {255, 255, 255}}));
    return palette;
}

/// Of kinds: "dark" and "light".
[[nodiscard]] inline design::Palette kinds_palette() {
    design::Palette palette;
    palette.name = "kinds";
    palette.kind = design::PaletteKind::nominal;
    palette.unit = design::PaletteUnit::one;
    EXPECT_TRUE(palette.stops.try_push_back({0, {40, 40, 40}}) && palette.stops.try_push_back({1, {210, 210, 210}}));
    EXPECT_TRUE(palette.class_names.try_push_back("dark") && palette.class_names.try_push_back("light"));
    return palette;
}

/// The palette with limits of classes.
[[nodiscard]] inline design::DataScale scale_of(const std::vector<double>& breaks) {
    design::DataScale scale;
    scale.palette = grey_palette();
    for (const double limit : breaks) EXPECT_TRUE(scale.breaks.try_push_back(limit));
    return scale;
}

class GreyPalettes final : public design::PaletteSource {
public:
    base::Result<design::Palette, base::Error> find(const base::StatedFile& palette) override {
        if (palette.name == "kinds") return kinds_palette();
        if (palette.name != "grey") return base::fail(base::Error{"no palette is called so"});
        return grey_palette();
    }
};

}  // namespace tedavis::test_support
