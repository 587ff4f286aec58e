/// A picture's lightness and colours at full and reduced sizes, for the measures of clutter.
#pragma once

#include <array>
#include <vector>

#include "host_sim/png_file.hpp"
#include "render_core/perception/lab_planes.hpp"

namespace tedavis::host_sim {

/// L, a, b in hundredths of CIELab's units (perception/lab_planes.hpp); each level has half the width and height of the one
/// before (perception/pyramid.hpp). Owns its values.
class LabLevels {
public:
    static constexpr int kLevels = 3;

    /// A picture of at most perception::kMaxPictureSide a side.
    explicit LabLevels(const RgbaPicture& picture);

    [[nodiscard]] const perception::LabPlanes& level(int n) const { return levels_[static_cast<std::size_t>(n)]; }

private:
    std::vector<float> values_;
    std::array<perception::LabPlanes, kLevels> levels_;
};

}  // namespace tedavis::host_sim
