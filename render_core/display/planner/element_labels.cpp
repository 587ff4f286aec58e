#include "render_core/display/planner/element_labels.hpp"

#include <algorithm>

#include "render_core/draw/data/billboard_place.hpp"
#include "render_core/draw/data/ghost_signs.hpp"
#include "render_core/draw/data/layer_foci.hpp"
#include "render_core/flight/decision_interval.hpp"

namespace tedavis::display {

using draw::BillboardFate;
using draw::Label;
using draw::LabelLevel;

namespace {

draw::Rect screen_of(const terrain::View& view) {
    return {0, 0, static_cast<float>(view.width), static_cast<float>(view.height)};
}

/// As it was decided, where it stands now.
draw::Rect room_of(const Label& label, const draw::BillboardShape& shape) {
    return label.level == LabelLevel::name ? shape.box.raised(label.stem, shape.text_px).with(label.side)
                                           : shape.box.with(draw::SignSide::none);
}

}  // namespace

bool has_labels(const design::DataElement& element, const scene::Layer& layer) {
    return element.technique == design::DataTechnique::billboard && element.own == design::OwnData::none &&
           layer.entry->role != scene::LayerRole::traffic && !draw::shows_ghosts(layer) &&
           layer.entry->shape != scene::LayerShape::grid;
}

bool is_meant(const design::DataElement& element, const scene::Layer& layer) {
    return element.layer.view().empty() ? layer.entry->role == element.role : element.layer.view() == layer.entry->name;
}

bool is_valid_at(const scene::Layer& layer, const flight::FlightTime& time) {
    const scene::LayerEntry& entry = *layer.entry;
    return !time.is_date || (time.utc.ns >= entry.valid_from_ns && time.utc.ns <= entry.valid_until_ns);
}

/// Of the groups' features, in the view of an interval.
class ElementLabels::Shapes final : public draw::LabelShapes {
public:
    Shapes(const ElementLabels& labels, const LabelFrame& frame)
        : labels_(labels), frame_(frame), view_{frame.view, static_cast<float>(frame.text_px)} {
        for (const Group& group : labels.groups_)
            static_cast<void>(foci_.try_push_back({frame.foci, *group.layer, frame.time.utc.ns, frame.time.is_date}));
    }

    [[nodiscard]] draw::ElementInput input(std::uint32_t group) const {
        const Group& of = labels_.groups_[group];
        draw::ElementInput input{*of.element,
                                 static_cast<std::uint8_t>(group),
                                 *of.layer,
                                 frame_.ground,
                                 frame_.missing,
                                 frame_.time.utc.ns,
                                 frame_.time.is_date,
                                 frame_.view.eye,
                                 0,
                                 frame_.time.is_confirmed,
                                 &foci_[group]};
        input.units = frame_.units;
        return input;
    }
    [[nodiscard]] draw::LabelShape shape(draw::LabelKey key) override {
        return draw::label_shape(input(draw::group_of(key)), draw::feature_of(key), view_);
    }
    [[nodiscard]] const draw::SignView& view() const { return view_; }

private:
    const ElementLabels& labels_;
    const LabelFrame& frame_;
    draw::SignView view_;
    base::FixedVector<draw::LayerFoci, draw::kMaxLabelGroups> foci_;
};

void ElementLabels::set(const scene::Scene* scene, const design::DataElementList& elements, const design::LabelSettings& settings,
                        std::size_t design) {
    settings_ = settings;
    if (design != design_) planner_.rest();
    design_ = design;
    groups_.clear();
    obstacle_rooms_.clear();
    if (scene == nullptr) return;
    for (const design::DataElement& element : elements)
        for (const scene::Layer& layer : scene->layers())
            if (is_meant(element, layer) && has_labels(element, layer))
                static_cast<void>(groups_.try_push_back({&element, &layer, 0}));
}

bool ElementLabels::is_any(const scene::Scene& scene, const design::DataElementList& elements) {
    for (const design::DataElement& element : elements)
        for (const scene::Layer& layer : scene.layers())
            if (is_meant(element, layer) && has_labels(element, layer)) return true;
    return false;
}

/// Returns true where the same instant is seen from another viewpoint: earlier labels then have no meaning.
bool ElementLabels::has_leapt(const LabelFrame& frame) {
    const bool is_same = last_eye_ == frame.view.eye && last_forward_ == frame.view.forward;
    const bool leapt = frame.now == last_now_ && !is_same;
    last_now_ = frame.now;
    last_eye_ = frame.view.eye;
    last_forward_ = frame.view.forward;
    return leapt;
}

void ElementLabels::decide(const LabelFrame& frame) {
    const bool leaps = has_leapt(frame);
    if (leaps) planner_.forget();
    if (decided_for_ != design_) decide_anew(frame);
    const std::int64_t interval = flight::decision_interval_of(frame.now);
    if (!planner_.is_due(interval)) return;
    view_ = frame.view;
    time_ = frame.time;
    interval_now_ = frame.now;
    text_px_ = frame.text_px;
    decide_interval(frame, interval);
}

/// In an interval without labels there is nothing to decide.
void ElementLabels::decide_anew(const LabelFrame& frame) {
    decided_for_ = design_;
    if (!planner_.is_decided()) return;
    planner_.forget();
    decide_interval({frame.ground, view_, frame.missing, time_, interval_now_, text_px_},
                    flight::decision_interval_of(interval_now_));
}

void ElementLabels::decide_interval(const LabelFrame& frame, std::int64_t interval) {
    decided_for_ = design_;
    planner_.begin({interval, screen_of(frame.view), static_cast<float>(frame.text_px)}, settings_);
    Shapes shapes(*this, frame);
    for (std::uint32_t n = 0; n < groups_.size(); ++n) {
        const draw::ElementInput input = shapes.input(n);
        static_cast<void>(planner_.add_group(draw::label_group(input)));
        if (is_valid_at(input.layer, frame.time)) draw::offer_features(input, n, shapes.view(), settings_, planner_);
    }
    planner_.settle(shapes);
}

void LabelHistory::take_interval(const LabelHistory& decided) {
    LabelHistory next = decided;
    next.labels.keep_looks(labels);
    next.last_now = last_now;
    next.last_eye = last_eye;
    next.last_forward = last_forward;
    *this = next;
}

void ElementLabels::keep(LabelHistory& memory) const {
    planner_.keep(memory.labels);
    memory.view = view_;
    memory.time = time_;
    memory.now = interval_now_;
    memory.text_px = text_px_;
    memory.design = decided_for_;
    memory.last_now = last_now_;
    memory.last_eye = last_eye_;
    memory.last_forward = last_forward_;
}

void ElementLabels::restore(const LabelHistory& memory) {
    planner_.restore(memory.labels);
    view_ = memory.view;
    time_ = memory.time;
    interval_now_ = memory.now;
    text_px_ = memory.text_px;
    decided_for_ = memory.design;
    last_now_ = memory.last_now;
    last_eye_ = memory.last_eye;
    last_forward_ = memory.last_forward;
}

void ElementLabels::skip(base::Time now) {
    last_now_ = now;
    last_forward_ = glm::dvec3(0);
    const std::int64_t interval = flight::decision_interval_of(now);
    if (!planner_.is_due(interval)) return;
    planner_.skip(interval);
    decided_for_ = design_;
}

std::size_t ElementLabels::group_of(const design::DataElement& element, const scene::Layer& layer) const {
    std::size_t n = 0;
    while (n < groups_.size() && (groups_[n].element != &element || groups_[n].layer != &layer)) ++n;
    return n;
}

std::uint32_t ElementLabels::drawn(const design::DataElement& element, const scene::Layer& layer) const {
    const std::size_t group = group_of(element, layer);
    return group < groups_.size() ? groups_[group].drawn : 0;
}

const draw::Rect* ElementLabels::obstacle_room(const scene::Layer& layer, std::uint32_t feature) const {
    for (const ObstacleRoom& one : obstacle_rooms_)
        if (one.layer == &layer && one.feature == feature) return &one.room;
    return nullptr;
}

std::uint32_t ElementLabels::suppressed(const design::DataElement& element, const scene::Layer& layer) const {
    return planner_.suppressed(static_cast<std::uint32_t>(group_of(element, layer)));
}

ElementLabels::Pass::Pass(ElementLabels& labels, draw::BillboardSheet& sheet, Inputs& inputs, const policy::Declutter* declutter)
    : labels_(labels),
      sheet_(sheet),
      inputs_(inputs),
      declutter_(declutter),
      markers_(screen_of(sheet.view())),
      left_(screen_of(sheet.view())) {
    for (Group& group : labels.groups_) group.drawn = 0;
    labels.obstacle_rooms_.clear();
}

bool ElementLabels::Pass::is_left(const draw::Rect& box) const {
    const draw::Rect room = draw::LabelPlanner::with_margin(box, sheet_.text_px());
    return !left_.is_free(room) && sheet_.is_free(box) && sheet_.is_clear_of_signs(room);
}

/// Returns true where a name has its room, or finds better room that is left.
bool ElementLabels::Pass::find_left_room(const Label& label, const draw::BillboardShape& shape, const scene::Layer& layer,
                                         draw::BillboardWish& wish) const {
    for (wish.stem = 0; wish.stem < draw::sign_stems(layer); ++wish.stem)
        for (const draw::SignSide side : draw::kNameSides) {
            wish.side = side;
            const bool is_decided = label.level == LabelLevel::name && label.side == side && label.stem == wish.stem;
            if (is_decided || is_left(shape.box.raised(wish.stem, shape.text_px).with(side))) return true;
        }
    return false;
}

/// The region follows from the view of the interval, so that a label on the border of two regions does not come and go with every
/// frame.
LabelLevel ElementLabels::Pass::most_of(const Label& label, const draw::ElementInput& input) const {
    const LabelLevel most = std::max(label.level, label.wanted);
    const scene::DetailRegions* const regions =
        declutter_ == nullptr ? nullptr
                              : declutter_->regions_of(input.element, input.layer.entry->role, draw::is_protected(input.layer));
    if (regions == nullptr) return most;
    const draw::SignView view{labels_.view_, sheet_.text_px()};
    return std::min(most, draw::level_left(input, draw::feature_of(label.key), view, labels_.settings_, *regions));
}

void ElementLabels::Pass::add(std::size_t n) {
    const Label& label = labels_.planner_.labels()[n];
    Group& group = group_of(label);
    const draw::ElementInput* const input = inputs_.input(*group.element, *group.layer);
    if (input == nullptr || std::max(label.level, label.wanted) == LabelLevel::none) return;
    const LabelLevel most = most_of(label, *input);
    decluttered_ += most < label.level ? 1 : 0;
    if (most != LabelLevel::none) add(n, *input, most);
}

/// What stands may show more than at its level: it may have had to wait until others went.
void ElementLabels::Pass::add(std::size_t n, const draw::ElementInput& input, LabelLevel most) {
    const Label& label = labels_.planner_.labels()[n];
    const std::uint32_t feature = draw::feature_of(label.key);
    draw::BillboardShape shape;
    if (!draw::billboard_shape(input, feature, sheet_.eye(), most == LabelLevel::name, shape)) return;
    const draw::Rect decided = room_of(label, shape);
    draw::BillboardWish wish{label.side, label.stem, n < protected_ ? &markers_ : nullptr, n};
    LabelLevel level = std::min(label.level, most);
    if (!left_.is_empty() && most == LabelLevel::name && label.wanted == LabelLevel::name &&
        find_left_room(label, shape, input.layer, wish))
        level = LabelLevel::name;
    if (level == LabelLevel::none && is_left(shape.box.with(draw::SignSide::none))) level = LabelLevel::marker;
    if (level == LabelLevel::none) return;
    if (level < most && !draw::billboard_shape(input, feature, sheet_.eye(), false, shape)) return;
    const bool is_covered = sheet_.is_clear_of_signs(decided) && !sheet_.is_free(decided);
    const draw::BillboardAnswer answer = draw::add_billboard(sheet_, input, feature, shape, wish);
    if (label.is_seen && (is_covered || answer.fate == BillboardFate::hidden)) left_.take(decided);
    if (answer.fate != BillboardFate::stands) return;
    ++group_of(label).drawn;
    if (input.layer.entry->role == scene::LayerRole::obstacle)
        static_cast<void>(labels_.obstacle_rooms_.try_push_back({&input.layer, feature, answer.room}));
    standing_[n] = {answer.look(), level == LabelLevel::name && answer.side != draw::SignSide::none};
}

/// Adds nothing where the layer is not shown.
draw::Rect ElementLabels::Pass::marker_room(std::size_t n) {
    const Label& label = labels_.planner_.labels()[n];
    const Group& group = group_of(label);
    const draw::ElementInput* const input = inputs_.input(*group.element, *group.layer);
    draw::BillboardShape shape;
    const bool is_shown =
        input != nullptr && draw::billboard_shape(*input, draw::feature_of(label.key), sheet_.eye(), false, shape);
    return is_shown ? shape.box.with(draw::SignSide::none) : draw::Rect{};
}

void ElementLabels::Pass::add_protected() {
    const base::Span<const Label> labels = labels_.planner_.labels();
    for (; protected_ < labels.size() && draw::is_protected(*group_of(labels[protected_]).layer); ++protected_)
        markers_.take(marker_room(protected_));
    for (std::size_t n = 0; n < protected_; ++n) add(n);
}

/// Displaced labels come last: they must not take the room of labels that stand where they were placed.
void ElementLabels::Pass::add_others() {
    const base::Span<const Label> labels = labels_.planner_.labels();
    for (const bool was_decluttered : {false, true})
        for (std::size_t n = protected_; n < labels.size(); ++n)
            if ((labels[n].level < labels[n].wanted) == was_decluttered) add(n);
}

LabelCounts ElementLabels::Pass::count() {
    draw::LabelPlanner& planner = labels_.planner_;
    LabelCounts counts;
    counts.decluttered = decluttered_;
    counts.changed = planner.take_gone();
    std::uint32_t expected = 0, shown = 0;
    for (std::uint32_t n = 0; n < labels_.groups_.size(); ++n) expected += planner.suppressed(n);
    for (std::size_t n = 0; n < planner.labels().size(); ++n) {
        const Label& label = planner.labels()[n];
        if (planner.note(n, standing_[n].look)) ++counts.changed;
        counts.placed += standing_[n].is_named ? 1 : 0;
        expected += label.is_seen && label.level == LabelLevel::name ? 1 : 0;
        shown += label.is_seen && standing_[n].is_named ? 1 : 0;
    }
    counts.suppressed = expected > shown ? expected - shown : 0;
    return counts;
}

}  // namespace tedavis::display
