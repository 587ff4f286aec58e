/// Which elements of the data aspect a frame shows over the terrain, and their geometry: what the design asks for of the scene's
/// layers; no GL.
///
///   start(...) · set(scene, design) when either has changed · plan(frame) each frame · planned(): what a painter is given
///
/// What a layer says once is built by set() and stands, until foci that change the data move; what moves, the own flight and
/// other aircraft among it, is built by every plan().
///
/// Memory    the budget lines scene_solids, scene_glyphs and scene_billboards. Thread  the display's. Failure  start() gives one
///           message; a layer or attribute that is not there, or no room, hides features, which are counted.
#pragma once

#include "render_core/base/fixed_vector.hpp"
#include "render_core/design/design_settings.hpp"
#include "render_core/display/planner/caster_set.hpp"
#include "render_core/display/planner/element_labels.hpp"
#include "render_core/display/planner/element_report.hpp"
#include "render_core/display/planner/glyph_elements.hpp"
#include "render_core/display/planner/own_flight.hpp"
#include "render_core/display/planner/traffic_layer.hpp"
#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/extended_centerline.hpp"
#include "render_core/draw/data/focus_cues.hpp"
#include "render_core/draw/data/isosurface_solids.hpp"
#include "render_core/draw/data/layer_foci.hpp"
#include "render_core/draw/data/solid_batch.hpp"
#include "render_core/draw/data/solid_mesh.hpp"
#include "render_core/draw/data/trajectory_cues.hpp"
#include "render_core/draw/data/tube_solids.hpp"
#include "render_core/draw/quad_batch.hpp"
#include "render_core/flight/flight_time.hpp"
#include "render_core/policy/declutter.hpp"

namespace tedavis::display {

struct ElementFrame {
    scene::Ground& ground;
    const terrain::View& view;  ///< of the eye
    design::Color missing;
    flight::FlightTime time;
    OwnFlightFrame own{};
    double detail_factor = 1;                        ///< of the detail of glyphs of fields
    const draw::FrameFoci* foci = nullptr;           ///< null: there are none
    const policy::Declutter* declutter = nullptr;    ///< null: nothing gives way
    const policy::ObstacleAlerts* alerts = nullptr;  ///< null: no obstacle is in the way
    base::DisplayUnits units = base::DisplayUnits::feet_and_knots;
};

/// What the planned frame draws.
struct ElementCounters {
    std::uint32_t features = 0, glyphs = 0;
};

/// What signs need besides.
struct SignFrame {
    double text_px = 16;                         ///< of the display's ordinary text
    terrain::LineOfSight* sight = nullptr;       ///< over the drawn terrain; null: nothing stands in the way
    const draw::QuadBatch* symbology = nullptr;  ///< of the frame, which signs keep clear of; null: there is none
    std::uint32_t margin_px = 0;                 ///< of a picture that is wider than the screen, on both sides together
    std::int32_t screen_begins_px = 0;           ///< in such a picture
    bool is_planned_again = false;               ///< of one eye of a pair, or to be measured: labels have been counted
};

/// Room of what stands, and of what moves.
struct SolidRooms {
    draw::SolidRoom standing, moving;
};
[[nodiscard]] SolidRooms solid_rooms(const base::BudgetTable& budget);

/// What a frame draws of the elements. What it refers to stays until the next plan.
struct PlannedElements {
    std::uint32_t shown = 0;         ///< a bit a report: the group of what it draws
    bool has_reports = false;        ///< something is asked for: there is something to upload
    std::uint64_t standing_key = 0;  ///< another one: what stands has been built anew
    flight::FlightTime time;
};

class ElementPlanner {
public:
    struct Memory {
        base::Arena &solids, &glyphs, &billboards;
    };
    /// Only for displays that have a scene, or whose design asks for the own flight or other aircraft. `has_instances`:
    /// draw::GlyphDrawer::has_instances() of the device.
    [[nodiscard]] base::Error start(bool has_instances, const base::BudgetTable& budget, const Memory& memory);
    [[nodiscard]] bool is_started() const { return is_started_; }

    /// What is shown from the next plan() on. Scene (null: there is none) and design must stay. Other aircraft that the own one
    /// receives are a layer beside the scene's. A role of which there is no layer asks for nothing. `design`: its number among
    /// those that the display turns between.
    void set(const scene::Scene* scene, const design::DataElementList& elements,
             const design::LabelSettings& labels = design::LabelSettings(), std::size_t design = 0);
    void plan(const ElementFrame& frame);  ///< without set() there is nothing to show
    /// After plan() of the same frame, and what it makes of the legends: icons, names, diagrams and barbs, in the room that is
    /// left.
    void plan_signs(const ElementFrame& frame, const SignFrame& signs);
    /// What gives way, again, of the planned frame with another declutter; plan_signs() must follow.
    void plan_detail(const ElementFrame& frame);
    /// What plan_signs() does where it has not been done for the frame's interval: also of intervals that a replay passes over
    /// (element_labels.hpp). Of the middle eye.
    void decide_labels(const ElementFrame& frame, double text_px);
    [[nodiscard]] ElementLabels& labels() { return labels_; }
    [[nodiscard]] const ElementLabels& labels() const { return labels_; }
    [[nodiscard]] const LabelCounts& label_counts() const { return label_counts_; }
    /// Instead of them in a frame that shows none of it.
    void rest();
    [[nodiscard]] const ElementReports& reports() const { return reports_; }
    [[nodiscard]] bool has_anything() const { return shown_ != 0; }
    /// From the eye to the nearest and the farthest of what is shown of a role's surfaces; after plan(). False where there is
    /// none.
    [[nodiscard]] bool distances_m(scene::LayerRole role, const glm::dvec3& eye, terrain::DepthSpan& distances_m) const;
    [[nodiscard]] ElementCounters counters() const;
    /// What the record says of the n-th focus over all that is shown; after plan(). None of what may be left as it is.
    [[nodiscard]] draw::FocusCounts count_in_focus(const ElementFrame& frame, std::size_t focus) const;
    /// What became of the cues to hidden foci; after plan_signs().
    [[nodiscard]] const draw::FocusCues& focus_cues() const { return focus_cues_; }

    /// What is shown of these roles and casts shadows; after plan().
    [[nodiscard]] CasterSet casters(const design::CasterRoles& roles) const;

    /// Seen from another eye than the planned one from here on.
    void set_camera(const glm::dvec3& eye) { glyphs_.set_camera(eye); }
    [[nodiscard]] PlannedElements planned() const { return {shown_, !reports_.empty(), standing_key_, time_}; }
    /// What planned() is drawn from.
    [[nodiscard]] const draw::SolidBatch& standing() const { return standing_; }
    [[nodiscard]] const draw::SolidBatch& moving() const { return moving_; }
    [[nodiscard]] const draw::GlyphBatch& glyphs() const { return glyphs_.batch(); }
    [[nodiscard]] const draw::QuadBatch& signs() const { return signs_; }
    [[nodiscard]] const draw::QuadBatch& links() const { return links_; }

private:
    class LabelInputs;
    [[nodiscard]] bool start_scratch(base::Arena& memory, std::uint32_t batch_vertices);
    [[nodiscard]] ElementState state_of(const ElementReport& report) const;
    void begin_reports();
    void receive_traffic(const ElementFrame& frame);
    void begin_report(const design::DataElement& element, const scene::Layer* layer);
    void begin_scene_reports(const design::DataElement& element);
    void plan_own_winds(const ElementFrame& frame);
    void plan_motion_times(const ElementFrame& frame);
    void count_out_of_view(const ElementFrame& frame);
    void take_foci(const ElementFrame& frame);
    void take_alerts(const ElementFrame& frame);
    [[nodiscard]] std::uint16_t layer_number(const scene::Layer& layer) const;
    [[nodiscard]] draw::ElementInput input_of(std::size_t report, const ElementFrame& frame) const;
    void build(draw::SolidBatch& batch, bool moving, const ElementFrame& frame);
    void build_cues(draw::SolidBatch& batch, bool moving, const ElementFrame& frame);
    void plan_billboards(const ElementFrame& frame);
    void plan_glyphs(const ElementFrame& frame, draw::BillboardSheet* sheet);
    void plan_glyphs_of(std::size_t n, const ElementFrame& frame, draw::BillboardSheet* sheet);
    [[nodiscard]] draw::ElementCount build_element(draw::SolidBatch& batch, const draw::ElementInput& input);

    GlyphElements glyphs_;
    draw::QuadBatch signs_, links_;
    draw::BillboardSheet sheet_;
    ElementLabels labels_;
    LabelCounts label_counts_;  ///< of the planned frame
    draw::SolidBatch standing_, moving_;
    draw::SolidMesh mesh_;
    draw::TubeSolids tubes_;
    draw::TrajectoryCues cues_;
    draw::IsosurfaceSolids isosurfaces_;
    OwnFlight own_;
    TrafficLayer traffic_;
    bool receives_traffic_ = false;
    const scene::Scene* scene_ = nullptr;
    const design::DataElementList* elements_ = nullptr;
    ElementReports reports_;
    std::uint32_t shown_ = 0;                              ///< a bit a report: the group of what it draws
    flight::FlightTime time_;                              ///< of the planned frame
    std::array<draw::LayerFoci, kMaxElementGroups> foci_;  ///< of the reports' layers
    draw::FocusCues focus_cues_{};
    std::uint64_t foci_key_ = 0;    ///< of those that what stands was built with; 0: none
    std::uint64_t alerts_key_ = 0;  ///< likewise of the obstacles that are in the way
    bool has_changed_ = false;
    std::uint64_t standing_key_ = 0;
    bool is_started_ = false;
};

}  // namespace tedavis::display
