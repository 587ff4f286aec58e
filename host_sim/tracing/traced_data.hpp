/// A quantity of a scene database as colour on traced ground, the fainter the less sure it is (the thesis's future work, 6.2.4).
///
/// It is sampled from the database's field at places of the ground, so many posts apart that kMaxAcross do. Where a place, or
/// its uncertainty, is not known, the ground is as it is: missing data are never shown as values.
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

    /// The quantity `name` ("layer" or "layer.attribute"; empty: the first quantity on a grid), at its lowest level and a time;
    /// by default its own first. Throws UserError: the file is damaged, or has no such quantity.
    TracedData(const TracedGround& ground, const std::string& scene_path, const std::string& name,
               const std::optional<base::Time>& time);
    TracedData(const TracedData&) = delete;
    TracedData& operator=(const TracedData&) = delete;

    /// The look borrows this object's memory.
    void show(raytrace::TraceLook& look) const;

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const std::string& unit() const { return unit_; }
    [[nodiscard]] double lowest() const { return lowest_; }
    [[nodiscard]] double highest() const { return highest_; }
    [[nodiscard]] double share() const { return share_; }  ///< of the ground's places that have a value

private:
    std::string name_, unit_;
    double lowest_ = 0, highest_ = 0, share_ = 0;
    std::uint32_t columns_ = 0, rows_ = 0;
    double step_x_ = 1, step_y_ = 1;
    std::vector<float> values_, uncertainties_;
    std::vector<glm::vec3> palette_;
};

}  // namespace tedavis::host_sim
