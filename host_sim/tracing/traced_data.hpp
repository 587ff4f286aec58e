/// A quantity of a scene database as colour on traced ground, fainter with greater uncertainty (the thesis's future work, 6.2.4).
///
/// It is sampled from the database's field at a grid of places with at most kMaxAcross along a side. Where the value or its
/// uncertainty is not known, the ground keeps its colour: missing data are never shown as values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/tracing/traced_ground.hpp"
#include "render_core/base/time.hpp"
#include "render_core/raytrace/picture/trace_look.hpp"

namespace tedavis::host_sim {

class TracedData {
public:
    static constexpr std::uint32_t kMaxAcross = 512;

    /// The quantity `name` ("layer" or "layer.attribute"; empty: the first quantity on a grid), at its lowest level and at
    /// `time`; without it at its first time. Throws UserError where the file is damaged or has no such quantity.
    TracedData(const TracedGround& ground, const std::string& scene_path, const std::string& name,
               const std::optional<base::Time>& time);
    TracedData(const TracedData&) = delete;
    TracedData& operator=(const TracedData&) = delete;

    /// Adds the data to `look`, which then refers to this object's memory.
    void show(raytrace::TraceLook& look) const;

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const std::string& unit() const { return unit_; }
    [[nodiscard]] double lowest() const { return lowest_; }
    [[nodiscard]] double highest() const { return highest_; }
    [[nodiscard]] double share() const { return share_; }  ///< fraction of the sampled places that have a value, 0..1

private:
    std::string name_, unit_;
    double lowest_ = 0, highest_ = 0, share_ = 0;
    std::uint32_t columns_ = 0, rows_ = 0;
    double step_x_ = 1, step_y_ = 1;
    std::vector<float> values_, uncertainties_;
    std::vector<glm::vec3> palette_;
};

}  // namespace tedavis::host_sim
