/// A small traced picture from above the middle of a terrain, with one of up to four settings, on which the knobs of traced
/// pictures are measured.
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
    /// All settings must have the same surface. The ground must outlive the picture. Throws UserError where the tracer cannot
    /// trace from the pose.
    SmallPicture(const TracedGround& ground, const std::vector<raytrace::TraceSettings>& settings, const SmallView& view);
    ~SmallPicture();
    SmallPicture(const SmallPicture&) = delete;
    SmallPicture& operator=(const SmallPicture&) = delete;

    void draw(std::size_t setting);
    /// The linear light of the last picture, row by row.
    [[nodiscard]] base::Span<const glm::vec3> light() const;
    [[nodiscard]] const SmallView& view() const { return view_; }

private:
    class Drawer;
    template <class Height>
    class DrawerOf;

    SmallView view_;
    std::unique_ptr<Drawer> drawer_;
};

/// The light of the same view, each pixel the mean of `parts` x `parts` traced ones.
[[nodiscard]] std::vector<glm::vec3> light_of_finer(const TracedGround& ground, const raytrace::TraceSettings& settings,
                                                    const SmallView& view, std::uint32_t parts);
/// Root mean square over the three colours; light above 1 counts as 1, as in raytrace/picture/picture_error.hpp.
[[nodiscard]] double light_difference(const glm::vec3& light, const glm::vec3& other);

}  // namespace tedavis::host_sim
