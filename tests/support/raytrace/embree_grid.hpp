/// Embree (Intel, 3.13) over the posts of a grid: another tracer, whose answers and whose speed ours are held against.
///
/// Its space: x columns, y rows, z heights in cells (height steps times `cell_per_step`), so that its boxes are of natural shape.
/// Its grids divide a cell like raytrace::CellSurface::two_triangles; the mesh is made so.
#pragma once

#include <embree3/rtcore.h>

#include <cstdint>
#include <vector>

#include "render_core/raytrace/height_grid.hpp"

namespace tedavis::test_support {

enum class EmbreeMesh : std::uint8_t { grid, triangles };

class EmbreeGrid {
public:
    /// The posts are copied. All must have heights. At most 32767 posts each way. `instruction_set` as in Embree's device
    /// settings; without one it takes what suits the machine best.
    EmbreeGrid(const raytrace::HeightGrid<std::int16_t>& posts, float cell_per_step, EmbreeMesh mesh, unsigned threads,
               const char* instruction_set = nullptr);
    ~EmbreeGrid();
    EmbreeGrid(const EmbreeGrid&) = delete;
    EmbreeGrid& operator=(const EmbreeGrid&) = delete;

    [[nodiscard]] RTCScene scene() const { return scene_; }
    [[nodiscard]] long long bytes() const { return bytes_; }  ///< held now, the posts' copy among them
    [[nodiscard]] double build_ms() const { return build_ms_; }
    /// t of the first hit; infinite where nothing is met.
    [[nodiscard]] float trace(const float (&origin)[3], const float (&direction)[3]) const;

private:
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    long long bytes_ = 0;
    double build_ms_ = 0;
};

}  // namespace tedavis::test_support
