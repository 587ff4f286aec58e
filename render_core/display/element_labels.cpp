#include "render_core/display/element_labels.hpp"

#include <glm/geometric.hpp>

#include "render_core/draw/data/placement.hpp"

namespace tedavis::display {

using draw::BillboardFate;
using draw::Label;
using draw::LabelLevel;

bool has_labels(const design::DataElement& element, const scene::Layer& layer) {
    return element.technique == design::DataTechnique::billboard && element.own == design::OwnData::none &&
           layer.entry->role != scene::LayerRole::traffic && layer.entry->shape != scene::LayerShape::grid;
}

bool is_meant(const design::DataElement& element, const scene::Layer& layer) {
    return element.layer.view().empty() ? layer.entry->role == element.role : element.layer.view() == layer.entry->name;
}

bool is_valid_at(const scene::Layer& layer, const flight::FlightTime& time) {
    const scene::LayerEntry& entry = *layer.entry;
    return !time.is_date || (time.utc.ns >= entry.valid_from_ns && time.utc.ns <= entry.valid_until_ns);
}

/// Of the groups' features, in the view of an epoch.
class ElementLabels::Shapes final : public draw::LabelShapes {
public:
    Shapes(const ElementLabels& labels, const LabelFrame& frame)
        : labels_(labels), frame_(frame), view_{frame.view, static_cast<float>(frame.text_px)} {}

    [[nodiscard]] draw::ElementInput input(std::uint32_t group) const {
        const Group& of = labels_.groups_[group];
        return {*of.element,
                static_cast<std::uint8_t>(group),
                *of.layer,
                frame_.ground,
                frame_.missing,
                frame_.time.utc.ns,
                frame_.time.is_date,
                frame_.view.eye,
                0,
                frame_.time.is_confirmed};
    }
    [[nodiscard]] draw::LabelShape shape(draw::LabelKey key) override {
        return draw::label_shape(input(draw::group_of(key)), draw::feature_of(key), view_);
    }
    [[nodiscard]] const draw::SignView& view() const { return view_; }

private:
    const ElementLabels& labels_;
    const LabelFrame& frame_;
    draw::SignView view_;
};

void ElementLabels::set(const scene::Scene* scene, const design::DataElementList& elements,
                        const design::LabelSettings& settings) {
    settings_ = settings;
    groups_.clear();
    planner_.forget();
    planner_.rest();
    if (scene == nullptr) return;
    for (const design::DataElement& element : elements)
        for (const scene::Layer& layer : scene->layers())
            if (is_meant(element, layer) && has_labels(element, layer))
                static_cast<void>(groups_.try_push_back({&element, &layer, 0}));
}

/// The same instant seen from elsewhere: nobody flies there, and what stood has no meaning.
bool ElementLabels::has_leapt(const LabelFrame& frame) {
    const bool is_same = last_eye_ == frame.view.eye && last_forward_ == frame.view.forward;
    const bool leapt = frame.now == last_now_ && !is_same;
    last_now_ = frame.now;
    last_eye_ = frame.view.eye;
    last_forward_ = frame.view.forward;
    return leapt;
}

void ElementLabels::decide(const LabelFrame& frame) {
    if (has_leapt(frame)) planner_.forget();
    const std::int64_t epoch = draw::LabelPlanner::epoch_of(frame.now);
    if (!planner_.is_due(epoch)) return;
    const draw::Rect screen{0, 0, static_cast<float>(frame.view.width), static_cast<float>(frame.view.height)};
    planner_.begin({epoch, screen, static_cast<float>(frame.text_px)}, settings_);
    Shapes shapes(*this, frame);
    for (std::uint32_t n = 0; n < groups_.size(); ++n) {
        const draw::ElementInput input = shapes.input(n);
        static_cast<void>(planner_.add_group(draw::label_group(input)));
        if (is_valid_at(input.layer, frame.time)) draw::offer_features(input, n, shapes.view(), settings_, planner_);
    }
    planner_.settle(shapes);
}

void ElementLabels::restore(const draw::LabelMemory& memory) { planner_.restore(memory); }

/// Or what took it is not there to be seen.
bool ElementLabels::has_its_room(const Label& label) const {
    return label.level == label.wanted ||
           (label.blocker != Label::kNobody && answers_[label.blocker].fate == BillboardFate::hidden);
}

void ElementLabels::add(draw::BillboardSheet& sheet, Inputs& inputs, std::size_t n) {
    if (answers_[n].fate == BillboardFate::stands) return;
    const Label& label = planner_.labels()[n];
    const LabelLevel level = has_its_room(label) ? label.wanted : label.level;
    Group& group = groups_[draw::group_of(label.key)];
    const draw::ElementInput* const input = inputs.input(*group.element, *group.layer);
    if (level == LabelLevel::none || input == nullptr) return;
    answers_[n] =
        draw::add_billboard(sheet, *input, draw::feature_of(label.key), {level == LabelLevel::name, label.side, label.stem});
    if (answers_[n].fate == BillboardFate::stands) ++group.drawn;
}

void ElementLabels::add_protected(draw::BillboardSheet& sheet, Inputs& inputs) {
    answers_ = {};
    for (Group& group : groups_) group.drawn = 0;
    for (std::size_t n = 0; n < planner_.labels().size(); ++n)
        if (draw::is_protected(*groups_[draw::group_of(planner_.labels()[n].key)].layer)) add(sheet, inputs, n);
}

/// Those that gave way to what is hidden come last: they must not take the room of what stands where it was placed.
void ElementLabels::add_others(draw::BillboardSheet& sheet, Inputs& inputs) {
    for (const bool gave_way : {false, true})
        for (std::size_t n = 0; n < planner_.labels().size(); ++n) {
            const Label& label = planner_.labels()[n];
            if (draw::is_protected(*groups_[draw::group_of(label.key)].layer)) continue;
            if ((label.level != label.wanted && has_its_room(label)) == gave_way) add(sheet, inputs, n);
        }
}

LabelCounts ElementLabels::count() {
    LabelCounts counts;
    counts.changed = planner_.take_gone();
    std::uint32_t expected = 0, shown = 0;
    for (std::uint32_t n = 0; n < groups_.size(); ++n) expected += planner_.suppressed(n);
    for (std::size_t n = 0; n < planner_.labels().size(); ++n) {
        const Label& label = planner_.labels()[n];
        const bool is_named = answers_[n].fate == BillboardFate::stands && answers_[n].side != draw::SignSide::none;
        if (planner_.note(n, answers_[n].look())) ++counts.changed;
        counts.placed += is_named ? 1 : 0;
        expected += label.is_seen && label.level == LabelLevel::name ? 1 : 0;
        shown += label.is_seen && is_named ? 1 : 0;
    }
    counts.suppressed = expected > shown ? expected - shown : 0;
    return counts;
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

std::uint32_t ElementLabels::suppressed(const design::DataElement& element, const scene::Layer& layer) const {
    return planner_.suppressed(static_cast<std::uint32_t>(group_of(element, layer)));
}

}  // namespace tedavis::display
