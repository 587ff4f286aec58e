/// Labels: the icons and names of all data elements. They are decided together at intervals of the source's time
/// (label_planner.hpp), and added to the sheet of every frame where they have room and are visible.
///
///   start(arena) · set(...) when scene or design has changed · decide(frame) each frame, and at every interval that a replay
///   passes over · a Pass onto the frame's sheet
///
/// The decision of an interval depends on scene, design and view at the interval's first instant, and on the previous interval.
/// It does not depend on the frames between, the drawn terrain or the symbology; these affect single frames only. A label that
/// the symbology would cover moves to another side, a label that terrain hides is not drawn, and other labels may use their
/// space. A label that is removed to meet the clutter budget leaves its space empty. After a design transition the interval is
/// decided again for the new design, for the view at its first instant, without the previous interval and without foci.
///
/// Where there are foci, features inside them have marker and name, features in the intermediate context have their marker, and
/// the others keep what the design states. Foci do not change the labels of features that warn.
///
/// Memory  from an arena, once. Thread  the display's.
#pragma once

#include "render_core/design/data_element.hpp"
#include "render_core/display/planner/element_report.hpp"
#include "render_core/draw/data/billboards.hpp"
#include "render_core/draw/data/label_features.hpp"
#include "render_core/flight/flight_time.hpp"
#include "render_core/policy/declutter.hpp"

namespace tedavis::display {

/// The counts of a frame; only names are placed and suppressed.
struct LabelCounts {
    std::uint32_t placed = 0;
    std::uint32_t suppressed = 0;   ///< in the picture, but not shown: of too little interest, no room, behind terrain
    std::uint32_t changed = 0;      ///< signs that came, went, or got another look, since the frame before
    std::uint32_t decluttered = 0;  ///< signs that show less than was decided, so that the clutter budget holds
};

struct LabelFrame {
    scene::Ground& ground;
    const terrain::View& view;
    design::Color missing;
    flight::FlightTime time;  ///< the time at which data must be valid
    base::Time now;           ///< the source's
    double text_px = 16;
    const draw::FrameFoci* foci = nullptr;  ///< null: there are none
    base::DisplayUnits units = base::DisplayUnits::feet_and_knots;
};

/// Whether the technique gives a layer's features icons and names.
[[nodiscard]] bool has_labels(const design::DataElement& element, const scene::Layer& layer);
/// Whether an element names the layer, by the layer's name or role.
[[nodiscard]] bool is_meant(const design::DataElement& element, const scene::Layer& layer);
/// Returns false where the layer's data are out of date, and true where the time is unknown.
[[nodiscard]] bool is_valid_at(const scene::Layer& layer, const flight::FlightTime& time);

/// The state that one frame passes to the next one, also across a design transition. Plain data.
struct LabelHistory {
    draw::LabelMemory labels;
    terrain::View view;  ///< at the interval's first instant, with what follows
    flight::FlightTime time;
    base::Time now{0};
    double text_px = 16;
    std::size_t design = 0;
    base::Time last_now{0};
    glm::dvec3 last_eye{0}, last_forward{0};

    /// To be called when the elements or the scene have changed: the next frame places all labels at once.
    void forget() { labels = {}; }
    /// Takes over what was decided for an interval; the memory of what the last frame showed is kept.
    void take_interval(const LabelHistory& decided);
};

class ElementLabels {
public:
    [[nodiscard]] bool start(base::Arena& arena) { return planner_.start(arena); }
    /// All references must stay valid. `design`: a number for each of the display's designs. When it changes, decide() decides
    /// the labels again.
    void set(const scene::Scene* scene, const design::DataElementList& elements, const design::LabelSettings& settings,
             std::size_t design = 0);
    /// Whether an element of the scene has labels.
    [[nodiscard]] static bool is_any(const scene::Scene& scene, const design::DataElementList& elements);

    void decide(const LabelFrame& frame);
    /// Replaces decide() in a frame that shows no terrain: there are no labels until the next interval.
    void skip(base::Time now);
    /// Returns the number of labels of an element's layer that the interval leaves out.
    [[nodiscard]] std::uint32_t suppressed(const design::DataElement& element, const scene::Layer& layer) const;
    void keep(LabelHistory& memory) const;
    void restore(const LabelHistory& memory);

    /// Port: returns how the frame shows an element's layer, or null where it does not.
    class Inputs {
    public:
        virtual ~Inputs() = default;
        [[nodiscard]] virtual const draw::ElementInput* input(const design::DataElement& element, const scene::Layer& layer) = 0;

    protected:
        Inputs() = default;
        Inputs(const Inputs&) = default;
        Inputs& operator=(const Inputs&) = default;
    };
    class Pass;
    /// Replaces a Pass in a frame without signs.
    void rest() {
        planner_.rest();
        obstacle_rooms_.clear();
    }
    /// Returns the number of signs that the last pass added for an element's layer.
    [[nodiscard]] std::uint32_t drawn(const design::DataElement& element, const scene::Layer& layer) const;
    /// Returns the box that the last pass gave the sign of an obstacle; null where it has none, and for signs beyond
    /// kMaxObstacleRooms.
    [[nodiscard]] const draw::Rect* obstacle_room(const scene::Layer& layer, std::uint32_t feature) const;
    static constexpr std::size_t kMaxObstacleRooms = 64;

private:
    struct ObstacleRoom {
        const scene::Layer* layer;
        std::uint32_t feature;
        draw::Rect room;
    };
    struct Group {
        const design::DataElement* element;
        const scene::Layer* layer;
        std::uint32_t drawn;
    };
    class Shapes;
    [[nodiscard]] std::size_t group_of(const design::DataElement& element, const scene::Layer& layer) const;
    [[nodiscard]] bool has_leapt(const LabelFrame& frame);
    void decide_interval(const LabelFrame& frame, std::int64_t interval);
    void decide_anew(const LabelFrame& frame);

    draw::LabelPlanner planner_;
    design::LabelSettings settings_;
    base::FixedVector<Group, draw::kMaxLabelGroups> groups_;
    base::FixedVector<ObstacleRoom, kMaxObstacleRooms> obstacle_rooms_;  ///< of the last pass
    std::size_t design_ = 0, decided_for_ = 0;
    terrain::View view_;  ///< of the interval that was decided last, with what follows
    flight::FlightTime time_;
    base::Time interval_now_{0};
    double text_px_ = 16;
    base::Time last_now_{0};
    glm::dvec3 last_eye_{0}, last_forward_{0};
};

/// Adds the labels of a frame to a sheet that has begun. Labels that have lost their place may use the room of others that
/// terrain hides or the symbology covers in this frame.
class ElementLabels::Pass {
public:
    /// All references must outlive the pass. `declutter`: null: nothing is reduced.
    Pass(ElementLabels& labels, draw::BillboardSheet& sheet, Inputs& inputs, const policy::Declutter* declutter);
    /// add_protected() adds the labels of features that warn, before all other signs; add_others() adds the others in the room
    /// that is left.
    void add_protected();
    void add_others();
    /// Returns the counts of the frame; to be called once, since the next frame is compared with this one.
    [[nodiscard]] LabelCounts count();

private:
    struct Standing {
        std::uint8_t look = 0;  ///< BillboardAnswer::look()
        bool is_named = false;
    };
    [[nodiscard]] Group& group_of(const draw::Label& label) { return labels_.groups_[draw::group_of(label.key)]; }
    [[nodiscard]] bool is_left(const draw::Rect& box) const;
    [[nodiscard]] bool find_left_room(const draw::Label& label, const draw::BillboardShape& shape, const scene::Layer& layer,
                                      draw::BillboardWish& wish) const;
    [[nodiscard]] draw::Rect marker_room(std::size_t label);
    [[nodiscard]] draw::LabelLevel most_of(const draw::Label& label, const draw::ElementInput& input) const;
    void add(std::size_t label);
    void add(std::size_t label, const draw::ElementInput& input, draw::LabelLevel most);

    ElementLabels& labels_;
    draw::BillboardSheet& sheet_;
    Inputs& inputs_;
    const policy::Declutter* declutter_;
    std::uint32_t decluttered_ = 0;
    std::size_t protected_ = 0;  ///< labels, which come first
    draw::LabelRoom markers_;    ///< of them: their names leave it free
    draw::LabelRoom left_;       ///< decided for labels that do not stand there in this frame
    std::array<Standing, draw::LabelPlanner::kMax> standing_{};
};

}  // namespace tedavis::display
