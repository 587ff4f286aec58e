/// A surface with GL opened on it, and a small scene whose pixels are known beforehand.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "render_core/base/ports/surface.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/buffer.hpp"
#include "render_core/gl/gl.hpp"
#include "render_core/gl/program.hpp"

namespace tedavis::test_support {

/// Makes the surface current and opens GL for a shipped device; stops the test program with the sentence when that fails.
struct GlSession {
    GlSession(const std::string& backend, const std::string& device_name, std::uint32_t width = 64, std::uint32_t height = 48);
    GlSession(std::unique_ptr<base::Surface> surface, const effects::DeviceSettings& settings);
    ~GlSession();

    /// RGBA8, bottom row first.
    [[nodiscard]] std::vector<std::uint8_t> pixels();

    effects::DeviceSettings device;
    std::unique_ptr<base::Surface> surface;
    gl::Gl gl;
};

/// A triangle whose corners have the primary colours, depth-tested against a far grey one that covers the surface.
class TriangleScene {
public:
    /// Start stage.
    TriangleScene(gl::Gl& gl, base::BudgetTable& budget);
    void draw(gl::Gl& gl, const base::Surface& surface) const;
    void destroy(gl::Gl& gl);

private:
    gl::Program program_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
};

/// The text of a program in the common dialect of both lanes, with attributes `position` (0) and `color` (1) and the
/// uniform `brightness`.
[[nodiscard]] gl::ProgramSource triangle_program_source();

}  // namespace tedavis::test_support
