#include "host_sim/accuracy/knobs/depth_knob.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "host_sim/scenario/seeded_random.hpp"
#include "render_core/draw/depth_plan.hpp"

namespace tedavis::host_sim {
namespace {

using draw::DepthPlan;
using draw::DepthRange;

constexpr std::size_t kDepthViews = 64, kQuickDepthViews = 16;
constexpr int kDistancesOfView = 16, kPixelsOfWall = 48;
constexpr double kMinNear_m = 1, kMaxNear_m = 50, kMinFar_m = 50'000, kMaxFar_m = 400'000;
constexpr double kGapStep = 1.189207115002721;  // a quarter of an octave
constexpr int kGapSteps = 96;                   // from kWidestGap down to a 17 millionth of it
constexpr double kWidestGap = 0.5, kNotTold = 1;
constexpr double kSteps24 = 16'777'215, kSteps16 = 65'535;

constexpr std::size_t kPlannedLevel = 0, kCoarseLevel = 2, kLogarithmLevel = 3, kReversedLevel = 4;
constexpr const char* kDepthLevelNames[] = {"24 bits, far and near range", "24 bits, one range", "16 bits, one range",
                                            "24 bits of the logarithm, pixel by pixel", "reversed floats"};

KnobFacts depth_format_facts() {
    std::vector<KnobLevel> levels;
    for (const char* const name : kDepthLevelNames) levels.push_back({name, 0});
    return {"depth_format",
            "Numbers of the depth buffer",
            "draw::plan_depth() with 24 bits; here depths are interpolated in floats on the processor, whose time is stated",
            "the smallest gap between two inclined walls at which, as at all wider ones, every pixel shows the nearer wall",
            "m per km of distance",
            {"painter's order: the walls do not cross", 1e-6, "gaps are tried down to 3e-5 m per km, by quarters of an octave"},
            "pixels of walls drawn by OpenGL (tests/render_core/draw/drawers/test_quad_drawer)",
            "Signs and symbols are drawn after the terrain and hide none of their own by depth.",
            "no scale: five formats",
            std::nullopt,
            std::move(levels),
            "every device of OpenGL ES 2 and SC 2 offers it and it tells 0.3 m per km; logarithms and floats need what only some "
            "devices have"};
}

struct DepthView {
    double near_m, far_m;
    DepthPlan plan;
};

/// A wall across the view, inclined: 1 / depth is linear along a row of pixels, as of every plane. Its edge's ends lie outside of
/// the pixels that are compared.
struct InclinedWall {
    double first_m, last_m;  ///< depths at the ends
    float begin, length;     ///< of the edge, in widths of the compared pixels
};

/// The depth that a format keeps for a pixel of a wall, less for nearer ones.
class DepthFormat {
public:
    DepthFormat(std::size_t level, const DepthRange& range) : level_(level), range_(range) {}

    [[nodiscard]] double kept(const InclinedWall& wall, float pixel) const {
        const float part = (pixel - wall.begin) / wall.length;
        if (level_ == kLogarithmLevel) return logarithm(wall, part);
        const float first = at_end(wall.first_m), last = at_end(wall.last_m);
        const float depth = first + (last - first) * part;
        if (level_ == kReversedLevel) return -static_cast<double>(depth);
        return std::round(static_cast<double>(depth) * (level_ == kCoarseLevel ? kSteps16 : kSteps24));
    }

private:
    /// A vertex's depth in the window, as the vertex shader and the division make it.
    [[nodiscard]] float at_end(double depth_m) const {
        const auto near = static_cast<float>(range_.near_m), far = static_cast<float>(range_.far_m);
        const auto depth = static_cast<float>(depth_m);
        if (level_ == kReversedLevel) return near * (far - depth) / (far - near) / depth;
        const auto scale = static_cast<float>((range_.far_m + range_.near_m) / (range_.far_m - range_.near_m));
        const auto shift = static_cast<float>(-2 * range_.far_m * range_.near_m / (range_.far_m - range_.near_m));
        return 0.5f + 0.5f * ((depth * scale + shift) / depth);
    }
    [[nodiscard]] double logarithm(const InclinedWall& wall, float part) const {
        const auto first = static_cast<float>(1 / wall.first_m), last = static_cast<float>(1 / wall.last_m);
        const float depth_m = 1 / (first + (last - first) * part);
        const float depth = std::log2(1 + depth_m) / std::log2(1 + static_cast<float>(range_.far_m));
        return std::round(static_cast<double>(depth) * kSteps24);
    }

    std::size_t level_;
    DepthRange range_;
};

class DepthFormatKnob final : public Knob {
public:
    explicit DepthFormatKnob(const KnobGround& ground) : Knob(depth_format_facts()) {
        SeededRandom numbers(14);
        for (std::size_t n = 0; n < (ground.is_quick ? kQuickDepthViews : kDepthViews); ++n) {
            const double near_m = kMinNear_m * std::pow(kMaxNear_m / kMinNear_m, numbers.unit());
            const double far_m = kMinFar_m * std::pow(kMaxFar_m / kMinFar_m, numbers.unit());
            views_.push_back({near_m, far_m, draw::plan_depth(near_m, far_m)});
            inclinations_.push_back(numbers.between(0.01, 0.2));
        }
    }

    [[nodiscard]] std::size_t samples() const override { return views_.size(); }
    void run(std::size_t level, std::size_t sample) override {
        for (int n = 0; n < kDistancesOfView; ++n) told_ += is_told(level, sample, n, kWidestGap) ? 1 : 0;
    }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        constexpr double kMetresOfKilometre = 1000;
        for (int n = 0; n < kDistancesOfView; ++n) errors.push_back(kMetresOfKilometre * smallest_told(level, sample, n));
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        char text[120];
        std::snprintf(text, sizeof text, "%.0f m, in a view from %.1f m to %.0f km",
                      distance_m(views_[sample], static_cast<int>(error)), views_[sample].near_m, views_[sample].far_m / 1000);
        return text;
    }

private:
    static double distance_m(const DepthView& view, int number) {
        constexpr double kFromNear = 1.5, kToFar = 0.5;  // walls and gaps stay within the view
        const double first = kFromNear * view.near_m, last = kToFar * view.far_m;
        return first * std::pow(last / first, number / double{kDistancesOfView - 1});
    }
    [[nodiscard]] double smallest_told(std::size_t level, std::size_t sample, int distance) const {
        double gap = kWidestGap, told = kNotTold;
        for (int n = 0; n < kGapSteps && is_told(level, sample, distance, gap); ++n) {
            told = gap;
            gap /= kGapStep;
        }
        return told;
    }
    /// A wall and one behind it by a part of its distance; both are cut into other triangles.
    [[nodiscard]] bool is_told(std::size_t level, std::size_t sample, int distance, double gap) const {
        const DepthView& view = views_[sample];
        const double near_m = distance_m(view, distance);
        const InclinedWall front = wall_at(near_m, inclinations_[sample], -0.35f, 1.9f);
        const InclinedWall back = wall_at(near_m * (1 + gap), inclinations_[sample], -0.15f, 1.4f);
        for (int n = 0; n < kPixelsOfWall; ++n) {
            const float pixel = (static_cast<float>(n) + 0.5f) / kPixelsOfWall;
            if (!is_nearer(level, view, {front, back}, pixel)) return false;
        }
        return true;
    }
    static InclinedWall wall_at(double middle_m, double inclination, float begin, float length) {
        const auto depth_at = [&](float at) { return middle_m / (1 + inclination * (static_cast<double>(at) - 0.5)); };
        return {depth_at(begin), depth_at(begin + length), begin, length};
    }
    static double depth_of(const InclinedWall& wall, float pixel) {
        const double part = static_cast<double>((pixel - wall.begin) / wall.length);
        return 1 / (1 / wall.first_m + (1 / wall.last_m - 1 / wall.first_m) * part);
    }
    /// Where both walls lie in one range its depths decide, else the nearer range, which is drawn last.
    static bool is_nearer(std::size_t level, const DepthView& view, const std::array<InclinedWall, 2>& walls, float pixel) {
        if (level != kPlannedLevel) {
            const DepthFormat format(level, {view.near_m, view.far_m});
            return format.kept(walls[0], pixel) < format.kept(walls[1], pixel);
        }
        const DepthRange& nearest = view.plan.ranges[view.plan.count - 1];
        const bool is_front_in = depth_of(walls[0], pixel) < nearest.far_m,
                   is_back_in = depth_of(walls[1], pixel) < nearest.far_m;
        if (is_front_in != is_back_in) return is_front_in;
        const DepthFormat format(level, is_front_in ? nearest : view.plan.ranges[0]);
        return format.kept(walls[0], pixel) < format.kept(walls[1], pixel);
    }

    std::vector<DepthView> views_;
    std::vector<double> inclinations_;
    int told_ = 0;  ///< so that no compiler leaves the depths out
};

}  // namespace

std::unique_ptr<Knob> make_depth_format_knob(const KnobGround& ground) { return std::make_unique<DepthFormatKnob>(ground); }

}  // namespace tedavis::host_sim
