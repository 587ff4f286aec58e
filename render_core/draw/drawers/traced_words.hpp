/// Converts the hits of a traced picture to the words of a geometry picture (geometry_picture.hpp), for styles that codes cannot
/// represent.
///
/// Each pixel has the number of the selected chunk that contains its cell, so that it is shaded with that chunk's attribute pages
/// and uniforms, as the chunk's triangles would be. The surface is the database's exact one, whatever the level of the chunk.
///
/// Memory    an arena at start(). Thread  uses the workers; the words do not depend on their number.
#pragma once

#include "render_core/draw/drawers/geometry_picture.hpp"
#include "render_core/draw/traced_ground.hpp"
#include "render_core/raytrace/view_kernels.hpp"
#include "render_core/terrain/lattice.hpp"
#include "render_core/terrain/lod_selection.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::draw {

struct WordsInput {
    const TracedGround& ground;
    const raytrace::HitPicture& hits;  ///< of the view, with `u` and `v`
    const terrain::View& view;
    base::Span<const terrain::SelectedChunk> chunks;  ///< cover all visible ground; their slots are below kMaxGeometrySlots
};

class TracedWords {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(const terrain::Lattice& lattice, std::uint32_t width, std::uint32_t height);
    /// Allocates memory; returns false where the arena is too small.
    [[nodiscard]] bool start(const terrain::Lattice& lattice, std::uint32_t width, std::uint32_t height, base::Arena& arena);
    /// Writes the words of all pixels; the view has the size at start.
    void write(const WordsInput& input, base::Workers& workers);
    /// One per pixel, rows from the bottom as in GL.
    [[nodiscard]] base::Span<const GeometryWords> words() const { return {words_.data(), words_.size()}; }

    /// The part of the lattice that a chunk covers.
    struct Part {
        std::uint32_t i0 = 0, j0 = 0;
        float per_column = 0, per_row = 0;  ///< 1 / cells across, 1 / cells down
    };

private:
    void assign(base::Span<const terrain::SelectedChunk> chunks);

    terrain::Lattice lattice_;
    std::uint32_t across_ = 0, down_ = 0;  ///< chunks of the finest level
    base::Span<std::uint16_t> numbers_;    ///< by chunk of the finest level: the selected chunk that covers it; 0: none
    base::Span<Part> parts_;               ///< by number
    base::Span<GeometryWords> words_;
};

}  // namespace tedavis::draw
