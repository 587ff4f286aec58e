#include "host_sim/scene_builder/feature_layer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/name_choices.hpp"
#include "host_sim/scene_builder/feature_filter.hpp"
#include "host_sim/scene_builder/feature_value.hpp"
#include "host_sim/scene_builder/stated_number.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using scene::LayerShape;

constexpr double kHighest_m = 100000;

std::string counted(std::size_t count, const std::string& what) { return std::to_string(count) + " " + what; }

class FeatureLayerMaker {
public:
    FeatureLayerMaker(const LayerRecipe& recipe, SourceFeatures source)
        : recipe_(recipe), source_(std::move(source)), shape_(shape_of(recipe.role, source_.features)) {
        for (const std::string& note : source_.notes) this->note(note);
    }

    FeatureLayer make() {
        require_no_words_for_grids();
        require_stated();
        keep_shape();
        keep_what_is_asked_for();
        LayerDraft& draft = made_.draft;
        draft.name = recipe_.name;
        draft.title = recipe_.title;
        draft.shape = shape_;
        draft.height_datum = recipe_.height_datum.value_or(source_.height_datum);
        add_points();
        add_names();
        for (const AttributeRecipe& attribute : recipe_.attributes) add(attribute);
        set_data_time();
        if (source_.features.empty()) note("nothing is left to show");
        return std::move(made_);
    }

private:
    /// Once: heights and an attribute may come from one column.
    void note(const std::string& message) {
        std::vector<std::string>& notes = made_.notes;
        const std::string whole = recipe_.name + ": " + message;
        if (std::find(notes.begin(), notes.end(), whole) == notes.end()) notes.push_back(whole);
    }
    void add_count_note(std::size_t count, const std::string& what) {
        if (count > 0) note(counted(count, what));
    }
    void add_misfits_note(const Misfits& misfits, const std::string& variable, const char* are_no) {
        if (misfits.count > 0)
            note(counted(misfits.count, "values of '" + variable + "' are no " + are_no + " and count as missing (the first: '" +
                                            misfits.first + "')"));
    }
    [[noreturn]] void refuse(const std::string& what) const { throw UserError(recipe_.name + ": " + what); }

    void require_no_words_for_grids() const {
        const PreparationRecipe& prepare = recipe_.prepare;
        const char* word = nullptr;
        if (!recipe_.levels.empty()) word = "levels";
        if (!recipe_.heights_m.empty()) word = "heights_m";
        if (recipe_.members == "bands") word = "members";
        if (prepare.fill_cells > 0) word = "fill_cells";
        if (prepare.smooth_cells > 0) word = "smooth_cells";
        for (const AttributeRecipe& attribute : recipe_.attributes) {
            if (attribute.uncertainty.is_spread) word = "is_spread";
            if (!attribute.uncertainty.source.empty()) word = "uncertainty.source";
        }
        if (word != nullptr) refuse("'" + std::string(word) + "' is for grids, and " + recipe_.source + " is none; leave it out");
    }

    void require_stated() const {
        const auto require = [this](const std::string& variable) {
            if (variable.empty() || source_.features.empty() || is_stated(source_, variable)) return;
            refuse("'" + variable + "' is not in " + recipe_.source + ", which states " + stated_names() + hint());
        };
        require(recipe_.height_variable);
        require(recipe_.time_variable);
        if (recipe_.name_variable != kUsualName) require(recipe_.name_variable);
        for (const AttributeRecipe& attribute : recipe_.attributes) {
            require(attribute.variable);
            require(attribute.uncertainty.variable);
        }
        const std::string& keep = recipe_.prepare.keep_attribute;
        if (!keep.empty() && kept_by() == nullptr)
            refuse("keep_attribute '" + keep +
                   "' is none of the attributes that the source states; bind it in an [[layer.attribute]] (bound are " +
                   bound_names() + ")" + hint());
    }
    [[nodiscard]] std::string stated_names() const {
        std::set<std::string> names = source_.columns;
        for (const SourceFeature& feature : source_.features) {
            for (const auto& [name, text] : feature.fields) names.insert(name);
            for (const auto& [name, values] : feature.point_values) names.insert(name);
        }
        return names.empty() ? "nothing beside places" : name_choices(names);
    }
    [[nodiscard]] std::string bound_names() const {
        std::vector<std::string> names;
        for (const AttributeRecipe& attribute : recipe_.attributes) names.push_back(attribute.name);
        return name_choices(names);
    }
    [[nodiscard]] std::string hint() const { return look_hint(source_.file.empty() ? recipe_.source : source_.file); }
    [[nodiscard]] const AttributeRecipe* kept_by() const {
        for (const AttributeRecipe& attribute : recipe_.attributes)
            if (attribute.name == recipe_.prepare.keep_attribute) return &attribute;
        return nullptr;
    }

    /// Removes features; returns how many.
    template <class Predicate>
    std::size_t remove(Predicate is_unwanted) {
        std::vector<SourceFeature>& features = source_.features;
        const auto end = std::remove_if(features.begin(), features.end(), is_unwanted);
        const auto removed = static_cast<std::size_t>(features.end() - end);
        features.erase(end, features.end());
        return removed;
    }
    void keep_shape() {
        std::size_t others[4] = {};
        (void)remove([&](const SourceFeature& feature) {
            const bool is_other = feature.shape != shape_;
            if (is_other) ++others[static_cast<std::size_t>(feature.shape)];
            return is_other;
        });
        const auto most = static_cast<std::size_t>(std::max_element(others, std::end(others)) - others);
        if (source_.features.empty() && others[most] > 0)
            refuse("its source has " + std::string(shape_name(static_cast<LayerShape>(most))) + " alone, and the role shows " +
                   std::string(shape_name(shape_)) + "; choose another role or source");
        for (std::size_t shape = 1; shape < 4; ++shape)
            add_count_note(others[shape], std::string(shape_name(static_cast<LayerShape>(shape))) +
                                              " are left out: the role shows " + std::string(shape_name(shape_)));
        if (shape_ == LayerShape::areas)
            add_count_note(remove([](const SourceFeature& feature) { return feature.points.size() < 3; }),
                           "areas have fewer than three points and are left out");
    }
    void keep_what_is_asked_for() {
        if (!recipe_.time_variable.empty()) set_times();
        const std::size_t least = shape_ == LayerShape::areas ? 3 : 1;
        (void)remove([&](SourceFeature& feature) {
            keep_times(feature, recipe_.from_ns, recipe_.until_ns);
            return feature.points.size() < least;
        });
        const PreparationRecipe& prepare = recipe_.prepare;
        if (prepare.region) (void)remove([&](const SourceFeature& feature) { return !reaches(feature, *prepare.region); });
        if (const AttributeRecipe* const attribute = kept_by())
            (void)remove([&](const SourceFeature& feature) { return !is_kept(*attribute, feature); });
    }
    /// Of attributes by point one is enough.
    [[nodiscard]] bool is_kept(const AttributeRecipe& attribute, const SourceFeature& feature) const {
        Misfits ignored;
        for (std::size_t n = 0; n < feature.points.size(); ++n) {
            const auto value = double{point_value(attribute, feature, n, ignored)};
            if (value >= recipe_.prepare.keep_least && value <= recipe_.prepare.keep_most) return true;
        }
        return false;
    }
    void set_times() {
        Misfits misfits;
        for (SourceFeature& feature : source_.features) {
            const auto field = feature.fields.find(recipe_.time_variable);
            if (field == feature.fields.end()) continue;
            const std::optional<std::int64_t> time = stated_instant_ns(field->second);
            if (!time) misfits.add(field->second);
            for (SourcePoint& point : feature.points)
                if (!point.time_ns) point.time_ns = time;
        }
        add_misfits_note(misfits, recipe_.time_variable, "times such as 2026-06-01T14:00:00Z");
    }

    void add_points() {
        LayerDraft& draft = made_.draft;
        const bool has_runs = shape_ != LayerShape::points;
        if (has_runs) draft.starts.push_back(0);
        Misfits misfits;
        for (const SourceFeature& feature : source_.features) {
            const double height_m = height_of(feature, misfits);
            for (const SourcePoint& point : feature.points) add_point(point, height_m);
            if (has_runs) draft.starts.push_back(static_cast<std::uint32_t>(draft.points.size()));
            if (shape_ == LayerShape::lines) count_faults(feature);
        }
        add_misfits_note(misfits, recipe_.height_variable, "numbers");
        add_count_note(repeated_, "points repeat the one before");
        add_count_note(times_back_, "points are earlier than the one before");
    }
    /// From the recipe's variable; NaN: the points' own.
    [[nodiscard]] double height_of(const SourceFeature& feature, Misfits& misfits) const {
        const auto field = feature.fields.find(recipe_.height_variable);
        if (field == feature.fields.end()) return kNone;
        const std::optional<double> stated = stated_number(field->second);
        if (!stated) misfits.add(field->second);
        return stated ? *stated * recipe_.height_factor : kNone;
    }
    void add_point(const SourcePoint& point, double height_m) {
        const double height = recipe_.height_variable.empty() ? point.height_m.value_or(kNone) : height_m;
        if (std::abs(height) > kHighest_m)
            refuse("a height of " + std::to_string(height) +
                   " m is more than can be shown; check height_variable, height_factor");
        made_.draft.points.push_back({base::radians(point.latitude_deg), base::radians(point.longitude_deg),
                                      static_cast<float>(height), 0, point.time_ns.value_or(scene::kNoTime)});
    }
    void count_faults(const SourceFeature& feature) {
        for (std::size_t n = 1; n < feature.points.size(); ++n) {
            const SourcePoint &a = feature.points[n - 1], &b = feature.points[n];
            repeated_ +=
                a.latitude_deg == b.latitude_deg && a.longitude_deg == b.longitude_deg && a.height_m == b.height_m ? 1 : 0;
            times_back_ += a.time_ns && b.time_ns && *b.time_ns < *a.time_ns ? 1 : 0;
        }
    }

    void add_names() {
        std::vector<std::string> names;
        bool any = false;
        for (const SourceFeature& feature : source_.features) {
            const auto field = feature.fields.find(recipe_.name_variable);
            names.push_back(field == feature.fields.end() ? "" : field->second);
            any |= !names.back().empty();
        }
        if (any) made_.draft.names = std::move(names);
    }

    void add(const AttributeRecipe& recipe) {
        AttributeDraft attribute = bind_attribute(recipe);
        const UncertaintyRecipe& unsure = recipe.uncertainty;
        const bool of_points =
            shape_ != LayerShape::points && (is_of_points(source_, recipe.variable) || is_of_points(source_, unsure.variable));
        attribute.of = of_points ? scene::AttributeOf::point : scene::AttributeOf::feature;
        const bool has_own = !unsure.variable.empty();
        if (!has_own) attribute.uncertainty_all = bound_uncertainty(recipe, kNone);
        Misfits values, levels;
        for (const SourceFeature& feature : source_.features) {
            for (std::size_t n = 0; n < (of_points ? feature.points.size() : 1); ++n) {
                attribute.values.push_back(of_points ? point_value(recipe, feature, n, values)
                                                     : feature_value(recipe, feature, values));
                if (has_own)
                    attribute.uncertainties.push_back(of_points ? point_uncertainty(recipe, feature, n, levels)
                                                                : feature_uncertainty(recipe, feature, levels));
            }
        }
        const bool is_classed = recipe.scale != scene::AttributeScale::quantitative;
        add_misfits_note(values, recipe.variable, is_classed ? "class of the attribute" : "numbers");
        add_misfits_note(levels, unsure.variable, unsure.classes.empty() ? "numbers" : "class of its uncertainty");
        made_.draft.attributes.push_back(std::move(attribute));
    }

    void set_data_time() {
        std::int64_t last = source_.data_time_ns.value_or(scene::kNoTime);
        for (const scene::ScenePoint& point : made_.draft.points) last = std::max(last, point.time_ns);
        made_.draft.data_time_ns = recipe_.data_time_ns.value_or(last);
    }

    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    static constexpr std::string_view kUsualName = "name";

    const LayerRecipe& recipe_;
    SourceFeatures source_;
    const LayerShape shape_;
    FeatureLayer made_;
    std::size_t repeated_ = 0, times_back_ = 0;
};

}  // namespace

FeatureLayer make_feature_layer(const LayerRecipe& recipe, SourceFeatures source) {
    return FeatureLayerMaker(recipe, std::move(source)).make();
}

}  // namespace tedavis::host_sim
