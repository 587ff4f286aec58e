#include "tests/support/programs/gl_session.hpp"

#include <cstdio>
#include <cstdlib>

#include "platform/surface_factory.hpp"
#include "render_core/gl/draw_triangles.hpp"
#include "render_core/gl/readback.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/files/device_files.hpp"

namespace tedavis::test_support {
namespace {

[[noreturn]] void stop(const char* message) {
    std::fprintf(stderr, "%s\n", message);
    std::abort();
}

template <class R>
auto take(R result) {
    if (!result) stop(result.error().message.c_str());
    return std::move(result.value());
}

std::unique_ptr<base::Surface> surface_for(const std::string& backend, const effects::DeviceSettings& device, std::uint32_t width,
                                           std::uint32_t height) {
    platform::SurfaceSettings settings{width, height, platform::ContextLane::es3};
    if (device.capability.lane == effects::Lane::es2) settings.lane = platform::ContextLane::es2;
    return take(platform::make_surface(backend, settings));
}

struct Vertex {
    float x, y, z;
    std::uint8_t r, g, b, a;
};
constexpr Vertex kVertices[] = {{-3.0f, -1.0f, 0.5f, 90, 90, 90, 255}, {3.0f, -1.0f, 0.5f, 90, 90, 90, 255},
                                {0.0f, 5.0f, 0.5f, 90, 90, 90, 255},   {-0.7f, -0.6f, 0.0f, 255, 0, 0, 255},
                                {0.8f, -0.5f, 0.0f, 0, 255, 0, 255},   {0.1f, 0.75f, 0.0f, 0, 0, 255, 255}};
constexpr std::uint16_t kIndices[] = {3, 4, 5, 0, 1, 2};  // the near one first: only the depth test keeps it
constexpr gl::AttributeBinding kAttributes[] = {{"position", 0}, {"color", 1}};
constexpr const char* kUniforms[] = {"brightness"};

constexpr const char* kVertexShader =
    "VERTEX_IN vec3 position;\n"
    "VERTEX_IN vec4 color;\n"
    "VARYING vec4 tint;\n"
    "void main() {\n"
    "    tint = color;\n"
    "    gl_Position = vec4(position, 1.0);\n"
    "}\n";
constexpr const char* kFragmentShader =
    "VARYING vec4 tint;\n"
    "uniform float brightness;\n"
    "void main() { FRAGMENT_COLOR = vec4(tint.rgb * brightness, 1.0); }\n";

}  // namespace

GlSession::GlSession(const std::string& backend, const std::string& device_name, std::uint32_t width, std::uint32_t height)
    : device(shipped_device(device_name)), surface(surface_for(backend, device, width, height)) {
    if (!surface->make_current()) stop("the surface cannot be made current");
    take(gl.open(*surface, device.capability));
}

GlSession::GlSession(std::unique_ptr<base::Surface> made, const effects::DeviceSettings& settings)
    : device(settings), surface(std::move(made)) {
    if (!surface->make_current()) stop("the surface cannot be made current");
    take(gl.open(*surface, device.capability));
}

GlSession::~GlSession() { surface->release_current(); }

std::vector<std::uint8_t> GlSession::pixels() {
    std::vector<std::uint8_t> bytes(std::size_t{4} * surface->width() * surface->height());
    if (!gl::read_pixels(gl, surface->width(), surface->height(), bytes)) stop("the pixels cannot be read back");
    return bytes;
}

gl::ProgramSource triangle_program_source() {
    gl::ProgramSource source;
    source.name = "triangle";
    source.vertex = kVertexShader;
    source.fragment = kFragmentShader;
    source.attributes = kAttributes;
    source.uniforms = kUniforms;
    return source;
}

TriangleScene::TriangleScene(gl::Gl& gl, base::BudgetTable& budget)
    : program_(take(gl::build_program(gl, triangle_program_source()))),
      vertices_(take(gl::make_buffer(gl, *budget.find("terrain_vertices"), gl::BufferKind::vertices, gl::BufferUse::fixed,
                                     sizeof kVertices))),
      indices_(take(
          gl::make_buffer(gl, *budget.find("terrain_indices"), gl::BufferKind::indices, gl::BufferUse::fixed, sizeof kIndices))) {
    if (!vertices_.upload(gl, 0, kVertices, sizeof kVertices) || !indices_.upload(gl, 0, kIndices, sizeof kIndices))
        stop("upload refused");
}

void TriangleScene::draw(gl::Gl& gl, const base::Surface& surface) const {
    gl::bind_surface(gl, surface);
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthMask(GL_TRUE);
    gl->ClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    program_.use(gl);
    gl->Uniform1f(program_.uniform(0), 1.0f);
    vertices_.bind(gl);
    gl->EnableVertexAttribArray(0);
    gl->EnableVertexAttribArray(1);
    gl->VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
    gl->VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Vertex), reinterpret_cast<const void*>(offsetof(Vertex, r)));
    indices_.bind(gl);
    gl::draw_triangles(gl, {0, 6, 5});
}

void TriangleScene::destroy(gl::Gl& gl) {
    program_.destroy(gl);
    vertices_.destroy(gl);
    indices_.destroy(gl);
}

}  // namespace tedavis::test_support
