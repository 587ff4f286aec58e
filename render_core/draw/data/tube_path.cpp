#include "render_core/draw/data/tube_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "render_core/draw/data/placement.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr std::uint64_t kPathPadding_bytes = 64;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kHour_ns = 3.6e12;
constexpr std::uint32_t kReferencePlaces = 256;  // below the lines, where the ground is asked

/// Tolerances from the finest on, each 2^(1/4) times the one before.
constexpr std::size_t kTolerances = 64;
std::array<double, kTolerances> tolerances_from(double finest_m) {
    std::array<double, kTolerances> all{};
    for (std::size_t n = 0; n < kTolerances; ++n) all[n] = finest_m * std::exp2(0.25 * static_cast<double>(n));
    return all;
}

}  // namespace

std::uint64_t TubeLine::bytes_needed(std::uint32_t points) {
    return std::uint64_t{points} * (sizeof(scene::TubePoint) + sizeof(std::uint32_t)) + kPathPadding_bytes;
}

bool TubePlace::is_known() const { return std::isfinite(place.x); }

bool TubeLine::start(base::Arena& arena, std::uint32_t points) {
    points_ = arena.allocate_array<scene::TubePoint>(points);
    numbers_ = arena.allocate_array<std::uint32_t>(points);
    clear();
    return points_.size() == points && numbers_.size() == points;
}

bool TubeLine::add(const scene::TubePoint& point, std::uint32_t number) {
    if (count_ == points_.size()) return false;
    points_[count_] = point;
    numbers_[count_++] = number;
    return true;
}

bool TubeLine::ends_in_gap() const { return count_ > 0 && std::isnan(points_[count_ - 1].position.x); }

std::uint64_t TubePath::bytes_needed() {
    return kTubeWindow * (sizeof(PolylineVertex) + sizeof(float) + sizeof(PolylineStretch)) + kPathPadding_bytes;
}

bool TubePath::start(base::Arena& arena) {
    window_ = arena.allocate_array<PolylineVertex>(kTubeWindow);
    weights_ = arena.allocate_array<float>(kTubeWindow);
    waiting_ = arena.allocate_array<PolylineStretch>(kTubeWindow);
    return !window_.empty() && !weights_.empty() && !waiting_.empty();
}

bool TubePath::is_space_time() const { return input_->element.technique == design::DataTechnique::space_time; }

void TubePath::plan(const ElementInput& input, std::uint32_t most_points) {
    input_ = &input;
    const design::DataElement& element = input.element;
    const std::string_view names[3] = {element.by_color.attribute.view(), element.by_second_color.attribute.view(),
                                       element.size_attribute.view()};
    for (std::size_t n = 0; n < 3; ++n) shown_[n] = names[n].empty() ? nullptr : input.layer.find(names[n]);
    radius_m_ = element.size_m > 0 && !is_space_time() ? element.size_m : kDefaultTubeRadius_m;
    if (is_space_time()) take_reference();
    const auto tolerances = tolerances_from(radius_m_ * std::pow(10.0, 1 - 2 * element.detail));
    std::array<std::uint64_t, kTolerances + 1> kept_by{};  // points that so many of the tolerances keep
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature)
        visit(feature, [&](const TubePlace& at) {
            if (!at.is_known()) return;
            const auto* const keeps = std::lower_bound(tolerances.begin(), tolerances.end(), static_cast<double>(at.weight_m));
            ++kept_by[static_cast<std::size_t>(keeps - tolerances.begin())];
        });
    std::uint64_t kept = kept_by[kTolerances];
    std::size_t finest = kTolerances - 1;
    while (finest > 0 && kept + kept_by[finest] <= most_points) kept += kept_by[finest--];
    tolerance_m_ = tolerances[finest];
}

void TubePath::read(std::uint32_t feature, TubeLine& line) {
    line.clear();
    visit(feature, [&](const TubePlace& at) {
        const bool is_kept = static_cast<double>(at.weight_m) > tolerance_m_;
        const bool is_gap_again = !at.is_known() && line.ends_in_gap();
        line.left_out += is_kept ? 0 : 1;
        if (is_kept && !is_gap_again)
            static_cast<void>(line.add({at.place, {at.time_ns}, static_cast<float>(radius_of(feature, at.number))}, at.number));
    });
}

/// Calls the visitor with every point; those without a place weigh infinitely much.
template <class Visitor>
void TubePath::visit(std::uint32_t feature, Visitor visitor) {
    const scene::Run run = input_->layer.points_of(feature);
    constexpr float kAll = std::numeric_limits<float>::infinity();
    const std::uint32_t end = run.first + run.count;
    std::int64_t time_ns = scene::kNoTime;
    for (std::uint32_t first = run.first; first < end;) {
        const std::uint32_t count = fill(feature, first, end);
        if (count == 0) {
            visitor(TubePlace{glm::dvec3(kNone), time_ns, kAll, first++});
            continue;
        }
        weigh_vertices({window_.data(), count}, weights_, waiting_);
        // A full window's last point begins the next one.
        const std::uint32_t visited = count == kTubeWindow && first + count < end ? count - 1 : count;
        for (std::uint32_t n = 0; n < visited; ++n) {
            if (const std::int64_t stated = input_->layer.points[first + n].time_ns; stated != scene::kNoTime) time_ns = stated;
            visitor(TubePlace{window_[n].place, time_ns, weights_[n], first + n});
        }
        first += visited;
    }
}

std::uint32_t TubePath::fill(std::uint32_t feature, std::uint32_t first, std::uint32_t end) {
    std::uint32_t count = 0;
    for (std::uint32_t n = first; n < end && count < kTubeWindow; ++n, ++count) {
        const scene::ScenePoint& point = input_->layer.points[n];
        if (n > first && point.time_ns < input_->layer.points[n - 1].time_ns) break;
        PolylineVertex& at = window_[count];
        at.place = place_of(point);
        if (!std::isfinite(at.place.x)) break;
        for (std::size_t k = 0; k < 3; ++k) at.values[k] = value_in_metres(shown_[k], feature, n);
    }
    return count;
}

glm::dvec3 TubePath::place_of(const scene::ScenePoint& point) const {
    const bool comes_by = input_->has_date && input_->layer.entry->role == scene::LayerRole::traffic;
    if (comes_by && point.time_ns > input_->time_ns) return glm::dvec3(kNone);
    if (!is_space_time()) {
        const Placed at = placed(*input_, point);
        return at.is_known ? at.place : glm::dvec3(kNone);
    }
    if (point.time_ns == scene::kNoTime || std::isnan(reference_m_)) return glm::dvec3(kNone);
    const double height_m = reference_m_ + metres_per_ns_ * static_cast<double>(point.time_ns - first_time_ns_);
    return earth::to_ecef({point.latitude_rad, point.longitude_rad, {height_m}});
}

/// A missing value is half a range below the least, so that its border is kept.
double TubePath::value_in_metres(const scene::Attribute* attribute, std::uint32_t feature, std::uint32_t point) const {
    if (attribute == nullptr) return 0;
    const std::size_t n = attribute->entry->of == scene::AttributeOf::point ? point : feature;
    const double least = static_cast<double>(attribute->entry->minimum),
                 range = static_cast<double>(attribute->entry->maximum) - least;
    const double whole_m = kRadiiOfRange * radius_m_;
    if (n >= attribute->values.size() || attribute->state(n) == scene::ValueState::missing) return -0.5 * whole_m;
    return range > 0 ? whole_m * (static_cast<double>(attribute->values[n]) - least) / range : 0;
}

double TubePath::radius_of(std::uint32_t feature, std::uint32_t point) const {
    if (shown_[2] == nullptr) return radius_m_;
    const double largest = static_cast<double>(shown_[2]->entry->maximum);
    const double value =
        scene::value_or_nan(input_->layer, input_->element.size_attribute.view(), scene::PointOfFeature{feature, point});
    const double share = largest > 0 && value > 0 ? value / largest : 0;
    return radius_m_ * std::clamp(share, kThinnestTube, 1.0);
}

void TubePath::take_reference() {
    const base::Span<const scene::ScenePoint> points = input_->layer.points;
    const double hour_m = input_->element.size_m > 0 ? input_->element.size_m : kDefaultTimeHeight_m;
    metres_per_ns_ = hour_m / kHour_ns;
    reference_m_ = kNone;
    first_time_ns_ = scene::kNoTime;
    for (const scene::ScenePoint& point : points)
        if (point.time_ns != scene::kNoTime && (first_time_ns_ == scene::kNoTime || point.time_ns < first_time_ns_))
            first_time_ns_ = point.time_ns;
    const std::size_t step = std::max<std::size_t>(1, points.size() / kReferencePlaces);
    for (std::size_t n = 0; n < points.size(); n += step)
        reference_m_ = std::fmax(reference_m_, input_->ground.height_m(points[n].latitude_rad, points[n].longitude_rad));
}

}  // namespace tedavis::draw
