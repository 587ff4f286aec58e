/// Level ground with a field of the scene on it, drawn from above: what tests of data on the ground look at.
#pragma once

#include <cmath>

#include "tests/support/scene/loaded_scene.hpp"
#include "tests/support/terrain/chunk_drawing.hpp"
#include "tests/support/terrain/synthetic_raster.hpp"

namespace tedavis::test_support {

inline constexpr design::Color kBareGround{200, 190, 170};
inline constexpr double kLowestData = 0, kHighestData = 100;

/// Level ground, so that places of pixels are known without a mesh.
inline RasterScene level_ground() {
    host_sim::Raster raster = eastward_ramp();
    for (float& height_m : raster.height_m) height_m = 500;
    return RasterScene(raster);
}

/// A field over the middle of the ground, smooth, with uncertainty from west to east.
inline host_sim::LayerDraft field_over(const RasterScene& ground, int side) {
    host_sim::LayerDraft layer;
    layer.name = "field";
    layer.shape = scene::LayerShape::grid;
    const earth::Geodetic corner = ground.place(20, 20, 0), opposite = ground.place(140, 140, 0);
    const auto count = static_cast<std::uint32_t>(side);
    layer.grid = {corner.longitude_rad,
                  corner.latitude_rad,
                  (opposite.longitude_rad - corner.longitude_rad) / (side - 1),
                  (corner.latitude_rad - opposite.latitude_rad) / (side - 1),
                  count,
                  count,
                  1,
                  1};
    host_sim::AttributeDraft value;
    value.name = "value";
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            value.values.push_back(static_cast<float>(50 + 49 * std::sin(0.9 * i) * std::cos(0.7 * j)));
            value.uncertainties.push_back(scene::Uncertainty::from_level(i / (side - 1.0)));
        }
    layer.attributes = {value};
    return layer;
}

inline design::Palette greens() {
    design::Palette palette;
    palette.name = "greens";
    palette.kind = design::PaletteKind::sequential;
    palette.unit = design::PaletteUnit::one;
    EXPECT_TRUE(palette.stops.try_push_back({kLowestData, {240, 250, 230}}));
    EXPECT_TRUE(palette.stops.try_push_back({40, {120, 190, 140}}));
    EXPECT_TRUE(palette.stops.try_push_back({kHighestData, {10, 60, 50}}));
    return palette;
}

/// Plain ground without light, coloured by the field.
inline design::DesignSettings ground_design(design::IntrinsicUncertainty technique) {
    design::DesignSettings design = clear_design();
    design.terrain.style.texture = design::TerrainTexture::plain;
    design.terrain.style.plain = kBareGround;
    design.terrain.style.shade.technique = design::TerrainShade::none;
    design.data.ground.is_shown = true;
    design.data.ground.scale.palette = greens();
    design.data.ground.opacity = 0.8;
    design.data.ground.uncertainty = {technique, 0.75, 0};
    return design;
}

/// Where a pixel's middle looks at ground of a height above MSL, seen from above.
inline earth::Geodetic place_of(const terrain::View& view, int column, int row, double ellipsoid_m) {
    const glm::dvec3 way = view.forward + view.right * ((column + 0.5 - 0.5 * view.width) / view.focal_px) +
                           view.down * ((row + 0.5 - 0.5 * view.height) / view.focal_px);
    double near_m = 0, far_m = 1e5;
    for (int n = 0; n < 60; ++n) {
        const double middle_m = 0.5 * (near_m + far_m);
        (earth::from_ecef(view.eye + way * middle_m).height.m > ellipsoid_m ? near_m : far_m) = middle_m;
    }
    return earth::from_ecef(view.eye + way * near_m);
}

/// A slice of the field, drawn from above.
struct GroundDrawing {
    GroundDrawing(const RasterScene& ground, const LoadedScene& loaded, const design::DesignSettings& design,
                  const std::string& device)
        : drawing(ground, design, "egl", device), field(loaded.layer(), loaded.attribute()) {
        base::Arena arena(memory.data(), memory.size());
        EXPECT_TRUE(slice.start(128 * 128, arena));
        input = lit_from_above(ground.view(80, 80, 9000, 0, -90));
        ellipsoid_m = ground.place(80, 80, 500).height.m;
        show(loaded);
    }
    /// Another field in another look; false, and nothing is drawn, where that needs other programs.
    [[nodiscard]] bool redraw(const LoadedScene& loaded, const design::DesignSettings& design) {
        if (!drawing.set_design(design)) return false;
        field = scene::GridField(loaded.layer(), loaded.attribute());
        slice.forget();
        show(loaded);
        return true;
    }
    void show(const LoadedScene& loaded) {
        EXPECT_TRUE(slice.set_field(loaded.layer(), loaded.attribute()));
        EXPECT_TRUE(slice.show({0, 0}));
        EXPECT_TRUE(drawing.set_ground_data(&slice));
        picture = drawing.draw(input, 0.1);
    }
    [[nodiscard]] scene::FieldValue at(int column, int row) const {
        const earth::Geodetic place = place_of(input.view, column, row, ellipsoid_m);
        return field.at(place.latitude_rad, place.longitude_rad, 0, 0);
    }
    [[nodiscard]] design::Color pixel(int column, int row) const { return picture.at(column + 0.5, row + 0.5); }

    std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(1 << 18);
    ChunkDrawing drawing;
    scene::GridField field;
    scene::GridSlice slice;
    draw::TerrainDrawInput input;
    double ellipsoid_m = 0;
    ChunkPicture picture;
};

}  // namespace tedavis::test_support
