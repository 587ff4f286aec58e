#include "render_core/design/priority.hpp"

#include "render_core/design/config_values.hpp"

namespace tedavis::design {
namespace {

constexpr std::size_t kRoles = static_cast<std::size_t>(scene::LayerRole::count);

void read_curve(base::ConfigSection& section, std::string_view key, DetailCurve& curve) {
    const std::size_t count = section.element_count(key);
    if (count == 0) return;
    double values[2 * DetailCurve::kMaxKnots];
    if (count % 2 != 0 || count > 2 * DetailCurve::kMaxKnots)
        return fault_of(section, key, "must be 1 to 4 pairs of a weight and a detail, such as [0.3, 0, 0.7, 1]");
    section.numbers(key, 0, 1, {values, count});
    curve.knots.clear();
    for (std::size_t n = 0; n + 1 < count; n += 2) {
        if (n > 0 && !(values[n] > values[n - 2])) return fault_of(section, key, "must have ascending weights");
        static_cast<void>(curve.knots.try_push_back({values[n], values[n + 1]}));
    }
}

std::size_t role_named(std::string_view name) {
    std::size_t role = 0;
    while (role < kRoles && scene::name_of(static_cast<scene::LayerRole>(role)) != name) ++role;
    return role;
}

void refuse_role(base::ConfigSection& section, std::string_view name) {
    base::FixedString<383> message("has '");
    message.append(name);
    message.append("', which is no role of layers; roles are");
    for (std::size_t role = 0; role < kRoles; ++role) {
        message.append(role == 0 ? " " : ", ");
        message.append(scene::name_of(static_cast<scene::LayerRole>(role)));
    }
    fault_of(section, "roles", message.view());
}

void read_roles(base::ConfigSection& section, DataPart& part) {
    std::string_view names[kRoles];
    const std::size_t count = section.texts("roles", names);
    if (count == 0) fault_of(section, "roles", "must name at least one role of layers");
    for (std::size_t n = 0; n < count; ++n) {
        const std::size_t role = role_named(names[n]);
        if (role == kRoles) return refuse_role(section, names[n]);
        part.roles |= 1u << role;
    }
}

void read_part(base::ConfigSection section, PrioritySettings& priority) {
    DataPart part;
    part.name = section.text("name");
    if (part.name.empty() || part.name.cut()) fault_of(section, "name", "must be 1 to 23 characters long");
    for (std::size_t n = 0; n < priority.count(); ++n)
        if (priority.name_of(n) == part.name.view()) fault_of(section, "name", "is taken by another aspect; give it another one");
    read_roles(section, part);
    part.is_hazard = section.boolean("hazard", false);
    const double weight = section.number("weight", 0, 1);
    priority.weights.of[priority.count()] = weight;
    static_cast<void>(priority.parts.try_push_back(part));
}

void read_detail(base::ConfigSection section, PrioritySettings& priority) {
    read_curve(section, "shading", priority.shading);
    read_curve(section, "sketch", priority.sketch);
    read_curve(section, "data", priority.data);
    read_curve(section, "intrinsic", priority.intrinsic);
    read_curve(section, "extrinsic", priority.extrinsic);
}

}  // namespace

double DetailCurve::at(double weight) const noexcept {
    if (knots.empty()) return weight;
    if (weight <= knots[0].weight) return knots[0].detail;
    for (std::size_t n = 1; n < knots.size(); ++n) {
        const Knot &a = knots[n - 1], &b = knots[n];
        if (weight <= b.weight) return a.detail + (b.detail - a.detail) * (weight - a.weight) / (b.weight - a.weight);
    }
    return knots.back().detail;
}

std::size_t PrioritySettings::aspect_of(scene::LayerRole role) const noexcept {
    for (std::size_t n = 0; n < parts.size(); ++n)
        if (parts[n].has(role)) return kMainAspects + n;
    return kDataAspect;
}

bool PrioritySettings::is_first(std::size_t aspect, const AspectWeights& weighed) const noexcept {
    for (std::size_t n = 0; n < count(); ++n)
        if (weighed.of[n] > weighed.of[aspect]) return false;
    return true;
}

std::string_view PrioritySettings::name_of(std::size_t aspect) const {
    return aspect < kMainAspects ? kMainAspectNames[aspect] : parts[aspect - kMainAspects].name.view();
}

void read_priority(base::ConfigSection section, PrioritySettings& priority) {
    priority.is_stated = section.present();
    for (std::size_t n = 0; n < kMainAspects; ++n)
        priority.weights.of[n] = section.number(kMainAspectNames[n], 0, 1, priority.weights.of[n]);
    priority.least_difference = section.number("least_difference", 0, 30, priority.least_difference);
    priority.hazard_weight = section.number("hazard_weight", 0, 1, priority.hazard_weight);
    priority.hazard_ahead_s = section.number("hazard_ahead_s", 10, 600, priority.hazard_ahead_s);
    priority.hazard_within_m = section.number("hazard_within_m", 50, 20'000, priority.hazard_within_m);
    priority.clutter_budget = section.number("clutter_budget", 0, 1, priority.clutter_budget);
    priority.stale_uncertainty = section.number("stale_uncertainty", 0, 1, priority.stale_uncertainty);
    for (std::size_t n = 0; n < section.table_count("aspect"); ++n) {
        if (n == kMaxDataParts) return fault_of(section, "aspect", "has more than 5 parts of the data; remove one");
        read_part(section.table_at("aspect", n), priority);
    }
    read_detail(section.section("detail"), priority);
}

}  // namespace tedavis::design
