/// The effect of foci on the ground: the look of the context, and rims. Programs with shaders/focus.frag read it.
///
/// The degree is computed for every pixel from its coordinates in each focus' plane (scene/focus_region.hpp), which are linear
/// over a triangle, and from the points of the foci. So rims are exact at any distance, unlike a distance field in texels or
/// degrees at vertices (triangles may be wider than a focus). Four foci of sixteen points exceed the sixteen uniform vectors of
/// a fragment shader on the smallest device, so the points are stored in a second row of the palette's texture, 24 bits per
/// number. Each chunk has the list of points that matter to it. Chunks completely in focus are drawn by the program without
/// foci; chunks completely in the context read no points.
///
/// The context is common to all foci (design::terrain_of_context). Degrees and looks never change warning colours, colours of
/// values, and ground without data.
///
/// Memory  the second row of the texture (kRenderTargets). Thread  the GL thread. Failure  none.
#pragma once

#include "render_core/draw/ground_focus_kind.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/texture.hpp"
#include "render_core/scene/focus_region.hpp"
#include "render_core/terrain/lod_selection.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::draw {

/// For blur, shaders/focus.frag writes degrees of focus as distance codes: kSharpCode / 255 stands for the degree 1, the code of
/// the distance sharp_distance_m().
inline constexpr double kSharpCode = 20;
[[nodiscard]] double sharp_distance_m() noexcept;

/// Uniforms of every program that is built with FOCI.
inline constexpr std::size_t kFocusUniforms = 4;
inline constexpr const char* kFocusUniformNames[kFocusUniforms] = {"focus_axes", "focus_parts", "focus_look", "focus_least"};

/// Returns the spacing of a grid's lines: 1, 2 or 5 times a power of ten metres, so that the radius of the focus has two or more.
[[nodiscard]] double focus_grid_spacing_m(double radius_m) noexcept;

/// The data of foci for a chunk of terrain.
struct FocusOfChunk {
    bool is_in_focus = true;                                          ///< the whole chunk is; the program without foci draws it
    double least_degree = 0;                                          ///< least degree of all points of the chunk
    std::uint8_t first[scene::kMaxFoci]{}, count[scene::kMaxFoci]{};  ///< parts of each focus
};

class GroundFocus {
public:
    static constexpr std::uint32_t kTexelsOfFocus = 64, kTexels = scene::kMaxFoci * kTexelsOfFocus;

    /// Sets the frame's foci; both arguments must stay valid until it is drawn. `regions` null, or none valid: everything is in
    /// focus. `blurs` is false where brightness replaces blur.
    void set(const scene::FocusRegions* regions, const design::FocusList& foci, bool blurs);
    [[nodiscard]] bool is_any() const { return is_any_; }
    /// Uploads the points to a texture's row where they have changed.
    void upload(gl::Gl& gl, gl::Texture& texture, std::uint32_t row);

    [[nodiscard]] FocusOfChunk of_chunk(const terrain::ChunkEntry& entry, const terrain::View& view) const;

    /// The program must be in use; `first` is the index of kFocusUniformNames in its list. The program's positions are relative
    /// to `origin` (ECEF, m).
    void set_frame_uniforms(gl::Gl& gl, const gl::Program& program, std::size_t first, const glm::dvec3& origin) const;
    static void set_chunk_uniforms(gl::Gl& gl, const gl::Program& program, std::size_t first, const FocusOfChunk& chunk);

    /// The number in a texel, as the shader reads it; for tests.
    [[nodiscard]] double number_at(std::uint32_t texel) const;
    [[nodiscard]] double unit_m() const { return unit_m_; }

private:
    void write(std::uint32_t texel, double number);
    void write_focus(std::uint32_t n);
    void look_at(std::uint32_t n, const terrain::ChunkEntry& entry, double pixel_m, FocusOfChunk& chunk) const;
    [[nodiscard]] const scene::FocusRegion& region(std::uint32_t n) const { return (*regions_)[n]; }
    [[nodiscard]] std::uint32_t count() const;

    const scene::FocusRegions* regions_ = nullptr;
    const design::FocusList* foci_ = nullptr;
    bool is_any_ = false, is_uploaded_ = false;
    design::FocusTerrain look_;
    double unit_m_ = 1;
    std::array<std::uint8_t, 4 * kTexels> texels_{}, uploaded_{};
};

}  // namespace tedavis::draw
