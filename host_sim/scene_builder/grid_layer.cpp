#include "host_sim/scene_builder/grid_layer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "host_sim/name_choices.hpp"
#include "host_sim/printed_text.hpp"
#include "host_sim/scene_builder/bound_attribute.hpp"
#include "host_sim/scene_builder/ensemble.hpp"
#include "host_sim/scene_builder/grid_axes.hpp"
#include "host_sim/scene_builder/grid_preparation.hpp"
#include "host_sim/scene_builder/grid_window.hpp"
#include "host_sim/scene_builder/source_path.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using scene::ValueState;

bool are_alike(const GridPlaces& a, const GridPlaces& b) {
    const double tolerance_deg = 1e-6 * a.step_lon_deg;
    return a.columns == b.columns && a.rows == b.rows && std::abs(a.west_deg - b.west_deg) < tolerance_deg &&
           std::abs(a.north_deg - b.north_deg) < tolerance_deg && std::abs(a.step_lon_deg - b.step_lon_deg) < tolerance_deg;
}

class GridLayerMaker {
public:
    GridLayerMaker(const LayerRecipe& recipe, const std::string& folder)
        : recipe_(recipe),
          folder_(folder),
          file_(source_path(folder, recipe.source)),
          choice_{recipe.from_ns, recipe.until_ns, recipe.levels, recipe.members == "bands"} {}

    GridLayer make() {
        if (recipe_.attributes.empty()) throw UserError(recipe_.name + ": a grid needs an [[layer.attribute]]; bind one");
        const AttributeRecipe& first = recipe_.attributes.front();
        const GridSource source(file_, first.variable, recipe_.crs, may_be_warped_smoothly(first));
        places_ = source.places();
        window_ = window_of(places_, recipe_.prepare.region);
        if (window_.columns.empty())
            throw UserError(recipe_.name + ": " + file_ + " has nothing in the region that is asked for; move 'region'");
        axes_ = sort_planes(source.planes(), choice_, file_);
        start_layer();
        order_levels();
        if (recipe_.keep_members > 0) choose_members();
        for (const AttributeRecipe& attribute : recipe_.attributes) add(attribute);
        if (source.is_assumed())
            note(recipe_.source + " states no reference system and is taken for longitude and latitude; 'crs' names another");
        return {std::move(layer_), std::move(notes_)};
    }

private:
    [[nodiscard]] static bool is_blendable(const AttributeRecipe& attribute) {
        return attribute.scale == scene::AttributeScale::quantitative;
    }
    /// Numbers that stand for something else must not be mixed with values where a raster is warped.
    [[nodiscard]] static bool may_be_warped_smoothly(const AttributeRecipe& attribute) {
        return is_blendable(attribute) && attribute.missing.empty() && !attribute.undetected;
    }

    void note(const std::string& message) { notes_.push_back(recipe_.name + ": " + message); }

    void start_layer() {
        layer_.name = recipe_.name;
        layer_.title = recipe_.title;
        layer_.shape = scene::LayerShape::grid;
        const std::uint64_t posts =
            std::uint64_t{window_.columns.size()} * window_.rows.size() * axes_.level_count() * axes_.time_count();
        if (posts > kMaxGridPosts)
            throw UserError(recipe_.name + ": " + std::to_string(posts) +
                            " posts are too many for a scene; choose a region, or times");
        layer_.grid = {base::radians(window_.west_deg),
                       base::radians(window_.north_deg),
                       base::radians(places_.step_lon_deg),
                       base::radians(places_.step_lat_deg),
                       static_cast<std::uint32_t>(window_.columns.size()),
                       static_cast<std::uint32_t>(window_.rows.size()),
                       static_cast<std::uint32_t>(axes_.level_count()),
                       static_cast<std::uint32_t>(axes_.time_count())};
        if (axes_.times_ns.size() > 1) layer_.times_ns = axes_.times_ns;
        layer_.data_time_ns = recipe_.data_time_ns.value_or(data_time_of(axes_).value_or(scene::kNoTime));
        if (!axes_.times_ns.empty() && recipe_.valid_hours > 0)
            layer_.valid_until_ns =
                axes_.times_ns.back() +
                static_cast<std::int64_t>(recipe_.valid_hours * static_cast<double>(base::kNanosecondsPerHour));
    }

    /// Heights of levels: given, or the mean of a variable over the layer's posts and times. Ascending in the layer.
    void order_levels() {
        std::vector<double> heights_m = recipe_.heights_m;
        const std::size_t levels = axes_.level_count();
        if (!recipe_.height_variable.empty()) heights_m = mean_heights();
        order_.resize(levels);
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        if (heights_m.empty() && levels == 1) return;
        if (heights_m.size() != levels)
            throw UserError(recipe_.name + ": " + file_ + " has " + std::to_string(levels) + " levels and " +
                            std::to_string(heights_m.size()) +
                            " heights are given; give one for each in heights_m (levels ascending: " + level_names() +
                            "), or name the variable that holds them in height_variable" + look_hint(file_));
        std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) { return heights_m[a] < heights_m[b]; });
        for (const std::size_t level : order_) layer_.levels_m.push_back(static_cast<float>(heights_m[level]));
        if (levels == 1) layer_.levels_m.clear();
    }
    [[nodiscard]] std::string level_names() const {
        std::vector<std::string> names;
        for (const double level : axes_.levels) names.push_back(printed("%.9g", level));
        return name_choices(names);
    }
    std::vector<double> mean_heights() {
        const GridSource source(file_, recipe_.height_variable, recipe_.crs, true);
        const GridAxes axes = sort_planes(source.planes(), choice_, file_);
        require_alike(source.places(), axes, recipe_.height_variable);
        std::vector<double> heights_m(axes.level_count());
        for (std::size_t level = 0; level < heights_m.size(); ++level) {
            double sum = 0, count = 0;
            for (std::size_t time = 0; time < axes.time_count(); ++time)
                for (const GridPlane& plane : axes.members[time * axes.level_count() + level])
                    for (const float value : cut(source.read(plane), places_, window_))
                        if (!std::isnan(value)) sum += double{value}, count += 1;
            if (!(count > 0))
                throw UserError(recipe_.name + ": '" + recipe_.height_variable + "' has no heights here; give heights_m");
            heights_m[level] = recipe_.height_factor * sum / count;
        }
        return heights_m;
    }

    void require_alike(const GridPlaces& places, const GridAxes& axes, const std::string& variable) const {
        if (!are_alike(places, places_) || axes.times_ns != axes_.times_ns || axes.levels != axes_.levels)
            throw UserError(recipe_.name + ": '" + variable + "' lies on another grid than '" +
                            recipe_.attributes.front().variable + "'; put it into a layer of its own");
    }

    /// Planes of a variable as the layer orders them, uncertainties not yet known.
    struct Planes {
        std::vector<std::vector<float>> mean, spread;
        std::vector<Members> kept;  ///< of each plane; empty: none is kept
    };
    /// `take`: called with the members of each plane, in the layer's order.
    template <class Take>
    void for_each_plane(const std::string& file, const std::string& variable, bool may_blend, const Take& take) {
        const GridSource source(file, variable, recipe_.crs, may_blend);
        const GridAxes axes = sort_planes(source.planes(), choice_, file);
        require_alike(source.places(), axes, variable);
        for (std::size_t time = 0; time < axes.time_count(); ++time)
            for (const std::size_t level : order_) {
                Members members;
                for (const GridPlane& plane : axes.members[time * axes.level_count() + level])
                    members.push_back(cut(source.read(plane), places_, window_));
                take(members);
            }
    }
    /// Of the values: a member is bound before it counts, so that what means that there is none has no part in a mean.
    Planes bound_planes(const AttributeRecipe& recipe) {
        Planes planes;
        for_each_plane(file_, recipe.variable, may_be_warped_smoothly(recipe), [&](Members& members) {
            require_mean(recipe, members.size());
            for (std::vector<float>& member : members)
                for (float& value : member) value = bound_value(recipe, double{value});
            EnsembleMean joined = mean_of(members);
            planes.mean.push_back(std::move(joined.mean));
            planes.spread.push_back(std::move(joined.spread));
            if (kept_.empty() || !is_blendable(recipe)) return;
            require_members(members.size(), recipe.variable);
            planes.kept.emplace_back();
            for (const std::size_t n : kept_) planes.kept.back().push_back(members[n]);
        });
        return planes;
    }
    /// Of the variable that says how unsure they are. Where it is warped none is mixed with another: one that is beyond its range
    /// is unknown, and so must stay its part of the ground.
    std::vector<std::vector<float>> stated_planes(const std::string& file, const std::string& variable) {
        std::vector<std::vector<float>> planes;
        for_each_plane(file, variable, false, [&](Members& members) { planes.push_back(mean_of(members).mean); });
        return planes;
    }
    void require_mean(const AttributeRecipe& recipe, std::size_t members) const {
        if (recipe.uncertainty.is_spread && members < 2)
            throw UserError(recipe_.name + ": '" + recipe.variable + "' of " + file_ +
                            " has one member at a time and level, and a spread is that of two or more; leave out 'is_spread', or "
                            "say how unsure it is by 'value' or 'variable'");
        if (!is_blendable(recipe) && members > 1)
            throw UserError(recipe_.name + ": '" + recipe.name + "' has " + std::to_string(members) +
                            " members at a time and level of " + file_ +
                            ", and classes have no mean; choose one with variable = \"band N\"");
    }

    /// By the first attribute, so that a member is the same in all.
    void choose_members() {
        const AttributeRecipe& first = recipe_.attributes.front();
        std::vector<double> sums;
        for_each_plane(file_, first.variable, may_be_warped_smoothly(first), [&](Members& members) {
            if (members_ == 0) members_ = members.size();
            require_members(members.size(), first.variable);
            for (std::vector<float>& member : members)
                for (float& value : member) value = static_cast<float>(stated_value(first, double{value}));
            add_to_sums(members, sums);
        });
        kept_ = evenly_by_rank(sums, recipe_.keep_members);
    }
    void require_members(std::size_t count, const std::string& variable) const {
        if (count != members_ || count < 2)
            throw UserError(recipe_.name + ": '" + variable + "' has " + std::to_string(count) +
                            " members at a time and level where " + std::to_string(std::max<std::size_t>(members_, 2)) +
                            " are needed; leave out 'keep_members'");
    }

    void add(const AttributeRecipe& recipe) {
        AttributeDraft attribute = bind_attribute(recipe);
        const Planes planes = bound_planes(recipe);
        const std::vector<std::vector<float>> levels = levels_of(recipe.uncertainty);
        if (is_blendable(recipe)) attribute.members.resize(kept_.size());
        for (std::size_t n = 0; n < planes.mean.size(); ++n) {
            const std::vector<float>* const unsure =
                recipe.uncertainty.is_spread ? &planes.spread[n] : (levels.empty() ? nullptr : &levels[n]);
            const PreparedPlane bound = bound_plane(recipe, planes.mean[n], unsure);
            PreparedPlane plane = bound;
            prepare(plane, is_blendable(recipe));
            for (std::size_t member = 0; member < attribute.members.size(); ++member)
                add_member(planes.kept[n][member], bound, attribute.members[member]);
            attribute.values.insert(attribute.values.end(), plane.values.begin(), plane.values.end());
            attribute.uncertainties.insert(attribute.uncertainties.end(), plane.uncertainties.begin(), plane.uncertainties.end());
            attribute.states.insert(attribute.states.end(), plane.states.begin(), plane.states.end());
        }
        const auto& values = attribute.values;
        if (std::all_of(values.begin(), values.end(), [](float value) { return std::isnan(value); }))
            note("'" + recipe.variable + "' has no values; nothing but what is missing is shown");
        layer_.attributes.push_back(std::move(attribute));
    }
    /// Of the variable that holds them; empty: there is none.
    std::vector<std::vector<float>> levels_of(const UncertaintyRecipe& unsure) {
        if (unsure.variable.empty()) return {};
        return stated_planes(unsure.source.empty() ? file_ : source_path(folder_, unsure.source), unsure.variable);
    }
    /// `unsure`: what is stated of each value; null: nothing is.
    PreparedPlane bound_plane(const AttributeRecipe& recipe, const std::vector<float>& values,
                              const std::vector<float>* unsure) const {
        PreparedPlane plane;
        plane.columns = static_cast<int>(window_.columns.size());
        plane.rows = static_cast<int>(window_.rows.size());
        plane.values = values;
        for (std::size_t post = 0; post < values.size(); ++post) {
            const double stated = unsure != nullptr ? double{(*unsure)[post]} : std::numeric_limits<double>::quiet_NaN();
            plane.uncertainties.push_back(bound_uncertainty(recipe, stated));
            plane.states.push_back(std::isnan(values[post]) ? ValueState::missing : ValueState::valid);
        }
        return plane;
    }
    /// A member's plane, prepared as that of the mean `bound` is, and missing where it is.
    void add_member(const std::vector<float>& member, const PreparedPlane& bound, std::vector<float>& values) const {
        PreparedPlane plane = bound;
        for (std::size_t post = 0; post < member.size(); ++post)
            if (bound.states[post] != ValueState::missing) plane.values[post] = member[post];
        prepare(plane, true);
        values.insert(values.end(), plane.values.begin(), plane.values.end());
    }
    void prepare(PreparedPlane& plane, bool may_blend) const {
        if (!may_blend) return;
        fill_gaps(plane, recipe_.prepare.fill_cells, recipe_.prepare.fill_uncertainty);
        smooth(plane, recipe_.prepare.smooth_cells);
    }

    const LayerRecipe& recipe_;
    const std::string folder_, file_;
    const PlaneChoice choice_;
    GridPlaces places_;
    GridWindow window_;
    GridAxes axes_;
    std::vector<std::size_t> order_;  ///< levels of the file by height
    std::vector<std::size_t> kept_;   ///< members that the scene keeps
    std::size_t members_ = 0;         ///< that there are; known where some are kept
    LayerDraft layer_;
    std::vector<std::string> notes_;
};

}  // namespace

GridLayer make_grid_layer(const LayerRecipe& recipe, const std::string& folder) { return GridLayerMaker(recipe, folder).make(); }

}  // namespace tedavis::host_sim
