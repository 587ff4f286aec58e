/// The palette "grey" for designs in tests.
#pragma once

#include <gtest/gtest.h>

#include "render_core/design/palette.hpp"

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

class GreyPalettes final : public design::PaletteSource {
public:
    base::Result<design::Palette, base::ConfigError> find(std::string_view name) override {
        if (name != "grey") return base::fail(base::ConfigError{"no palette is called so"});
        return grey_palette();
    }
};

}  // namespace tedavis::test_support
