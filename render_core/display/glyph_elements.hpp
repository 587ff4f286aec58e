/// Elements of the data aspect that are glyphs: a field of sites each, and what a view shows of it; no GL.
///
///   start(...) · set(...) an element a slot · plan(frame) each frame · batch() for the painter
///
/// Values at a time are those of the whole minute before it. The next minute's field is made ahead, some sites a frame, so that
/// no frame stalls; a jump in time makes it at once. What is shown never depends on where a run began.
/// The memory for sites is shared out anew when elements are set: who needs little gets it whole, the others share the rest.
/// Memory    the budget line scene_glyphs. Thread  the display's. Failure  start() gives one message; elements beyond the slots
/// are refused.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/design/shadow_settings.hpp"
#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/glyph_batch.hpp"
#include "render_core/draw/data/glyph_encoding.hpp"
#include "render_core/draw/data/glyph_sites.hpp"
#include "render_core/draw/data/layer_foci.hpp"
#include "render_core/scene/glyph_selection.hpp"

namespace tedavis::display {

struct GlyphFrameInput {
    scene::Ground& ground;
    const terrain::View& view;
    design::Color missing;
    std::int64_t time_ns = 0;  ///< of the source where it has a date
    bool has_date = false;
    draw::BillboardSheet* sheet = nullptr;          ///< of the frame, for wind barbs
    double detail_factor = 1;                       ///< of the element's detail
    const draw::LayerFoci* foci = nullptr;          ///< of the element's layer; null: everything is in the focus
    const scene::DetailRegions* regions = nullptr;  ///< of the screen, in which the element gives way
};

[[nodiscard]] bool is_glyph_technique(design::DataTechnique technique) noexcept;
[[nodiscard]] bool is_glyph_uncertainty(design::ElementUncertainty uncertainty) noexcept;
/// Of glyphs of uncertainty: levels 0..1 from sure to unsure, in classes where the design asks for them.
[[nodiscard]] design::DataScale uncertainty_scale(const design::DataElement& element) noexcept;

class GlyphElements {
public:
    static constexpr std::size_t kSlots = 3;

    /// `has_instances`: draw::GlyphDrawer::has_instances() of the device. The arena keeps the drawer's share free.
    [[nodiscard]] base::Error start(bool has_instances, const base::BudgetTable& budget, base::Arena& memory);
    /// Nothing is shown from here on.
    void clear();
    /// One more. False where no slot is left or the layer has nothing that glyphs show. Element and layer must stay.
    [[nodiscard]] bool add(const design::DataElement& element, const scene::Layer& layer);

    [[nodiscard]] std::size_t size() const { return used_; }

    /// Of the n-th element that was added; to be called for all of them, once each, after begin_plan().
    void begin_plan();
    [[nodiscard]] draw::ElementCount plan(std::size_t n, const GlyphFrameInput& frame);

    /// Of the planned frame, but for barbs.
    [[nodiscard]] std::uint32_t glyphs() const { return static_cast<std::uint32_t>(batch_.instances().size()); }
    /// For how many sites the n-th element has room; others are merged.
    [[nodiscard]] std::uint32_t sites_of(std::size_t n) const { return slots_[n].fields[0].most_sites(); }

    /// What is drawn; runs have the slot of their element.
    [[nodiscard]] const draw::GlyphBatch& batch() const { return batch_; }
    /// A bit for each element of these roles.
    [[nodiscard]] std::uint32_t slots_of(const design::CasterRoles& roles) const;

    /// Seen from another eye than the planned one from here on.
    void set_camera(const glm::dvec3& eye);

private:
    struct Slot {
        const design::DataElement* element = nullptr;
        const scene::Layer* layer = nullptr;
        scene::GlyphField fields[2];
        draw::GlyphSites sites;         ///< of the field that is not shown
        std::int64_t times_ns[2] = {};  ///< of the fields
        bool is_given[2] = {}, is_begun[2] = {};
        std::uint32_t field_count = 0;  ///< 2 of values that change, 1 of others; 0: there is no room yet
        std::uint32_t shown = 0;
    };
    [[nodiscard]] draw::ElementInput input_of(const Slot& slot, const GlyphFrameInput& frame) const;
    void share_out();
    void start_fields(Slot& slot, std::uint64_t bytes_a_field);
    void show(Slot& slot, const GlyphFrameInput& frame);
    void advance(Slot& slot, std::uint32_t field, std::int64_t time_ns, const GlyphFrameInput& frame, std::uint32_t most_sites);
    [[nodiscard]] draw::ElementCount plan_barbs(const Slot& slot, const GlyphFrameInput& frame);
    void encode(const Slot& slot, const GlyphFrameInput& frame);

    Slot slots_[kSlots];
    std::size_t used_ = 0;
    scene::GlyphSelection selection_;
    draw::GlyphBatch batch_;
    glm::dvec3 batch_eye_{0};  ///< that its places are relative to
    base::Arena site_memory_;
    std::uint32_t most_glyphs_ = 0;
    bool is_shared_out_ = false;
};

}  // namespace tedavis::display
