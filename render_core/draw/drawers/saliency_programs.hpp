/// The programs that compute and show saliency maps, and their inputs.
///
/// Memory  none of its own. Thread  the GL thread. Failure  start(): one sentence.
#pragma once

#include <array>
#include <cstdint>

#include "render_core/gl/program.hpp"
#include "render_core/gl/texture.hpp"

namespace tedavis::draw {

/// In the order in which they first run.
enum class SaliencyStep : std::uint8_t {
    lab,
    soften,
    reduce,
    rows,
    energy,
    colors_contrast,
    blue_contrast,
    energy_contrast,
    most,
    count,
    sum_counts,
    conspicuity,
    total,
    most_total,
    map,
    show_map,
    show_heat,
    count_
};
inline constexpr std::size_t kSaliencySteps = static_cast<std::size_t>(SaliencyStep::count_);

/// Uniforms of all steps; each has some of them. The first are textures, whose units have the same numbers, and their sizes.
enum SaliencyUniform : std::size_t {
    kSaliencyFirst,
    kSaliencySecond,
    kSaliencyThird,
    kSaliencyFourth,
    kSaliencyFigures,
    kSaliencyTextures,
    kSaliencySizes = kSaliencyTextures,
    kSaliencyStrip = kSaliencySizes + kSaliencyTextures,
    kSaliencyShare,
    kSaliencyHasCoarser,
    kSaliencyOrigin,
    kSaliencyColumn,
    kSaliencyScale,
    kSaliencyBell,
    kSaliencyCosine,
    kSaliencySine,
    kSaliencySlantCosine,
    kSaliencySlantSine,
    kSaliencyFlatShare,
    kSaliencyUniforms
};

class SaliencyPrograms {
public:
    /// Builds the programs for maps whose pixels cover 2^level x 2^level pixels of the picture; those that show a map only where
    /// requested.
    [[nodiscard]] base::Error start(gl::Gl& gl, int level, bool shows_map, bool shows_heat);
    [[nodiscard]] bool has(SaliencyStep step) const { return programs_[static_cast<std::size_t>(step)].valid(); }
    /// Makes the program of a step current.
    [[nodiscard]] const gl::Program& use(gl::Gl& gl, SaliencyStep step) const;
    void destroy(gl::Gl& gl);

private:
    [[nodiscard]] base::Error build(gl::Gl& gl, SaliencyStep step, int level);
    std::array<gl::Program, kSaliencySteps> programs_;
};

/// For the program in use: binds a texture to its unit, and states its size.
void read_texture(gl::Gl& gl, const gl::Program& program, SaliencyUniform place, const gl::Texture& texture);

}  // namespace tedavis::draw
