/// A terrain drawer alone, with its chunks selected and its picture read; nothing else is in the picture.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <set>
#include <string>
#include <vector>

#include "platform/surface_factory.hpp"
#include "render_core/draw/drawers/terrain_drawer.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/programs/gl_session.hpp"
#include "tests/support/terrain/drawn_terrain.hpp"
#include "tests/support/terrain/raster_scene.hpp"

namespace tedavis::test_support {

inline constexpr design::Color kDrawingBackground{255, 0, 255};

inline design::DesignSettings clear_design() {
    design::DesignSettings design = design::default_design_settings();
    design.sky.haze_distance_m = 0;
    return design;
}

struct ChunkPicture {
    std::vector<std::uint8_t> rgba;
    [[nodiscard]] design::Color at(double x, double y) const {
        const std::size_t column = static_cast<std::size_t>(x), row = RasterScene::kHeight - 1 - static_cast<std::size_t>(y);
        const std::uint8_t* p = rgba.data() + (row * RasterScene::kWidth + column) * 4;
        return {p[0], p[1], p[2]};
    }
    [[nodiscard]] std::size_t count(design::Color c) const {
        std::size_t n = 0;
        for (std::size_t p = 0; p < rgba.size(); p += 4)
            n += rgba[p] == c.red && rgba[p + 1] == c.green && rgba[p + 2] == c.blue ? 1 : 0;
        return n;
    }
};

class ChunkDrawing {
public:
    ChunkDrawing(const RasterScene& scene, const design::DesignSettings& design, const std::string& backend = "egl",
                 const std::string& device = "es3-mid", bool pages = true,
                 draw::TerrainOutput output = draw::TerrainOutput::color)
        : session_(surface_of(backend, device), compiling(device)),
          bytes_(scene.built.image),
          terrain_(bytes_, session_.device.max_chunk_slots, pages ? session_.device.attribute_pages : 0),
          design_(design),
          output_(output) {
        const draw::DrawnDesign only = drawn(design);
        EXPECT_TRUE(indices_.start(terrain_.store(), staging_));
        EXPECT_EQ(drawer_.start(session_.gl, terrain_.store(), indices_, {&only, 1}, session_.device, staging_).message.view(),
                  "");
        session_.gl.seal();
    }
    ~ChunkDrawing() {
        session_.gl.retire();
        drawer_.destroy(session_.gl);
    }

    /// Selects, draws and reads; `leave_out` of the selected chunks are not drawn.
    ChunkPicture draw(const draw::TerrainDrawInput& input, double tau_px, std::size_t leave_out = 0) {
        return draw(input, tau_px, leave_out, draw::plan_depth(input.view.near_m, input.view.far_m));
    }
    ChunkPicture draw(const draw::TerrainDrawInput& input, double tau_px, std::size_t leave_out, const draw::DepthPlan& depth) {
        terrain::LodSettings settings;
        settings.tau_px = tau_px;
        settings.max_chunks = session_.device.max_chunk_slots * 2 / 3;
        settings.conservative_up = design_.terrain.conservative_up;
        lod_ = terrain_.select(input.view, settings);
        EXPECT_TRUE(lod_.within_budget);
        const base::Span<const terrain::SelectedChunk> all = terrain_.selected();
        const base::Span<const terrain::SelectedChunk> drawn = all.subspan(leave_out, all.size() - leave_out);
        levels_.clear();
        beside_coarser_ = 0;
        for (const terrain::SelectedChunk& chunk : drawn) {
            levels_.insert(chunk.key.level);
            beside_coarser_ += chunk.coarser_edges != 0 ? 1 : 0;
        }
        return draw_chunks(drawn, input, depth);
    }
    /// False, and nothing changes, where it needs other programs.
    [[nodiscard]] bool set_design(const design::DesignSettings& design) {
        if (!drawer_.shows(drawn(design))) return false;
        drawer_.set_design(session_.gl, drawn(design));
        return true;
    }
    [[nodiscard]] bool set_ground_data(const scene::GridSlice* slice) { return drawer_.set_ground_data(session_.gl, slice); }
    [[nodiscard]] const std::set<std::uint32_t>& levels() const { return levels_; }
    [[nodiscard]] int beside_coarser() const { return beside_coarser_; }
    [[nodiscard]] std::uint64_t uploaded() const { return session_.gl.frame().uploaded_bytes; }
    [[nodiscard]] const draw::TerrainDrawResult& result() const { return result_; }
    [[nodiscard]] const terrain::LodResult& lod() const { return lod_; }

private:
    static std::unique_ptr<base::Surface> surface_of(const std::string& backend, const std::string& device) {
        const bool is_es2 = shipped_device(device).capability.lane == effects::Lane::es2;
        auto made = platform::make_surface(backend, {RasterScene::kWidth, RasterScene::kHeight,
                                                     is_es2 ? platform::ContextLane::es2 : platform::ContextLane::es3});
        EXPECT_TRUE(made.ok());
        return std::move(made.value());
    }
    /// A device without a compiler gets one: its programs come from text here, its calls are its own.
    static effects::DeviceSettings compiling(const std::string& name) {
        effects::DeviceSettings device = shipped_device(name);
        if (device.capability.gl.calls == effects::CallClass::sc2) device.capability = gl::with_compiler(device.capability);
        return device;
    }
    [[nodiscard]] draw::DrawnDesign drawn(const design::DesignSettings& design) const {
        return {&design, output_, draw::ground_focus_kind(design.foci).foci > 0};
    }
    ChunkPicture draw_chunks(base::Span<const terrain::SelectedChunk> drawn, const draw::TerrainDrawInput& input,
                             const draw::DepthPlan& depth) {
        session_.gl.begin_frame();
        EXPECT_TRUE(drawer_.prepare(session_.gl, drawn, input));
        gl::bind_surface(session_.gl, *session_.surface);
        session_.gl->ClearColor(1, 0, 1, 1);
        session_.gl->Clear(GL_COLOR_BUFFER_BIT);
        session_.gl->Enable(GL_DEPTH_TEST);
        session_.gl->Enable(GL_CULL_FACE);
        result_ = {};
        for (std::size_t n = 0; n < depth.count; ++n) {
            session_.gl->Clear(GL_DEPTH_BUFFER_BIT);
            drawer_.draw(session_.gl, drawn, input, depth.ranges[n], result_);
        }
        EXPECT_EQ(session_.gl.denied().total, 0u);
        EXPECT_EQ(session_.gl.take_error(), GLenum{GL_NO_ERROR});
        return {session_.pixels()};
    }

    GlSession session_;
    MemoryBytes bytes_;
    DrawnTerrain terrain_;
    design::DesignSettings design_;
    draw::TerrainOutput output_;
    std::vector<std::uint8_t> staging_memory_ = std::vector<std::uint8_t>(8 << 20);
    base::Arena staging_{staging_memory_.data(), staging_memory_.size()};
    terrain::ChunkIndices indices_;
    draw::TerrainDrawer drawer_;
    draw::TerrainDrawResult result_;
    terrain::LodResult lod_;
    std::set<std::uint32_t> levels_;
    int beside_coarser_ = 0;
};

inline draw::TerrainDrawInput lit_from_above(const terrain::View& view) {
    draw::TerrainDrawInput input;
    input.view = view;
    input.light_direction[0] = glm::normalize(view.eye);
    return input;
}

inline int color_difference(design::Color a, design::Color b) {
    return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

/// Rises by 4 m a post to the east.
inline host_sim::Raster eastward_ramp() {
    return make_raster(161, 161, [](std::uint32_t i, std::uint32_t) { return 4.0f * static_cast<float>(i); });
}

inline design::Color color_blend(design::Color a, design::Color b, double share) {
    const auto mix = [share](std::uint8_t x, std::uint8_t y) {
        return static_cast<std::uint8_t>(std::lround(x + (y - x) * share));
    };
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

/// Pixels of the background below the uppermost pixel of terrain of their column.
inline std::size_t holes_below_skyline(const ChunkPicture& picture) {
    std::size_t found = 0;
    for (std::uint32_t x = 0; x < RasterScene::kWidth; ++x) {
        bool below_skyline = false;
        for (std::uint32_t y = 0; y < RasterScene::kHeight; ++y) {
            const bool background = picture.at(x, y) == kDrawingBackground;
            below_skyline = below_skyline || !background;
            found += below_skyline && background ? 1 : 0;
        }
    }
    return found;
}

}  // namespace tedavis::test_support
