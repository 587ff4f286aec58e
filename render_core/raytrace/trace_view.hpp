/// What a picture's rays meet: one ray a pixel, exactly what trace_ray() finds, bit for bit, but many times faster.
///
/// Beams of 32 x 32, 16 x 16, 8 x 8 and 4 x 4 pixels find out how far none of their rays meets anything (kernel/beam_march.hpp);
/// from there rays go on in lanes of the widest vectors that the machine has (view_kernels.hpp). What beams and lanes change is
/// the time that it takes. Pictures whose columns lie in vertical planes are swept column by column instead
/// (kernel/column_sweep.hpp).
///
/// Memory  an arena at start: about a byte a pixel. Thread  trace() uses the workers; the result does not depend on their number.
#pragma once

#include "render_core/base/ports/workers.hpp"
#include "render_core/raytrace/trace_ray.hpp"
#include "render_core/raytrace/view_kernels.hpp"

namespace tedavis::raytrace {

/// Memory of a picture, borrowed: width x height of each, rows from the top.
struct HitPicture {
    static constexpr std::int32_t kNoCell = -1;

    base::Span<float> t;            ///< infinite where nothing is met
    base::Span<std::int32_t> cell;  ///< row * (columns of cells) + column
    base::Span<HitSide> side;
};

template <class Height>
class ViewTracer {
public:
    static constexpr std::uint32_t kMostSide = 16384;

    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t width, std::uint32_t height);
    /// False where the arena has no room, or a side is 0 or more than kMostSide.
    [[nodiscard]] bool start(std::uint32_t width, std::uint32_t height, base::Arena& arena);
    /// The kernel is one of view_kernels(). The picture is of the size at start.
    void trace(const TracedField<Height>& field, const GridCamera& camera, const ViewKernel<Height>& kernel,
               base::Workers& workers, const HitPicture& picture);

private:
    std::uint32_t width_ = 0, height_ = 0;
    BeamStarts beams_[kBeamSizes];
};

}  // namespace tedavis::raytrace
