/// Triangles in one colour, positions only, back faces culled: what a rasterizer takes for them at the least.
/// make_current() before add() and draw(), release_current() before another surface is used. Another fragment shader may be
/// given.
#pragma once

#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "render_core/draw/depth_plan.hpp"
#include "render_core/gl/render_target.hpp"
#include "render_core/terrain/view.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::test_support {

class BareTriangles {
public:
    static constexpr const char* kOneColor = "void main() { FRAGMENT_COLOR = vec4(0.4, 0.5, 0.3, 1.0); }\n";

    BareTriangles(const std::string& device, std::uint32_t width, std::uint32_t height, const char* fragment = kOneColor)
        : session_("egl", device, width, height) {
        gl::Gl& gl = session_.gl;
        base::BudgetTable& budget = session_.device.budget;
        auto program = gl::build_program(gl, source(fragment));
        auto vertices = gl::make_buffer(gl, *budget.find("terrain_vertices"), gl::BufferKind::vertices, gl::BufferUse::streamed,
                                        budget.find("terrain_vertices")->bytes);
        auto indices = gl::make_buffer(gl, *budget.find("terrain_indices"), gl::BufferKind::indices, gl::BufferUse::streamed,
                                       budget.find("terrain_indices")->bytes);
        if (!program.ok() || !vertices.ok() || !indices.ok()) throw std::runtime_error("bare triangles cannot be drawn here");
        program_ = std::move(program.value());
        vertices_ = std::move(vertices.value());
        indices_ = std::move(indices.value());
        release_current();
    }
    BareTriangles(const BareTriangles&) = delete;
    BareTriangles& operator=(const BareTriangles&) = delete;
    ~BareTriangles() {
        make_current();
        program_.destroy(session_.gl);
        vertices_.destroy(session_.gl);
        indices_.destroy(session_.gl);
    }

    void make_current() {
        if (!session_.surface->make_current()) throw std::runtime_error("the surface cannot be made current");
        session_.gl.activate();
    }
    void release_current() { session_.surface->release_current(); }

    void clear() {
        parts_.clear();
        first_vertex_ = first_index_ = 0;
    }
    /// A part of the scene: places relative to the eye in metres, and corners of its triangles.
    void add(const std::vector<glm::vec3>& eye_relative_m, base::Span<const std::uint16_t> corners) {
        gl::Gl& gl = session_.gl;
        if (!vertices_.upload(gl, first_vertex_ * sizeof(glm::vec3), eye_relative_m.data(),
                              eye_relative_m.size() * sizeof(glm::vec3)) ||
            !indices_.upload(gl, first_index_ * sizeof(std::uint16_t), corners.data(), corners.size() * sizeof(std::uint16_t)))
            throw std::runtime_error("bare triangles: too many for the budget lines of the device");
        parts_.push_back({first_vertex_, first_index_, static_cast<GLsizei>(corners.size())});
        first_vertex_ += eye_relative_m.size();
        first_index_ += corners.size();
    }
    [[nodiscard]] std::uint32_t triangles() const { return static_cast<std::uint32_t>(first_index_ / 3); }

    /// On the cleared surface, which is current, until it is finished. `view`: only directions and lens.
    void draw(const terrain::View& view, const draw::DepthRange& range) {
        gl::Gl& gl = session_.gl;
        gl::bind_surface(gl, *session_.surface);
        gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl->Enable(GL_DEPTH_TEST);
        gl->Enable(GL_CULL_FACE);
        program_.use(gl);
        set_rows(view, range);
        vertices_.bind(gl);
        indices_.bind(gl);
        gl->EnableVertexAttribArray(0);
        for (const Part& part : parts_) {
            gl->VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, reinterpret_cast<const void*>(part.vertex * sizeof(glm::vec3)));
            gl->DrawElements(GL_TRIANGLES, part.corners, GL_UNSIGNED_SHORT,
                             reinterpret_cast<const void*>(part.index * sizeof(std::uint16_t)));
        }
        gl->DisableVertexAttribArray(0);
        gl->Finish();
    }
    /// What was drawn, RGBA8, bottom row first; the surface is current.
    [[nodiscard]] std::vector<std::uint8_t> pixels() { return session_.pixels(); }

private:
    struct Part {
        std::size_t vertex, index;
        GLsizei corners;
    };
    static gl::ProgramSource source(const char* fragment) {
        static constexpr gl::AttributeBinding kAttributes[] = {{"position", 0}};
        static constexpr const char* kUniforms[] = {"right_row", "up_row", "forward_row", "depth_row"};
        gl::ProgramSource source;
        source.name = "bare triangles";
        source.vertex =
            "VERTEX_IN vec3 position;\n"
            "uniform vec3 right_row, up_row, forward_row;\n"
            "uniform vec2 depth_row;\n"
            "void main() {\n"
            "    float depth = dot(forward_row, position);\n"
            "    gl_Position = vec4(dot(right_row, position), dot(up_row, position), depth_row.x * depth + depth_row.y, depth);\n"
            "}\n";
        source.fragment = fragment;
        source.attributes = kAttributes;
        source.uniforms = kUniforms;
        return source;
    }
    void set_rows(const terrain::View& view, const draw::DepthRange& range) {
        const auto row = [this](std::size_t uniform, const glm::dvec3& v) {
            session_.gl->Uniform3f(program_.uniform(uniform), static_cast<float>(v.x), static_cast<float>(v.y),
                                   static_cast<float>(v.z));
        };
        row(0, view.right / view.half_width_tangent());
        row(1, -view.down / view.half_height_tangent());
        row(2, view.forward);
        const double n = range.near_m, f = range.far_m;
        session_.gl->Uniform2f(program_.uniform(3), static_cast<float>((f + n) / (f - n)),
                               static_cast<float>(-2 * f * n / (f - n)));
    }

    GlSession session_;
    gl::Program program_;
    gl::Buffer vertices_, indices_;
    std::vector<Part> parts_;
    std::size_t first_vertex_ = 0, first_index_ = 0;
};

}  // namespace tedavis::test_support
