/// A small traced picture from over the middle of a terrain, with one of up to four settings: what the knobs of traced pictures
/// are measured on.
#pragma once

#include <memory>
#include <vector>

#include "host_sim/tracing/traced_ground.hpp"
#include "render_core/raytrace/picture/trace_settings.hpp"

namespace tedavis::host_sim {

struct SmallView {
    std::uint32_t width = 40, height = 30;
    double heading_deg = 40;
};

class SmallPicture {
public:
    /// All settings have the same surface. The ground must outlive the picture. Throws UserError: the tracer cannot see from
    /// there.
    SmallPicture(const TracedGround& ground, const std::vector<raytrace::TraceSettings>& settings, const SmallView& view);
    ~SmallPicture();
    SmallPicture(const SmallPicture&) = delete;
    SmallPicture& operator=(const SmallPicture&) = delete;

    void draw(std::size_t setting);
    /// Of the picture that was drawn last, linear, row by row.
    [[nodiscard]] base::Span<const glm::vec3> light() const;
    [[nodiscard]] const SmallView& view() const { return view_; }

private:
    class Drawer;
    template <class Height>
    class DrawerOf;

    SmallView view_;
    std::unique_ptr<Drawer> drawer_;
};

/// The same view with the means of `parts` x `parts` pixels each.
[[nodiscard]] std::vector<glm::vec3> light_of_finer(const TracedGround& ground, const raytrace::TraceSettings& settings,
                                                    const SmallView& view, std::uint32_t parts);
/// Root mean square over the three colours; light above 1 counts as 1, as raytrace/picture/picture_error.hpp has it.
[[nodiscard]] double light_difference(const glm::vec3& light, const glm::vec3& other);

}  // namespace tedavis::host_sim
