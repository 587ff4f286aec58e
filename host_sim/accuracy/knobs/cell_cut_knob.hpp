/// How a cell of a field is cut for an isosurface (render_core/scene/kuhn_cell.hpp), a setting with one level.
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_cell_cut_knob(const KnobGround& ground);

/// The values at the corners of a face between two cells, less the surface's level; the first index is along one axis.
struct FaceValues {
    double corner[2][2];

    /// Two opposite corners are inside (0 or more) and the other two are not.
    [[nodiscard]] bool is_ambiguous() const;
    /// The knob's reference, of an ambiguous face: whether the bilinear surface on it joins its two inside corners (G. Nielson
    /// and B. Hamann, The asymptotic decider, IEEE Visualization 1991).
    [[nodiscard]] bool joins_inside() const;
};

}  // namespace tedavis::host_sim
