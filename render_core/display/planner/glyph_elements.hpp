/// Data elements that are shown as glyphs: each has a field of sites, of which a view shows a selection; no GL.
///
///   start(...) · clear() and add(...) for each element · begin_plan() and plan(...) each frame · batch() for the painter
///
/// Values at a time are those of the whole minute before it. The field of the next minute is computed in advance, some sites in
/// each frame, so that no frame is delayed; after a jump in time it is computed at once. What is shown never depends on where a
/// run began. The memory for sites is divided again when elements are added: an element that needs little gets all that it needs,
/// and the others share the rest.
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
    const scene::DetailRegions* regions = nullptr;  ///< detail of the element in each region of the screen; null: all
};

[[nodiscard]] bool is_glyph_technique(design::DataTechnique technique) noexcept;
[[nodiscard]] bool is_glyph_uncertainty(design::ElementUncertainty uncertainty) noexcept;
/// Returns the scale of uncertainty glyphs: levels from 0, certain, to 1, in classes where the design requests them.
[[nodiscard]] design::DataScale uncertainty_scale(const design::DataElement& element) noexcept;

class GlyphElements {
public:
    static constexpr std::size_t kSlots = 3;

    /// `has_instances`: draw::GlyphDrawer::has_instances() of the device. The arena keeps the drawer's share free.
    [[nodiscard]] base::Error start(bool has_instances, const base::BudgetTable& budget, base::Arena& memory);
    /// Removes all elements.
    void clear();
    /// Adds an element. Returns false where no slot is left or the layer has nothing that glyphs show. Element and layer must
    /// stay valid.
    [[nodiscard]] bool add(const design::DataElement& element, const scene::Layer& layer);

    [[nodiscard]] std::size_t size() const { return used_; }

    /// Begins a frame: plan() must then be called once for each element that was added, n from 0.
    void begin_plan();
    [[nodiscard]] draw::ElementCount plan(std::size_t n, const GlyphFrameInput& frame);

    /// Returns the number of glyphs in the planned frame, without barbs.
    [[nodiscard]] std::uint32_t glyphs() const { return static_cast<std::uint32_t>(batch_.instances().size()); }
    /// Returns the number of sites for which the n-th element has room; further sites are merged.
    [[nodiscard]] std::uint32_t sites_of(std::size_t n) const { return slots_[n].fields[0].most_sites(); }

    /// What is drawn; runs have the slot of their element.
    [[nodiscard]] const draw::GlyphBatch& batch() const { return batch_; }
    /// Returns a bit for each element of these roles.
    [[nodiscard]] std::uint32_t slots_of(const design::CasterRoles& roles) const;

    /// Moves the eye point away from the planned one.
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
