#include "render_core/draw/drawers/terrain_program.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_terrain_program {
namespace {

using design::TerrainShade;
using design::TerrainStyle;
using design::TerrainTexture;
using test_support::GlSession;

TerrainVariant full_variant() {
    TerrainVariant variant;
    variant.bands = 2;
    variant.baked = variant.lifted = variant.flat = variant.coast = true;
    variant.output = TerrainOutput::color_and_distance;
    for (bool& map : variant.maps) map = true;
    return variant;
}

/// Every part of it both there and not there, among four in a row.
GroundFocusKind any_focus(std::size_t n) {
    GroundFocusKind focus;
    focus.foci = static_cast<std::uint8_t>(1 + n % scene::kMaxFoci);
    focus.has_paths = focus.has_halos = n % 2 == 0;
    focus.has_squares = focus.has_lines = n % 3 != 0;
    focus.has_chebyshev = focus.sketches = n % 4 < 2;
    focus.has_grids = n % 3 < 2;
    focus.blurs = n % 4 == 1;
    return focus;
}

/// Every technique once, most of them together with others.
std::vector<TerrainStyle> styles() {
    std::vector<TerrainStyle> all;
    for (std::size_t texture = 0; texture < design::kTerrainTextures; ++texture) {
        TerrainStyle style;
        style.texture = static_cast<TerrainTexture>(texture);
        style.shade.technique = static_cast<TerrainShade>(texture % design::kTerrainShades);
        style.shade.light_count = 1 + texture % design::kMaxLights;
        if (texture % 3 != 1) style.shade.ambient_color = style.shade.lights[0].color = {255, 200, 180};
        style.shade.cast_shadows = texture % 2 == 0;
        style.shade.ambient_occlusion = texture % 3 == 0 ? 0.5 : 0;
        style.shade.openness = texture % 3 == 1 ? 0.5 : 0;
        style.sketch.contours = texture % 2 == 1 ? 1 : 0;
        style.sketch.illuminated = texture % 4 == 1;
        style.sketch.ridges = texture % 3 == 2 ? 1 : 0;
        style.sketch.suggestive_contours = texture % 4 == 2 ? 1 : 0;
        style.sketch.hatching = texture % 4 == 3 ? 1 : 0;
        style.sketch.stippling = texture % 5 == 0 ? 1 : 0;
        style.grid.spacing_m = texture % 2 == 0 ? 1852 : 0;
        all.push_back(style);
    }
    return all;
}

TEST(TerrainProgram, EveryTechniqueCompilesInBothLanes) {
    for (const char* device : {"es2-small", "es3-mid"}) {
        GlSession session("egl", device);
        std::vector<int> seen(kTerrainUniforms, 0);
        for (const TerrainStyle& style : styles())
            for (const int pages : {0, 1, 2}) {
                TerrainVariant variant = full_variant();
                variant.ground_data = pages > 0;
                variant.uncertainty = static_cast<design::IntrinsicUncertainty>(static_cast<std::size_t>(style.texture) %
                                                                                design::kIntrinsicUncertainties);
                variant.overlay = static_cast<design::UncertaintyOverlay>((static_cast<std::size_t>(style.texture) + 1) %
                                                                          design::kUncertaintyOverlays);
                variant.baked = pages > 0;
                variant.coast = pages > 1;
                variant.air = pages == 1 && session.device.capability.gl.calls == effects::CallClass::es3;
                variant.shadows = variant.shafts = variant.air;
                variant.fine_distance = pages == 2;
                if (pages > 0)
                    variant.focus = any_focus(static_cast<std::size_t>(style.texture) + static_cast<std::size_t>(pages));
                variant.in_focus = false;
                variant.magnified = pages != 1;
                auto program = build_terrain_program(session.gl, style, variant);
                ASSERT_TRUE(program.ok()) << program.error().message.view();
                for (std::size_t n = 0; n < kTerrainUniforms; ++n) seen[n] += program.value().uniform(n) >= 0 ? 1 : 0;
                program.value().destroy(session.gl);
            }
        // A misspelt name would never be found.
        for (std::size_t n = 0; n < kTerrainUniforms; ++n)
            if (n != kHeightRange && (n < kGeometry || n > kRayAxes) &&
                (n < kTerrainAir || n >= kTerrainFocus || session.device.capability.gl.calls == effects::CallClass::es3)) {
                EXPECT_GT(seen[n], 0) << "uniform " << n << " on " << device;
            }
        session.gl.seal();
        session.gl.retire();
    }
}

/// Varyings are variables there, and the function that fills them is the vertex shader's.
TEST(TerrainProgram, DeferredShadingOfEveryTechniqueCompiles) {
    GlSession session("egl", "es3-mid");
    std::vector<int> seen(kTerrainUniforms, 0);
    for (const TerrainStyle& style : styles())
        for (const int pages : {0, 1, 2}) {
            TerrainVariant variant = full_variant();
            const auto texture = static_cast<std::size_t>(style.texture);
            variant.deferred = true;
            variant.flat = variant.magnified = false;
            variant.ground_data = variant.baked = pages > 0;
            variant.uncertainty = static_cast<design::IntrinsicUncertainty>(texture % design::kIntrinsicUncertainties);
            variant.overlay = static_cast<design::UncertaintyOverlay>((texture + 1) % design::kUncertaintyOverlays);
            variant.coast = pages > 1;
            variant.shadows = pages != 1;
            variant.fine_distance = pages == 2;
            if (pages > 0) variant.focus = any_focus(texture + static_cast<std::size_t>(pages));
            auto program = build_terrain_program(session.gl, style, variant);
            ASSERT_TRUE(program.ok()) << program.error().message.view();
            for (std::size_t n = 0; n < kTerrainUniforms; ++n) seen[n] += program.value().uniform(n) >= 0 ? 1 : 0;
            program.value().destroy(session.gl);
        }
    for (const std::size_t n : {kGeometry, kChunkNumber, kRayAxes, kPlaceEnd, kToLocal, kDataWindow, kStrokeWindow, kGridWindow})
        EXPECT_GT(seen[n], 0) << "uniform " << n;
    EXPECT_EQ(seen[kViewProjection], 0);
    session.gl.seal();
    session.gl.retire();
}

TEST(TerrainProgram, WhatTheStyleDoesNotAskForIsNotCompiled) {
    TerrainStyle bare;
    bare.texture = TerrainTexture::plain;
    bare.shade.technique = TerrainShade::none;
    TerrainVariant variant;
    EXPECT_EQ(terrain_defines(bare, variant).view(), "");
    variant.baked = true;
    for (bool& map : variant.maps) map = true;
    EXPECT_EQ(terrain_defines(bare, variant).view(), "#define BAKED 1\n");  // no technique reads a map
}

/// Chunks in focus are drawn as if there were none, but for what they say of how sharp they are.
TEST(TerrainProgram, WhatIsInFocusHasNothingOfIt) {
    TerrainVariant variant;
    const std::string without(terrain_defines({}, variant).view());
    variant.focus = any_focus(0);
    EXPECT_EQ(terrain_defines({}, variant).view(), without);
    variant.focus = any_focus(1);
    EXPECT_EQ(terrain_defines({}, variant).view(), without + "#define FOCUS_BLUR 1\n");
    variant.in_focus = false;
    EXPECT_NE(terrain_defines({}, variant).view().find("#define FOCI 2"), std::string_view::npos);
}

TEST(TerrainProgram, CodesCompileInBothLanes) {
    for (const char* device : {"es2-small", "es3-mid"}) {
        GlSession session("egl", device);
        for (const TerrainShade shade : {TerrainShade::none, TerrainShade::lambert, TerrainShade::lights})
            for (const bool classes : {false, true}) {
                TerrainStyle style;
                style.shade.technique = shade;
                style.shade.light_count = 3;
                TerrainVariant variant;
                variant.output = TerrainOutput::code;
                variant.classes = variant.lifted = classes;
                variant.flat = !classes;
                auto program = build_terrain_program(session.gl, style, variant);
                ASSERT_TRUE(program.ok()) << program.error().message.view();
                EXPECT_GE(program.value().uniform(kHeightRange), 0);
                EXPECT_EQ(program.value().uniform(kLights) >= 0, shade != TerrainShade::none);
                program.value().destroy(session.gl);
            }
        session.gl.seal();
        session.gl.retire();
    }
}

TEST(TerrainProgram, AMapThatIsNotThereIsNotRead) {
    TerrainStyle style;
    style.shade.baked_normals = true;
    TerrainVariant variant;
    variant.baked = true;
    EXPECT_EQ(std::string(terrain_defines(style, variant).view()).find("MAP_"), std::string::npos);
    variant.maps[static_cast<std::size_t>(design::BakedMap::form)] = true;
    EXPECT_NE(std::string(terrain_defines(style, variant).view()).find("#define MAP_FORM 1\n"), std::string::npos);
    variant.baked = false;
    EXPECT_EQ(std::string(terrain_defines(style, variant).view()).find("MAP_"), std::string::npos);
}

TEST(TerrainProgram, TheImageNeedsNoAttributePages) {
    TerrainStyle style;
    style.texture = TerrainTexture::image;
    TerrainVariant variant;
    variant.maps[static_cast<std::size_t>(design::BakedMap::drape)] = true;
    EXPECT_NE(std::string(terrain_defines(style, variant).view()).find("#define MAP_DRAPE 1\n"), std::string::npos);
    style.texture = TerrainTexture::slope;
    EXPECT_EQ(std::string(terrain_defines(style, variant).view()).find("MAP_DRAPE"), std::string::npos);
}

TEST(TerrainProgram, TheLongestListOfDefinesIsNotCut) {
    for (const TerrainStyle& style : styles()) EXPECT_FALSE(terrain_defines(style, full_variant()).cut());
}

}  // namespace
}  // namespace tedavis::draw::test_terrain_program
