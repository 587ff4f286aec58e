#include "host_sim/accuracy/knobs/small_picture.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/tracing/ground_look.hpp"
#include "host_sim/tracing/shot_drawer.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kAboveGround_m = 600, kLookedDown_deg = 8;

TracedShotPlan small_plan(const TracedGround& ground, const SmallView& view) {
    const glm::dvec3 middle(0.5 * ground.columns(), 0.5 * ground.rows(), 0);
    const earth::Geodetic place = earth::from_ecef(ground.space().position(middle));
    TracedShotPlan plan;
    plan.width = view.width;
    plan.height = view.height;
    plan.is_direct = true;
    plan.pose.latitude_deg = base::degrees(place.latitude_rad);
    plan.pose.longitude_deg = base::degrees(place.longitude_rad);
    plan.pose.altitude_msl_m = ground.height_near(middle).value_or(ground.highest_m()) + kAboveGround_m;
    plan.pose.heading_deg = view.heading_deg;
    plan.pose.pitch_deg = -kLookedDown_deg;
    return plan;
}

}  // namespace

class SmallPicture::Drawer {
public:
    virtual ~Drawer() = default;
    virtual void draw(std::size_t setting) = 0;
    [[nodiscard]] virtual base::Span<const glm::vec3> light() const = 0;
};

template <class Height>
class SmallPicture::DrawerOf final : public Drawer {
public:
    DrawerOf(const TracedGround& ground, const std::vector<raytrace::TraceSettings>& settings, const TracedShotPlan& plan)
        : look_(ground, sun_at(plan.pose, plan.time)),
          drawer_(ground, settings, plan),
          regions_(std::size_t{raytrace::PictureVariants::regions_across(plan.width)} *
                   raytrace::PictureVariants::regions_down(plan.height)) {
        drawer_.build(ground, alone_);
    }
    void draw(std::size_t setting) override {
        std::fill(regions_.begin(), regions_.end(), static_cast<std::uint8_t>(setting));
        static_cast<void>(drawer_.draw(look_.look(), {regions_.data(), regions_.size()}, true, alone_));
    }
    [[nodiscard]] base::Span<const glm::vec3> light() const override { return drawer_.stages().light(); }

private:
    base::SerialWorkers alone_;
    GroundLook look_;
    ShotDrawer<Height> drawer_;
    std::vector<std::uint8_t> regions_;
};

SmallPicture::SmallPicture(const TracedGround& ground, const std::vector<raytrace::TraceSettings>& settings,
                           const SmallView& view)
    : view_(view) {
    const TracedShotPlan plan = small_plan(ground, view);
    if (ground.is_whole())
        drawer_ = std::make_unique<DrawerOf<std::int16_t>>(ground, settings, plan);
    else
        drawer_ = std::make_unique<DrawerOf<float>>(ground, settings, plan);
}

SmallPicture::~SmallPicture() = default;
void SmallPicture::draw(std::size_t setting) { drawer_->draw(setting); }
base::Span<const glm::vec3> SmallPicture::light() const { return drawer_->light(); }

std::vector<glm::vec3> light_of_finer(const TracedGround& ground, const raytrace::TraceSettings& settings, const SmallView& view,
                                      std::uint32_t parts) {
    SmallPicture finer(ground, {settings}, {view.width * parts, view.height * parts, view.heading_deg});
    finer.draw(0);
    std::vector<glm::vec3> means(std::size_t{view.width} * view.height, glm::vec3(0));
    for (std::uint32_t y = 0; y < view.height * parts; ++y)
        for (std::uint32_t x = 0; x < view.width * parts; ++x)
            means[std::size_t{y / parts} * view.width + x / parts] +=
                finer.light()[std::size_t{y} * view.width * parts + x] / static_cast<float>(parts * parts);
    return means;
}

double light_difference(const glm::vec3& light, const glm::vec3& other) {
    double squares = 0;
    for (int color = 0; color < 3; ++color) {
        const double off = static_cast<double>(std::min(light[color], 1.0f)) - static_cast<double>(std::min(other[color], 1.0f));
        squares += off * off;
    }
    return std::sqrt(squares / 3);
}

}  // namespace tedavis::host_sim
