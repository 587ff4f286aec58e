#include "host_sim/scene_builder/derived_attribute.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <memory>
#include <optional>

#include "host_sim/scene_builder/bound_attribute.hpp"
#include "host_sim/scene_builder/component_uncertainty.hpp"
#include "host_sim/scene_builder/draft_grid.hpp"
#include "host_sim/scene_builder/grid_speed.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/scene/wind.hpp"

namespace tedavis::host_sim {
namespace {

using scene::FieldValue;
using scene::Uncertainty;
using scene::UncertaintyKind;
using scene::ValueState;

constexpr double kNothingDerived = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view kPrefix = "derived:";
constexpr std::array<std::string_view, 6> kNames = {"cross_wind", "cross_wind_speed", "head_wind",
                                                    "wind_speed", "ground_speed",     "vertical_speed"};
constexpr std::size_t kMaxNeighbours = 30;  // to either side, for a track

bool is_wind(DerivedQuantity quantity) { return quantity <= DerivedQuantity::wind_speed; }

[[noreturn]] void refuse(const LayerRecipe& recipe, const AttributeRecipe& attribute, const std::string& what) {
    throw UserError(recipe.name + ": '" + attribute.variable + "' " + what);
}

DerivedQuantity quantity_of(const LayerRecipe& recipe, const AttributeRecipe& attribute) {
    const auto name = std::string_view(attribute.variable).substr(kPrefix.size());
    const auto* const found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end())
        refuse(recipe, attribute,
               "is nothing that can be derived; these are derived:cross_wind, derived:cross_wind_speed, derived:head_wind, "
               "derived:wind_speed, "
               "derived:ground_speed and derived:vertical_speed");
    return static_cast<DerivedQuantity>(found - kNames.begin());
}

/// The points of a layer, line by line.
class LinePoints {
public:
    explicit LinePoints(const LayerDraft& layer) : points_(layer.points), starts_(layer.starts) {}

    /// Goes to a point; later ones only.
    void go_to(std::size_t n) {
        while (n >= starts_[line_ + 1]) ++line_;
        here_ = n;
    }
    [[nodiscard]] const scene::ScenePoint& here() const { return points_[here_]; }
    [[nodiscard]] const scene::ScenePoint& before(std::size_t by = 1) const {
        return points_[here_ - std::min(by, here_ - starts_[line_])];
    }
    [[nodiscard]] const scene::ScenePoint& behind(std::size_t by = 1) const {
        return points_[std::min(here_ + by, std::size_t{starts_[line_ + 1]} - 1)];
    }

    [[nodiscard]] double ground_speed_mps() const { return over_time(glm::length(way(before(), behind()))); }
    [[nodiscard]] double vertical_speed_mps() const {
        return over_time(static_cast<double>(behind().height_m) - static_cast<double>(before().height_m));
    }
    /// NaN where it stands still.
    [[nodiscard]] double track_rad() const {
        for (std::size_t by = 1; by <= kMaxNeighbours; ++by) {
            const glm::dvec2 gone = way(before(by), behind(by));
            if (glm::length(gone) >= kMinTrack_m) return std::atan2(gone.x, gone.y);
        }
        return kNothingDerived;
    }

private:
    /// Metres east and north, over the ellipsoid at sea level.
    [[nodiscard]] glm::dvec2 way(const scene::ScenePoint& from, const scene::ScenePoint& to) const {
        const double latitude = here().latitude_rad;
        const double east = std::remainder(to.longitude_rad - from.longitude_rad, 2 * base::kPi);
        return {east * std::cos(latitude) * earth::prime_vertical_radius_m(latitude),
                (to.latitude_rad - from.latitude_rad) * earth::meridian_radius_m(latitude)};
    }
    [[nodiscard]] double over_time(double gone) const {
        const std::int64_t from = before().time_ns, to = behind().time_ns;
        if (from == scene::kNoTime || to == scene::kNoTime || to <= from) return kNothingDerived;
        return gone / (1e-9 * static_cast<double>(to - from));
    }

    const std::vector<scene::ScenePoint>& points_;
    const std::vector<std::uint32_t>& starts_;
    std::size_t line_ = 0, here_ = 0;
};

/// A number with what is known of it.
struct Derived {
    double value = kNothingDerived;
    std::optional<double> unsure;  ///< in the value's unit, or percent of it
    Uncertainty level;             ///< of classes
    ValueState state = ValueState::missing;
};

double part_of(const scene::TrackWind& wind, double speed_mps, DerivedQuantity quantity) {
    switch (quantity) {
        case DerivedQuantity::head_wind: return wind.head_mps;
        case DerivedQuantity::cross_wind: return wind.cross_mps;
        case DerivedQuantity::cross_wind_speed: return std::abs(wind.cross_mps);
        default: return speed_mps;
    }
}

class WindAlong {
public:
    WindAlong(const LayerRecipe& recipe, const AttributeRecipe& attribute, const LayerDraft& line, const LayerDraft& wind)
        : time_ns_(recipe.wind_time_ns),
          grid_(wind),
          east_(require(recipe, attribute, "east")),
          north_(require(recipe, attribute, "north")),
          scale_(shared_scale(scale_of(east_), scale_of(north_))) {
        if (!wind.levels_m.empty() && wind.height_datum != line.height_datum)
            refuse(recipe, attribute,
                   "needs heights over the same level as those of '" + wind.name +
                       "'; state 'height_datum' where the source's is another");
    }

    [[nodiscard]] const UncertaintyScale& scale() const { return scale_; }

    [[nodiscard]] Derived at(const scene::ScenePoint& point, double track_rad, DerivedQuantity quantity) const {
        const std::int64_t time_ns = time_ns_.value_or(point.time_ns);
        if (!is_within(time_ns)) return {};
        const auto value = [&](const scene::Attribute& attribute) {
            return scene::GridField(grid_.layer(), attribute)
                .at(point.latitude_rad, point.longitude_rad, static_cast<double>(point.height_m), time_ns);
        };
        const FieldValue east = value(east_), north = value(north_);
        if (east.state == ValueState::missing || north.state == ValueState::missing) return {};
        const double speed = std::hypot(east.value, north.value);
        // The part of the wind that is asked for is that along a direction.
        double toward_rad = track_rad + base::kPi;
        if (quantity <= DerivedQuantity::cross_wind_speed) toward_rad = track_rad - 0.5 * base::kPi;
        if (quantity == DerivedQuantity::wind_speed) toward_rad = std::atan2(east.value, north.value);
        const scene::TrackWind wind = scene::along_track(east.value, north.value, track_rad);
        Derived derived;
        derived.value = part_of(wind, speed, quantity);
        if (!std::isfinite(derived.value)) return {};
        derived.state = std::max(east.state, north.state);
        derived.level = worse_on(scale_, east.uncertainty, scale_of(east_), north.uncertainty, scale_of(north_));
        if (scale_.kind == UncertaintyKind::ordinal || !derived.level.is_known()) return derived;
        derived.unsure = std::hypot(in_unit(east_, east) * std::sin(toward_rad), in_unit(north_, north) * std::cos(toward_rad));
        // A small part of a strong wind is not as sure as its percents are small.
        if (scale_.kind == UncertaintyKind::percent) *derived.unsure /= std::abs(derived.value);
        return derived;
    }

private:
    const scene::Attribute& require(const LayerRecipe& recipe, const AttributeRecipe& attribute, const char* name) const {
        const scene::Attribute* const found = grid_.find(name);
        if (found == nullptr)
            refuse(recipe, attribute,
                   "needs the attributes 'east' and 'north' (m/s) of '" + recipe.wind_layer + "'; bind them there");
        return *found;
    }
    [[nodiscard]] bool is_within(std::int64_t time_ns) const {
        const base::Span<const std::int64_t>& times = grid_.layer().times_ns;
        return times.empty() || (time_ns >= times[0] && time_ns <= times[times.size() - 1]);
    }
    static UncertaintyScale scale_of(const scene::Attribute& attribute) {
        return {attribute.entry->uncertainty_kind, double{attribute.entry->uncertainty_full},
                double{attribute.entry->uncertainty_growth_per_hour}};
    }
    /// Percents times the value.
    [[nodiscard]] double in_unit(const scene::Attribute& attribute, const FieldValue& value) const {
        const double stated = value.uncertainty.level() * double{attribute.entry->uncertainty_full};
        return scale_.kind == UncertaintyKind::percent ? stated * std::abs(value.value) : stated;
    }

    const std::optional<std::int64_t> time_ns_;
    const DraftGrid grid_;
    const scene::Attribute &east_, &north_;
    const UncertaintyScale scale_;
};

class DerivedMaker {
public:
    DerivedMaker(const LayerRecipe& recipe, const AttributeRecipe& attribute, const LayerDraft& layer,
                 const std::vector<LayerDraft>& layers)
        : recipe_(recipe), attribute_(attribute), layer_(layer), quantity_(quantity_of(recipe, attribute)) {
        if (layer.shape != scene::LayerShape::lines) refuse(recipe, attribute, "is for lines, and this layer has none");
        if (attribute.scale != scene::AttributeScale::quantitative)
            refuse(recipe, attribute, "is quantitative; leave out 'scale' and 'classes'");
        if (is_wind(quantity_)) wind_ = std::make_unique<WindAlong>(recipe, attribute, layer, wind_layer(layers));
        const UncertaintyRecipe& unsure = attribute.uncertainty;
        if (unsure.kind != UncertaintyKind::none && (wind_ != nullptr || !unsure.value))
            refuse(recipe, attribute,
                   wind_ != nullptr ? "has the uncertainty of the wind; leave its own out"
                                    : "can state its uncertainty as a 'value' only");
    }

    AttributeDraft make(std::vector<std::string>& notes) {
        AttributeDraft made = bind_attribute(attribute_);
        made.of = scene::AttributeOf::point;
        if (made.unit.empty() && attribute_.factor == 1) made.unit = "m/s";
        if (wind_ != nullptr) {
            made.derived_from = recipe_.wind_layer;
            made.derived_time_ns = recipe_.wind_time_ns;
            const UncertaintyScale& scale = wind_->scale();
            made.uncertainty_kind = scale.kind;
            made.uncertainty_full = (is_in_unit_of_values(scale.kind) ? std::abs(attribute_.factor) : 1) * scale.full;
        } else {
            made.uncertainty_all = bound_uncertainty(attribute_, kNothingDerived);
        }
        std::size_t missing = 0;
        LinePoints points(layer_);
        for (std::size_t n = 0; n < layer_.points.size(); ++n) {
            points.go_to(n);
            const Derived derived = at(points);
            made.values.push_back(bound_value(attribute_, derived.value));
            missing += std::isnan(made.values.back()) ? 1 : 0;
            if (wind_ == nullptr) continue;
            made.uncertainties.push_back(level_of(derived));
            made.states.push_back(derived.state == ValueState::missing ? ValueState::valid : derived.state);
        }
        if (missing > 0)
            notes.push_back(recipe_.name + ": '" + attribute_.variable + "' is missing at " + std::to_string(missing) + " of " +
                            std::to_string(layer_.points.size()) + " points" +
                            (wind_ == nullptr ? ", which have no time, or no neighbour"
                                              : ", which stand still, or outside of '" + recipe_.wind_layer + "' or its times"));
        return made;
    }

private:
    [[nodiscard]] const LayerDraft& wind_layer(const std::vector<LayerDraft>& layers) const {
        if (recipe_.wind_layer.empty()) refuse(recipe_, attribute_, "needs 'wind_layer', the name of a grid in this scene file");
        for (const LayerDraft& layer : layers)
            if (layer.name == recipe_.wind_layer && layer.shape == scene::LayerShape::grid) return layer;
        refuse(recipe_, attribute_, "needs a grid, and '" + recipe_.wind_layer + "' is none of this scene file; name one");
    }
    [[nodiscard]] Derived at(const LinePoints& points) const {
        if (wind_ != nullptr) {
            const double track_rad = quantity_ == DerivedQuantity::wind_speed ? 0 : points.track_rad();
            return wind_->at(points.here(), track_rad, quantity_);
        }
        Derived derived;
        derived.value = quantity_ == DerivedQuantity::ground_speed ? points.ground_speed_mps() : points.vertical_speed_mps();
        return derived;
    }
    [[nodiscard]] Uncertainty level_of(const Derived& derived) const {
        if (derived.state == ValueState::missing || !derived.unsure) return derived.level;
        return Uncertainty::from_level(*derived.unsure / wind_->scale().full);
    }

    const LayerRecipe& recipe_;
    const AttributeRecipe& attribute_;
    const LayerDraft& layer_;
    const DerivedQuantity quantity_;
    std::unique_ptr<WindAlong> wind_;
};

}  // namespace

bool is_derived(const AttributeRecipe& recipe) { return recipe.variable.compare(0, kPrefix.size(), kPrefix) == 0; }

LayerRecipe without_derived(const LayerRecipe& recipe) {
    LayerRecipe others = recipe;
    others.attributes.erase(std::remove_if(others.attributes.begin(), others.attributes.end(), is_derived),
                            others.attributes.end());
    return others;
}

std::vector<std::string> add_derived(const LayerRecipe& recipe, LayerDraft& layer, const std::vector<LayerDraft>& layers) {
    std::vector<std::string> notes;
    for (std::size_t n = 0; n < recipe.attributes.size(); ++n) {
        if (!is_derived(recipe.attributes[n])) continue;
        AttributeDraft made = layer.shape == scene::LayerShape::grid
                                  ? grid_speed(recipe, recipe.attributes[n], layer)
                                  : DerivedMaker(recipe, recipe.attributes[n], layer, layers).make(notes);
        layer.attributes.insert(layer.attributes.begin() + static_cast<std::ptrdiff_t>(n), std::move(made));
    }
    return notes;
}

}  // namespace tedavis::host_sim
