/// Traces the rays of a picture over the ground: the tracer with memory for one picture.
///
/// Memory    an arena at start(). Thread  trace() uses the workers; the hits do not depend on their number.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/draw/traced_ground.hpp"
#include "render_core/raytrace/space/trace_ground.hpp"

namespace tedavis::draw {

class TracedView {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t width, std::uint32_t height);
    /// Allocates memory; returns false where the arena is too small.
    [[nodiscard]] bool start(std::uint32_t width, std::uint32_t height, base::Arena& arena);
    /// Traces the view, which has the size at start; t of hits is the depth along the view's axis, metres.
    void trace(const TracedGround& ground, const raytrace::GroundSpace& space, const terrain::View& view, base::Workers& workers);
    /// Clears all hits.
    void clear();
    /// The hits of the last traced view.
    [[nodiscard]] const raytrace::HitPicture& hits() const { return hits_; }

private:
    std::uint32_t width_ = 0, height_ = 0;
    raytrace::HitPicture hits_;
};

}  // namespace tedavis::draw
