#include "render_core/display/planner/frame_notes.hpp"

#include <algorithm>

namespace tedavis::display {
namespace {

DataRecord* record_of(std::string_view type, FrameRecord& record) {
    for (DataRecord& known : record.data)
        if (known.type.view() == type) return &known;
    DataRecord begun;
    begun.type = Name(type);
    return record.data.try_push_back(begun) ? &record.data.back() : nullptr;
}

Name effect_name(const ElementReport& report) {
    Name name("data.");
    name.append(design::kDataTechniqueNames[static_cast<std::size_t>(report.element->technique)]);
    return name;
}

void record_effect(const ElementReport& report, FrameRecord& record) {
    EffectRecord effect;
    effect.name = effect_name(report);
    effect.state = report.state == ElementState::shown ? EffectState::run : EffectState::skipped;
    effect.reason.append(subject_of(*report.element).view());
    effect.reason.append(": ");
    effect.reason.append(reason_of(report.state));
    static_cast<void>(record.effects.try_push_back(effect));
}

void record_aspects(const ElementReport& report, FrameRecord& record) {
    const design::DataElement& element = *report.element;
    if (!is_drawn(report)) return;
    if (element.technique != design::DataTechnique::uncertainty_only)
        add_technique(design::kDataTechniqueNames[static_cast<std::size_t>(element.technique)],
                      element.detail * report.detail_factor, record.data_aspect);
    if (shows_uncertainty(report))
        add_technique(design::kElementUncertaintyNames[static_cast<std::size_t>(element.uncertainty)],
                      design::detail_of_levels(element.uncertainty_levels), record.uncertainty_aspect);
}

/// What is out of view counts as nothing else; of what is not told apart, the drawn ones are taken to be out of it first.
void record_count(const ElementReport& report, DataRecord& type) {
    if (report.state != ElementState::shown) {
        type.hidden += report.count.all();
        return;
    }
    const std::uint32_t drawn_out = std::min(report.out_of_view, report.count.drawn);
    const std::uint32_t aggregated_out = std::min(report.out_of_view - drawn_out, report.count.aggregated);
    type.drawn += report.count.drawn - drawn_out;
    type.aggregated += report.count.aggregated - aggregated_out;
    type.hidden += report.count.hidden;
    type.out_of_view += drawn_out + aggregated_out;
}

}  // namespace

void flag(std::string_view name, FrameStatement& record) {
    for (const Name& known : record.flags)
        if (known.view() == name) return;
    // A full list has counted the refusal itself.
    static_cast<void>(record.flags.try_push_back(Name(name)));
}

void flag(policy::RecordFlag raised, FrameStatement& record) { flag(policy::name_of(raised), record); }

void record_stale(std::string_view layer, base::Duration age, FrameStatement& record) {
    if (age.ns <= 0) return;
    for (const StaleRecord& known : record.stale)
        if (known.layer.view() == layer) return;
    static_cast<void>(record.stale.try_push_back({layer, age.to_seconds()}));
}

void add_technique(std::string_view name, double detail, AspectRecord& aspect) {
    aspect.detail = std::max(aspect.detail, detail);
    for (std::string_view rest = aspect.technique.view(); !rest.empty();) {
        const std::size_t end = std::min(rest.find('+'), rest.size());
        if (rest.substr(0, end) == name) return;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (!aspect.technique.empty()) aspect.technique.append("+");
    aspect.technique.append(name);
}

void record_terrain(const TerrainPlan& plan, FrameStatement& record) {
    TerrainRecord& terrain = record.terrain;
    terrain.worst_error_px = plan.lod.worst_error_px;
    terrain.tau_reached_px = plan.lod.tau_reached_px;
    terrain.limit = Name(terrain::to_string(plan.lod.reason));
    terrain.pending = plan.pending;
    terrain.triangles = plan.lod.triangles;
    if (plan.lod.tau_reached_px > terrain.tau_px) flag(policy::RecordFlag::terrain_tau_raised, record);
    if (plan.has_void) flag(policy::RecordFlag::terrain_void, record);
    if (plan.is_late) flag(policy::RecordFlag::terrain_late, record);
    if (plan.is_failing) flag(policy::RecordFlag::terrain_failing, record);
    if (plan.lod.worst_chunk == terrain::kNoChunk) return;
    const terrain::ChunkKey& worst = plan.lod.worst_chunk;
    terrain.worst_chunk.append(base::digits(worst.level).view());
    terrain.worst_chunk.append("/");
    terrain.worst_chunk.append(base::digits(worst.i).view());
    terrain.worst_chunk.append("/");
    terrain.worst_chunk.append(base::digits(worst.j).view());
}

void record_renderer(design::TerrainRenderer asked, draw::TraceState state, const effects::RendererDecision& decision,
                     FrameStatement& record) {
    const auto drawn = state == draw::TraceState::traced ? design::TerrainRenderer::trace : design::TerrainRenderer::raster;
    record.terrain.renderer = Name(design::kTerrainRendererNames[static_cast<std::size_t>(drawn)]);
    if (drawn == asked) return;
    const bool is_choice = asked == design::TerrainRenderer::automatic;
    const bool is_chosen = is_choice && (state == draw::TraceState::traced || state == draw::TraceState::not_by_cost);
    record.terrain.renderer_reason.append(is_chosen ? to_string(decision.why) : draw::reason_of(state));
    record.terrain.triangles_ms = decision.costs.triangles_ms;
    record.terrain.rays_ms = decision.costs.rays_ms;
    if (!is_choice) flag(policy::RecordFlag::terrain_not_traced, record);
}

void record_elements(const ElementReports& reports, FrameRecord& record) {
    for (const ElementReport& report : reports) {
        if (report.state != ElementState::shown && report.state != ElementState::not_measured)
            flag(policy::RecordFlag::data_missing, record);
        record_effect(report, record);
        record_aspects(report, record);
        if (report.layer == nullptr) continue;
        DataRecord* const type = record_of(scene::name_of(report.layer->entry->role), record);
        if (type == nullptr) continue;
        record_count(report, *type);
    }
}

void record_weights(const design::PrioritySettings& priority, const design::AspectWeights& weights, FrameRecord& record) {
    AspectRecord* const main[] = {&record.terrain_aspect, &record.data_aspect, &record.uncertainty_aspect};
    for (std::size_t n = 0; n < priority.count(); ++n) {
        if (n < design::kMainAspects) main[n]->weight = weights.of[n];
        static_cast<void>(record.weights.try_push_back({Name(priority.name_of(n)), weights.of[n], priority.weights.of[n]}));
    }
}

void record_budget(const effects::BudgetReport& report, FrameRecord& record) {
    record.governor = {report.deadline_ms,
                       report.predicted_ms,
                       static_cast<std::uint32_t>(report.quality_level),
                       report.changed,
                       effects::to_string(report.why),
                       report.quality.tau_factor,
                       report.quality.detail_factor,
                       report.quality.given_up};
    if (report.is_missed) flag(policy::RecordFlag::deadline_missed, record);
}

void record_work(const EffectWorkTable& work, FrameRecord& record) {
    for (EffectRecord& noted : record.effects) {
        const effects::Effect effect = effects::effect_of(noted.name.view());
        if (effect == effects::Effect::count_ || effect == effects::Effect::terrain) continue;
        noted.draws = work[effect].draws;
        noted.passes = work[effect].passes;
        noted.bytes = work[effect].bytes;
    }
}

void record_drawn(const draw::TerrainDrawResult& drawn, const base::BudgetTable& budget, FrameRecord& record) {
    record.terrain.triangles = drawn.triangles;
    record.terrain.chunks = drawn.draws;
    for (EffectRecord& effect : record.effects)
        if (effect.name.view() == "terrain") effect.draws = drawn.draws;
    record.bytes.cpu = budget.in_use(base::MemoryKind::cpu);
    record.bytes.gpu = budget.in_use(base::MemoryKind::gpu);
    record.bytes.cpu_budget = budget.total(base::MemoryKind::cpu);
    record.bytes.gpu_budget = budget.total(base::MemoryKind::gpu);
}

}  // namespace tedavis::display
