#include "render_core/effects/device.hpp"

#include <array>

namespace tedavis::effects {
namespace {

constexpr std::int64_t kMaxEdgePx = 16384;
constexpr std::int64_t kMaxLineBytes = std::int64_t{8} << 30;

struct RequiredLine {
    std::string_view name;
    base::MemoryKind kind;
};
constexpr RequiredLine kRequiredLines[] = {
    {kTerrainChunkSlots, base::MemoryKind::cpu}, {kTerrainHeights, base::MemoryKind::cpu},
    {kTerrainIndex, base::MemoryKind::cpu},      {kTerrainVertices, base::MemoryKind::gpu},
    {kTerrainIndices, base::MemoryKind::gpu},    {kSymbology, base::MemoryKind::cpu},
    {kSymbologyVertices, base::MemoryKind::gpu}, {kFontAtlas, base::MemoryKind::gpu},
    {kRenderTargets, base::MemoryKind::gpu},     {kStaging, base::MemoryKind::cpu},
    {kLodScratch, base::MemoryKind::cpu},        {kTerrainAttributes, base::MemoryKind::cpu},
    {kTerrainPages, base::MemoryKind::gpu},      {kTerrainDrape, base::MemoryKind::cpu},
    {kTerrainDrapePages, base::MemoryKind::gpu}, {kSceneData, base::MemoryKind::cpu},
    {kSceneSlices, base::MemoryKind::cpu},       {kSceneGround, base::MemoryKind::gpu},
    {kSceneSolids, base::MemoryKind::cpu},       {kSceneSolidVertices, base::MemoryKind::gpu},
    {kSceneGlyphs, base::MemoryKind::cpu},       {kSceneGlyphVertices, base::MemoryKind::gpu},
    {kSceneBillboards, base::MemoryKind::cpu},   {kSceneBillboardVertices, base::MemoryKind::gpu},
    {kPlannedFrames, base::MemoryKind::cpu},     {kPlannerMemory, base::MemoryKind::cpu}};

constexpr RequiredLine kPossibleLines[] = {
    {kPictureEdges, base::MemoryKind::cpu}, {kTracedTerrain, base::MemoryKind::cpu}, {kTracedPictures, base::MemoryKind::gpu}};

void read_call_names(base::ConfigSection section, std::string_view key, base::FixedVector<CallName, kMaxCallExceptions>& out) {
    std::array<std::string_view, kMaxNamedCalls> names;
    const std::size_t count = section.texts(key, names);
    for (std::size_t i = 0; i < count; ++i) {
        const CallName name(names[i]);
        if (name.empty() || name.cut() || !out.try_push_back(name)) section.fault(key, "a GL call's name has 1 to 31 letters");
    }
}

void read_ignored_faults(base::ConfigSection section, base::FixedVector<FaultName, kMaxIgnoredFaults>& out) {
    std::array<std::string_view, kMaxIgnoredFaults> names;
    const std::size_t count = section.texts("ignore_faults", names);
    for (std::size_t i = 0; i < count; ++i)
        if (FaultName(names[i]).cut() || !out.try_push_back(FaultName(names[i])))
            section.fault("ignore_faults", "a fault's name has at most 31 letters; gl/driver_fault lists them");
}

void read_gl(base::ConfigSection section, DeviceCapability& capability) {
    constexpr std::string_view kLanes[] = {"es2", "es3"};
    constexpr std::string_view kClasses[] = {"es2", "es3", "sc2"};
    if (!section.present()) return;
    section.choose("lane", kLanes, capability.lane);
    GlRules& rules = capability.gl;
    section.choose("calls", kClasses, rules.calls);
    read_call_names(section, "also", rules.also);
    read_call_names(section, "never", rules.never);
    read_ignored_faults(section, rules.ignored_faults);
    rules.max_texture_px = static_cast<std::uint32_t>(section.integer("max_texture_px", 64, kMaxEdgePx));
    rules.max_attributes = static_cast<std::uint32_t>(section.integer("max_attributes", 1, 16));
    rules.max_texture_units = static_cast<std::uint32_t>(section.integer("max_texture_units", 1, 32));
    capability.surface_depth_bits = static_cast<std::uint32_t>(section.integer("surface_depth_bits", 0, 32));
    capability.depth24_targets = section.boolean("depth24_targets", true);
    capability.off_screen_pictures = static_cast<std::uint32_t>(section.integer("off_screen_pictures", 0, 8, 1));
    capability.shadow_map_px = static_cast<std::uint32_t>(section.integer("shadow_map_px", 0, kMaxEdgePx / 3, 0));
    if (std::uint64_t{3} * capability.shadow_map_px > rules.max_texture_px)
        section.fault("shadow_map_px", "times three is more than max_texture_px; lower it");
    capability.blur_square_px = static_cast<std::uint32_t>(section.integer("blur_square_px", 1, 4, 2));
    if (rules.calls != CallClass::es3 && capability.lane == Lane::es3)
        section.fault("lane", "lane 'es3' needs calls 'es3'; set lane = \"es2\"");
}

void read_costs(base::ConfigSection section, DeviceSettings& device) {
    device.terrain_ms = section.number("budget_ms", 0, 1000, 0);
    device.ns_per_triangle = section.number("ns_per_triangle", 0, 1e6, 0);
    device.us_per_chunk = section.number("us_per_chunk", 0, 1e6, 0);
    if (device.terrain_ms > 0 && device.ns_per_triangle == 0 && device.us_per_chunk == 0)
        section.fault("budget_ms", "needs 'ns_per_triangle' or 'us_per_chunk' beside it; measure them on the device");
}

void read_forbidden(base::ConfigSection section, EffectSet& forbidden) {
    std::array<std::string_view, kEffectCount> names;
    const std::size_t count = section.texts("forbid", names);
    for (std::size_t i = 0; i < count; ++i) {
        const Effect effect = effect_of(names[i]);
        if (effect == Effect::count_)
            section.fault("forbid", "no effect has this name; `render_core/effects/README.md` lists them");
        else if (!row_of(effect).may_be_forbidden)
            section.fault("forbid", "this one always stands or is what takes another's place; remove it");
        else
            forbidden.add(effect);
    }
}

void read_affordable(base::ConfigSection section, DeviceSettings& device) {
    constexpr std::string_view kKey = "affords_antialiasing";
    device.affords_antialiasing = section.boolean(kKey, false);
    if (!device.affords_antialiasing) return;
    if (device.forbidden.has(Effect::antialiasing))
        section.fault(kKey, "'affords_antialiasing' is beside a 'forbid' of antialiasing; remove one");
    if (!has(device.capability, row_of(Effect::antialiasing).need))
        section.fault(kKey, "'affords_antialiasing' needs calls = \"es3\" and off_screen_pictures = 2 in [gl]; set it to false");
}

void read_budget(base::ConfigSection root, base::BudgetTable& budget) {
    constexpr std::string_view kKinds[] = {"cpu", "gpu"};
    const std::size_t count = root.table_count("budget");
    for (std::size_t i = 0; i < count; ++i) {
        base::ConfigSection section = root.table_at("budget", i);
        base::BudgetLine line;
        line.name = section.text("name");
        section.choose("kind", kKinds, line.kind);
        line.bytes = static_cast<std::uint64_t>(section.integer("bytes", 0, kMaxLineBytes));
        line.owner = section.text("owner");
        line.reason = section.text("reason");
        line.use.capacity = line.bytes;
        if (line.name.cut() || line.owner.cut() || line.reason.cut())
            section.fault("name", "name and owner have at most 31 letters and the reason at most 95; shorten them");
        if (!budget.try_add(line))
            section.fault("name", "this budget line is there already, or there are more than 32; remove it");
    }
}

void require_line(base::ConfigSection& root, const base::BudgetTable& budget, const RequiredLine& required, bool may_miss) {
    const base::BudgetLine* line = budget.find(required.name);
    if (line == nullptr ? may_miss : line->kind == required.kind) return;
    base::FixedString<127> message("the budget needs a line '");
    message.append(required.name);
    message.append(required.kind == base::MemoryKind::cpu ? "' of kind \"cpu\"; add it" : "' of kind \"gpu\"; add it");
    root.fault("budget", message.view());
}

void require_lines(base::ConfigSection root, const base::BudgetTable& budget) {
    for (const RequiredLine& required : kRequiredLines) require_line(root, budget, required, false);
    for (const RequiredLine& possible : kPossibleLines) require_line(root, budget, possible, true);
}

}  // namespace

base::Result<DeviceSettings, base::Error> read_device_settings(std::string_view text, std::string_view file_name) {
    base::ConfigReader reader(text, file_name);
    base::ConfigSection root = reader.root();
    DeviceSettings device;
    device.name = root.text("name");
    device.width_px = static_cast<std::uint32_t>(root.integer("width_px", 64, kMaxEdgePx));
    device.height_px = static_cast<std::uint32_t>(root.integer("height_px", 64, kMaxEdgePx));
    device.frame_rate_hz = root.number("frame_rate_hz", 1, 240);
    device.deadline_ms = root.number("deadline_ms", 0, 10'000, 0);
    device.triangle_budget = static_cast<std::uint32_t>(root.integer("triangle_budget", 1000, 100'000'000));
    device.max_chunk_slots = static_cast<std::uint32_t>(root.integer("max_chunk_slots", 8, 65536));
    device.attribute_pages = static_cast<std::uint32_t>(root.integer("attribute_pages", 0, 1024, 0));
    device.drape_pages = static_cast<std::uint32_t>(root.integer("drape_pages", 0, 1024, 0));
    device.arrival_frames = static_cast<std::uint32_t>(root.integer("arrival_frames", 1, 8, device.arrival_frames));
    read_costs(root.section("terrain_cost"), device);
    if (!root.has("gl")) root.fault("gl", "the table [gl] is missing; add it");
    read_gl(root.section("gl"), device.capability);
    read_forbidden(root.section("effects"), device.forbidden);
    read_affordable(root.section("effects"), device);
    read_budget(root, device.budget);
    require_lines(root, device.budget);
    if (!reader.finish()) return base::fail(reader.error());
    return device;
}

}  // namespace tedavis::effects
