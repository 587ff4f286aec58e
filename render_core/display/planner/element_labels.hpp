/// Icons and names of all elements that have them, as one: decided together at intervals of the source's time
/// (label_planner.hpp), and put onto the sheet of every frame where they have room and the eye sees them.
///
///   start(arena) · set(...) when scene or design has changed · decide(frame) each frame, and at every interval that a replay
///   passes over · a Pass onto the frame's sheet
///
/// The decision at an interval follows from scene, design and view at the interval's first instant, and from the interval before;
/// not from the frames between, the drawn terrain or the symbology. Those matter to a frame alone: what the symbology covers goes
/// to another side, what terrain hides is not drawn, and both leave their room to others; what gives way in a crowded region
/// leaves it empty. When another of the display's designs takes its turn the interval is decided anew for that one, as seen at
/// its first instant, without a memory, and without foci.
///
/// Of foci, what lies within has marker and name, what lies in the intermediate context its marker, and the rest what the design
/// leaves of it; what warns has what it has without them.
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

/// Of a frame; labels are names.
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
    flight::FlightTime time;  ///< by which data are valid
    base::Time now;           ///< the source's
    double text_px = 16;
    const draw::FrameFoci* foci = nullptr;  ///< null: there are none
    base::DisplayUnits units = base::DisplayUnits::feet_and_knots;
};

/// Whether the technique gives a layer's features icons and names.
[[nodiscard]] bool has_labels(const design::DataElement& element, const scene::Layer& layer);
/// Whether the layer is meant by an element of the scene, by its name or role.
[[nodiscard]] bool is_meant(const design::DataElement& element, const scene::Layer& layer);
/// False where the layer's data are out of date; true where nobody knows the time.
[[nodiscard]] bool is_valid_at(const scene::Layer& layer, const flight::FlightTime& time);

/// What a frame leaves to the next one, and to a turn of designs. Plain data.
struct LabelHistory {
    draw::LabelMemory labels;
    terrain::View view;  ///< at the interval's first instant, with what follows
    flight::FlightTime time;
    base::Time now{0};
    double text_px = 16;
    std::size_t design = 0;
    base::Time last_now{0};
    glm::dvec3 last_eye{0}, last_forward{0};

    /// What they are has changed, or the scene: the next frame places all at once.
    void forget() { labels = {}; }
    /// Takes over what was decided for an interval; what the last frame showed of it remains.
    void take_interval(const LabelHistory& decided);
};

class ElementLabels {
public:
    [[nodiscard]] bool start(base::Arena& arena) { return planner_.start(arena); }
    /// All must stay. `design`: a number for each of the display's designs. Another one's labels are decided anew by decide().
    void set(const scene::Scene* scene, const design::DataElementList& elements, const design::LabelSettings& settings,
             std::size_t design = 0);
    /// Whether an element of the scene has labels.
    [[nodiscard]] static bool is_any(const scene::Scene& scene, const design::DataElementList& elements);

    void decide(const LabelFrame& frame);
    /// Instead of it in a frame without a place to stand: until the next interval there are none.
    void skip(base::Time now);
    /// Labels of an element's layer that the interval leaves out.
    [[nodiscard]] std::uint32_t suppressed(const design::DataElement& element, const scene::Layer& layer) const;
    void keep(LabelHistory& memory) const;
    void restore(const LabelHistory& memory);

    /// Where an element's layer is shown in the frame: null where it is not.
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
    /// Instead of them in a frame without signs.
    void rest() {
        planner_.rest();
        obstacle_rooms_.clear();
    }
    /// Signs that the last pass added of an element's layer.
    [[nodiscard]] std::uint32_t drawn(const design::DataElement& element, const scene::Layer& layer) const;
    /// The room that the last pass gave the sign of an obstacle; null where it does not stand, and of more than
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

/// The labels of a frame onto a sheet that has begun. Room that was decided for what does not stand there, for terrain hides it
/// or the symbology covers it, is left to those that gave way.
class ElementLabels::Pass {
public:
    /// All must stay. `declutter`: null: nothing gives way.
    Pass(ElementLabels& labels, draw::BillboardSheet& sheet, Inputs& inputs, const policy::Declutter* declutter);
    /// What warns, before all other signs; then, in the room that is left, the others.
    void add_protected();
    void add_others();
    /// Of a frame, once: the next one is compared with it.
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
