#include "host_sim/evaluation/picture_orderings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host_sim/evaluation/read_canny.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/config_reader.hpp"
#include "render_core/display/picture_layer.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::string_view kShareOf = "share.";
constexpr const char* kStateNames[] = {"holds", "differs", "missing"};

std::string measure_name(const PictureOrdering& ordering) {
    return ordering.layer.empty() ? "clutter" : std::string(kShareOf) + ordering.layer;
}

/// Empty for the clutter.
std::string read_measure(base::ConfigSection& section) {
    const std::string measure(section.text("measure"));
    if (measure == "clutter") return {};
    std::string layer = measure.substr(0, kShareOf.size()) == kShareOf ? measure.substr(kShareOf.size()) : std::string();
    const auto& layers = display::kPictureLayerNames;
    if (std::find(layers.begin(), layers.end(), layer) == layers.end())
        section.fault("measure",
                      "'measure' must be clutter, or share. and a layer: terrain, data, uncertainty, labels, symbology");
    return layer;
}

PictureOrdering read_ordering(base::ConfigSection section) {
    PictureOrdering ordering;
    ordering.title = section.text("title");
    ordering.source = section.text("source", "");
    ordering.layer = read_measure(section);
    ordering.more = section.text("more");
    ordering.less = section.text("less");
    if (section.has("thesis")) {
        ordering.reported.emplace();
        section.numbers("thesis", 0, 1, {ordering.reported->data(), 2});
    }
    if (section.has("alike_within")) ordering.alike_within = section.number("alike_within", 0, 1);
    return ordering;
}

/// A whole number of the path's parts at its end.
bool is_end_of(const std::string& end, const std::string& path) {
    if (path.size() < end.size() || path.compare(path.size() - end.size(), end.size(), end) != 0) return false;
    return path.size() == end.size() || path[path.size() - end.size() - 1] == '/';
}

std::optional<double> measured(const PictureOrdering& ordering, const std::string& name,
                               const std::vector<OrderedPicture>& pictures) {
    for (const OrderedPicture& picture : pictures) {
        if (!is_end_of(name, picture.file)) continue;
        if (ordering.layer.empty()) return picture.clutter;
        for (const auto& [layer, share] : picture.shares)
            if (layer == ordering.layer) return share;
    }
    return std::nullopt;
}

bool holds(const PictureOrdering& ordering, double more, double less) {
    return ordering.alike_within ? std::fabs(more - less) <= *ordering.alike_within : more > less;
}

}  // namespace

PictureOrderings read_orderings(const std::string& path) {
    const std::string text = read_file(path);
    base::ConfigReader reader(text, path);
    base::ConfigSection root = reader.root();
    PictureOrderings orderings;
    orderings.title = root.text("title", "");
    orderings.canny = read_canny(root);
    const std::size_t count = root.table_count("ordering");
    for (std::size_t n = 0; n < count; ++n) orderings.orderings.push_back(read_ordering(root.table_at("ordering", n)));
    if (!reader.finish()) throw UserError(std::string(reader.error().message.view()));
    if (orderings.orderings.empty()) throw UserError(path + ": has no [[ordering]]; state one");
    return orderings;
}

std::vector<JudgedOrdering> judged(const PictureOrderings& orderings, const std::vector<OrderedPicture>& pictures) {
    std::vector<JudgedOrdering> all;
    for (const PictureOrdering& ordering : orderings.orderings) {
        JudgedOrdering one{ordering};
        const std::optional<double> more = measured(ordering, ordering.more, pictures),
                                    less = measured(ordering, ordering.less, pictures);
        if (more && less) {
            one.more = *more;
            one.less = *less;
            one.state = holds(ordering, *more, *less) ? OrderingState::holds : OrderingState::differs;
        }
        all.push_back(std::move(one));
    }
    return all;
}

std::string orderings_text(const std::vector<JudgedOrdering>& judged) {
    std::string text = "  thesis         ours           \n";
    for (const JudgedOrdering& one : judged) {
        char line[96];
        const auto& reported = one.ordering.reported;
        if (reported)
            std::snprintf(line, sizeof line, "  %.2f -> %.2f   ", (*reported)[0], (*reported)[1]);
        else
            std::snprintf(line, sizeof line, "  more -> less   ");
        text += line;
        if (one.state == OrderingState::missing)
            std::snprintf(line, sizeof line, "not measured     ");
        else
            std::snprintf(line, sizeof line, "%.3f -> %.3f   ", one.more, one.less);
        text += std::string(line) + (one.state == OrderingState::missing ? "" : kStateNames[static_cast<std::size_t>(one.state)]);
        text +=
            (one.state == OrderingState::holds ? "    " : "  ") + one.ordering.title + " (" + measure_name(one.ordering) + ")\n";
    }
    text.pop_back();
    return text;
}

nlohmann::ordered_json orderings_json(const std::vector<JudgedOrdering>& judged) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const JudgedOrdering& one : judged) {
        nlohmann::ordered_json json = {{"title", one.ordering.title},
                                       {"source", one.ordering.source},
                                       {"measure", measure_name(one.ordering)},
                                       {"more", one.ordering.more},
                                       {"less", one.ordering.less},
                                       {"reported", nullptr},
                                       {"ours", nullptr},
                                       {"state", kStateNames[static_cast<std::size_t>(one.state)]}};
        if (one.ordering.reported) json["reported"] = *one.ordering.reported;
        if (one.state != OrderingState::missing) json["ours"] = {one.more, one.less};
        list.push_back(std::move(json));
    }
    return list;
}

}  // namespace tedavis::host_sim
