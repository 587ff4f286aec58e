/// The terrain of a display alone on a surface: no sky, no outlines, no symbology. The surface is current only while it is used.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "render_core/display/terrain_painter.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::test_support {

class TerrainOnSurface {
public:
    /// `terrain` must outlive it.
    TerrainOnSurface(const std::string& device, std::uint32_t width, std::uint32_t height, base::ByteSource& terrain,
                     const design::DesignSettings& design)
        : session_("egl", device, width, height), reader_(terrain, base::kMaxReadTickets), design_(design) {
        const display::TerrainMemory memory{
            arena("terrain_index"), arena("terrain_chunk_slots"), arena("terrain_heights"), arena("terrain_attributes"),
            arena("terrain_drape"), arena("lod_scratch"),         arena("staging")};
        const display::TerrainInput input{&terrain, &reader_, terrain::ArrivalMode::exact};
        const draw::DrawnDesign only{&design_, draw::output_of(design_, session_.device.capability.depth24_targets)};
        if (const base::Error error = scene_.start(input, {&only, 1}, session_.device, memory))
            throw std::runtime_error(error.message.c_str());
        if (const base::Error error = painter_.start(session_.gl, scene_, {&only, 1}, session_.device, memory.staging))
            throw std::runtime_error(error.message.c_str());
        scene_.follow_painter(painter_.reads_pages(), painter_.tracer());
        scene_.set_design(only);
        session_.surface->release_current();
    }
    ~TerrainOnSurface() {
        make_current();
        painter_.destroy(session_.gl);
    }
    TerrainOnSurface(const TerrainOnSurface&) = delete;
    TerrainOnSurface& operator=(const TerrainOnSurface&) = delete;

    /// Plans until everything has arrived, and uploads it.
    void look(const display::Camera& camera, const draw::TerrainDrawInput& input) {
        make_current();
        input_ = input;
        constexpr int kMaxTimes = 64;
        for (int n = 0; n < kMaxTimes; ++n)
            if (scene_.plan(camera, design_).pending == 0) break;
        if (!painter_.prepare(session_.gl, scene_.seen_from(input_.view), input_))
            throw std::runtime_error("the terrain cannot be uploaded");
        session_.surface->release_current();
    }
    /// On the cleared surface, which is current, until it is finished.
    void draw() {
        gl::Gl& gl = session_.gl;
        gl::bind_surface(gl, *session_.surface);
        gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl->Enable(GL_DEPTH_TEST);
        gl->Enable(GL_CULL_FACE);
        draw::TerrainDrawResult drawn;
        const double far_m = std::fmax(scene_.farthest_depth_m(input_.view), 2 * input_.view.near_m);
        painter_.draw(gl, scene_.seen_from(input_.view), input_, {input_.view.near_m, far_m}, drawn);
        gl->Finish();
    }
    void make_current() {
        if (!session_.surface->make_current()) throw std::runtime_error("the surface cannot be made current");
        session_.gl.activate();
    }
    void release_current() { session_.surface->release_current(); }
    [[nodiscard]] display::TerrainPlanner& scene() { return scene_; }
    [[nodiscard]] const display::TerrainPainter& painter() const { return painter_; }
    [[nodiscard]] const terrain::View& view() const { return input_.view; }

private:
    base::Arena& arena(const char* line) {
        const auto bytes = static_cast<std::size_t>(session_.device.budget.find(line)->bytes);
        blocks_.push_back(std::make_unique<Block>(bytes));
        return blocks_.back()->arena;
    }
    struct Block {
        explicit Block(std::size_t bytes) : memory(bytes), arena(memory.data(), memory.size()) {}
        std::vector<std::uint8_t> memory;
        base::Arena arena;
    };

    GlSession session_;
    base::SynchronousReader reader_;
    design::DesignSettings design_;
    std::vector<std::unique_ptr<Block>> blocks_;
    display::TerrainPlanner scene_;
    display::TerrainPainter painter_;
    draw::TerrainDrawInput input_;
};

}  // namespace tedavis::test_support
