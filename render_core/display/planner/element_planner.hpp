/// Plans which data elements of the design a frame shows over the terrain, and builds their geometry from the scene's layers; no
/// GL.
///
///   start(...) · set(scene, design) when either has changed · plan(frame) each frame · planned() for the painter
///
/// Geometry that does not move is built after set(), and again when foci that change the data move. Geometry that moves, such as
/// the own ship's trail and other aircraft, is built by every plan().
///
/// Memory    the budget lines scene_solids, scene_glyphs and scene_billboards. Thread  the display's. Failure  start() gives one
///           message; features whose layer or attribute is missing, or for which there is no room, are hidden and counted.
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
    const policy::Declutter* declutter = nullptr;    ///< null: nothing is reduced
    const policy::ObstacleAlerts* alerts = nullptr;  ///< null: no obstacle is in the way
    base::DisplayUnits units = base::DisplayUnits::feet_and_knots;
};

/// What the planned frame draws.
struct ElementCounters {
    std::uint32_t features = 0, glyphs = 0;
};

/// The additional input for signs.
struct SignFrame {
    double text_px = 16;                         ///< of the display's ordinary text
    terrain::LineOfSight* sight = nullptr;       ///< over the drawn terrain; null: nothing stands in the way
    const draw::QuadBatch* symbology = nullptr;  ///< of the frame, which signs keep clear of; null: there is none
    std::uint32_t margin_px = 0;                 ///< of a picture that is wider than the screen, on both sides together
    std::int32_t screen_begins_px = 0;           ///< in such a picture
    bool is_planned_again = false;               ///< for one eye of a pair, or for a probe: labels have been counted
};

/// The capacities for geometry that does not move, and for geometry that moves.
struct SolidRooms {
    draw::SolidRoom standing, moving;
};
[[nodiscard]] SolidRooms solid_rooms(const base::BudgetTable& budget);

/// What a frame draws of the elements; valid until the next plan.
struct PlannedElements {
    std::uint32_t shown = 0;         ///< a bit a report: the group of what it draws
    bool has_reports = false;        ///< the design requests elements, so there is something to upload
    std::uint64_t standing_key = 0;  ///< changes when geometry that does not move was built again
    flight::FlightTime time;
};

class ElementPlanner {
public:
    struct Memory {
        base::Arena &solids, &glyphs, &billboards;
    };
    /// To be called only for displays that have a scene, or whose design requests the own ship's trail or other aircraft.
    /// `has_instances`: draw::GlyphDrawer::has_instances() of the device.
    [[nodiscard]] base::Error start(bool has_instances, const base::BudgetTable& budget, const Memory& memory);
    [[nodiscard]] bool is_started() const { return is_started_; }

    /// Sets what is shown from the next plan() on. Scene (null: there is none) and design must stay valid. Aircraft that the own
    /// ship receives are a layer in addition to the scene's. An element of a role without a layer shows nothing. `design`: the
    /// index of the design among those of the display.
    void set(const scene::Scene* scene, const design::DataElementList& elements,
             const design::LabelSettings& labels = design::LabelSettings(), std::size_t design = 0);
    void plan(const ElementFrame& frame);  ///< without set() there is nothing to show
    /// Plans icons, names, diagrams and barbs in the room that is left; to be called after plan() and the legends of the same
    /// frame.
    void plan_signs(const ElementFrame& frame, const SignFrame& signs);
    /// Plans the elements that may be reduced again, with another declutter; plan_signs() must follow.
    void plan_detail(const ElementFrame& frame);
    /// Decides the labels of the frame's interval as the middle eye sees it. plan_signs() does so where it has not been done; a
    /// replay also decides the intervals that it passes over (element_labels.hpp).
    void decide_labels(const ElementFrame& frame, double text_px);
    [[nodiscard]] ElementLabels& labels() { return labels_; }
    [[nodiscard]] const ElementLabels& labels() const { return labels_; }
    [[nodiscard]] const LabelCounts& label_counts() const { return label_counts_; }
    /// Replaces plan() and plan_signs() in a frame that shows no elements.
    void rest();
    [[nodiscard]] const ElementReports& reports() const { return reports_; }
    [[nodiscard]] bool has_anything() const { return shown_ != 0; }
    /// Writes the distances from the eye to the nearest and the farthest of a role's shown surfaces; to be called after plan().
    /// Returns false where there are none.
    [[nodiscard]] bool distances_m(scene::LayerRole role, const glm::dvec3& eye, terrain::DepthSpan& distances_m) const;
    [[nodiscard]] ElementCounters counters() const;
    /// Returns the record's counts for a focus, over all elements that are shown; to be called after plan().
    [[nodiscard]] draw::FocusCounts count_in_focus(const ElementFrame& frame, std::size_t focus) const;
    /// Returns the states of the cues to hidden foci; valid after plan_signs().
    [[nodiscard]] const draw::FocusCues& focus_cues() const { return focus_cues_; }

    /// Returns the shown elements of these roles, which cast shadows; to be called after plan().
    [[nodiscard]] CasterSet casters(const design::CasterRoles& roles) const;

    /// Moves the eye point away from the planned one.
    void set_camera(const glm::dvec3& eye) { glyphs_.set_camera(eye); }
    [[nodiscard]] PlannedElements planned() const { return {shown_, !reports_.empty(), standing_key_, time_}; }
    /// The batches from which planned() is drawn.
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
    std::uint64_t foci_key_ = 0;    ///< of the foci with which standing_ was built; 0: none
    std::uint64_t alerts_key_ = 0;  ///< of the obstacles in the way with which it was built
    bool has_changed_ = false;
    std::uint64_t standing_key_ = 0;
    bool is_started_ = false;
};

}  // namespace tedavis::display
