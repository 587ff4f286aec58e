/// The programs that find, count and show edges, and their inputs.
///
/// Memory  none of ours. Thread  the GL thread. Failure  start(): one sentence.
#pragma once

#include <array>
#include <cstdint>

#include "render_core/gl/program.hpp"
#include "render_core/gl/texture.hpp"

namespace tedavis::draw {

/// In the order in which they first run.
enum class EdgeStep : std::uint8_t { planes, blur, crests, follow, count, regions, show_edges, show_regions, count_ };
inline constexpr std::size_t kEdgeSteps = static_cast<std::size_t>(EdgeStep::count_);

/// Uniforms of all steps; each has some of them.
enum EdgeUniform : std::size_t {
    kEdgeTexture,
    kEdgeTextureSize,
    kEdgePicture,
    kEdgeBand,
    kEdgeRows,
    kEdgeBell,
    kEdgeThresholds,
    kEdgeParts,
    kEdgeUniforms
};

/// Largest loop counts in texels: across a part of a region, and over a region's counts. Some devices unroll loops.
struct EdgeLoops {
    std::uint32_t blocks = 1, counts = 1;
};

class EdgePrograms {
public:
    /// Builds the programs; those for showing only where `shows` is true.
    [[nodiscard]] base::Error start(gl::Gl& gl, const EdgeLoops& loops, bool shows);
    [[nodiscard]] bool has(EdgeStep step) const { return programs_[static_cast<std::size_t>(step)].valid(); }
    /// Makes the program of a step current, with the texture of a picture of this size as its input.
    [[nodiscard]] const gl::Program& use(gl::Gl& gl, EdgeStep step, const gl::Texture& texture, std::uint32_t width_px,
                                         std::uint32_t height_px) const;
    void destroy(gl::Gl& gl);

private:
    [[nodiscard]] base::Error build(gl::Gl& gl, EdgeStep step, const EdgeLoops& loops);
    std::array<gl::Program, kEdgeSteps> programs_;
};

}  // namespace tedavis::draw
