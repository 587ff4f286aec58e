#include "render_core/display/planner/spatial_data.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/scene/data_time.hpp"
#include "render_core/scene/member_choice.hpp"

namespace tedavis::display {
namespace {

constexpr std::uint32_t kPostsAhead = 8192;  // made a frame; some hundred microseconds

constexpr std::size_t kRoomUnit = 64;

constexpr std::string_view kOfScene = "the scene database ";

/// Half of the line holds a scene, the other half the one that follows it; loaded, a scene takes about what its file does.
base::Error too_large_error(base::ByteSource& file, const base::Arena& memory) {
    base::ResourceUse use = memory.use();
    use.in_use = 0;
    return base::shortage_error(effects::kSceneData, use, SpatialData::scene_bytes(file.size()), "two scenes of this size");
}

std::int64_t step_ns(const design::GroundData& ground) { return base::Duration::from_seconds(ground.member_s).ns; }

}  // namespace

bool is_valid_at(const scene::Layer& layer, std::int64_t time_ns) noexcept {
    return time_ns >= layer.entry->valid_from_ns && time_ns <= layer.entry->valid_until_ns;
}

double height_or_lowest_m(double height_m, const scene::Layer& layer) noexcept {
    if (!std::isnan(height_m)) return height_m;
    return layer.levels_m.empty() ? 0 : static_cast<double>(layer.levels_m[0]);
}

const char* reason_of(GroundDataState state) noexcept {
    switch (state) {
        case GroundDataState::not_asked_for: return "not asked for by the design";
        case GroundDataState::no_terrain: return "the display has no terrain";
        case GroundDataState::no_scene: return "the display has no scene";
        case GroundDataState::no_such_layer: return "the scene has no such layer";
        case GroundDataState::no_such_attribute: return "the layer has no such attribute";
        case GroundDataState::too_large: return "the layer is no grid, or too large for the device";
        case GroundDataState::no_classes: return "the palette is of classes, and the attribute has none";
        case GroundDataState::no_members: return "the attribute has no members in the scene";
        case GroundDataState::out_of_date: return "the data are not valid at this time";
        case GroundDataState::shown: return "asked for by the design";
    }
    return "unknown";
}

std::string_view scene_fault(std::string_view message) noexcept { return base::text_behind(kOfScene, message); }

std::uint64_t SpatialData::scene_bytes(std::uint64_t file_bytes) noexcept {
    return 2 * (scene::Scene::bytes_needed(file_bytes) / kRoomUnit + 1) * kRoomUnit;
}

base::Error SpatialData::start(base::ByteSource* file, const Memory& memory, std::uint32_t most_side) {
    most_side_ = most_side;
    const auto posts = static_cast<std::uint32_t>(memory.slices.use().capacity / (2 * sizeof(scene::SliceTexel)));
    if (!slice_.start(posts, memory.slices))
        return base::shortage_error(effects::kSceneSlices, memory.slices, "data on the ground");
    const std::size_t half = memory.scene.use().capacity / 2 & ~(kRoomUnit - 1);
    for (base::Arena& room : rooms_) room = memory.scene.carve(half);
    if (file == nullptr) return {};
    auto loaded = scene::Scene::load(*file, rooms_[room_]);
    if (!loaded.ok() && loaded.error().error == scene::SdbError::too_large)
        return base::make_error(kOfScene, "does not fit: ", too_large_error(*file, memory.scene).message.view());
    if (!loaded.ok()) return base::make_error(kOfScene, scene::describe(loaded.error()).view());
    scene_ = loaded.value();
    has_scene_ = true;
    return {};
}

base::Arena& SpatialData::spare() {
    base::Arena& room = rooms_[1 - room_];
    room.reset();
    return room;
}

bool SpatialData::take(const scene::Scene& scene) {
    if (!is_newer(scene)) return false;
    room_ = 1 - room_;
    scene_ = scene;
    has_scene_ = true;
    slice_.forget();
    show(false);
    return true;
}

GroundDataState SpatialData::choose(const design::GroundData& ground) {
    if (!ground.is_shown) return GroundDataState::not_asked_for;
    if (most_side_ == 0) return GroundDataState::no_terrain;
    if (!has_scene_) return GroundDataState::no_scene;
    const scene::Layer* const layer = scene_.find(ground.layer.view());
    if (layer == nullptr) return GroundDataState::no_such_layer;
    const scene::Attribute* const attribute = layer->find(ground.attribute.view());
    if (attribute == nullptr) return GroundDataState::no_such_attribute;
    if (ground.scale.palette.is_nominal() && attribute->entry->class_count == 0) return GroundDataState::no_classes;
    if (ground.members == design::GroundMembers::animated && attribute->member_count() == 0) return GroundDataState::no_members;
    const scene::GridShape& grid = layer->entry->grid;
    const bool fits = std::max(grid.columns, grid.rows) <= most_side_ && slice_.set_field(*layer, *attribute);
    return fits ? GroundDataState::shown : GroundDataState::too_large;
}

SpatialDataPlan SpatialData::plan(const design::DataStyle& design, const flight::FlightTime& time) {
    SpatialDataPlan plan;
    plan.ground = choose(design.ground);
    if (plan.ground != GroundDataState::shown) {
        show(false);
        return plan;
    }
    const scene::SliceMoment moment = moment_at(time, design.ground);
    if (!is_valid_at(*slice_.layer(), moment.time_ns)) {
        plan.ground = GroundDataState::out_of_date;
        show(false);
        return plan;
    }
    plan.member = moment.member;
    if (moment.member != scene::kMean) plan.members = members_shown(design.ground);
    if (slice_.show(moment)) ++ground_key_;
    show(true);
    prepare_next(time, design.ground);
    return plan;
}

scene::SliceMoment SpatialData::moment_at(const flight::FlightTime& time, const design::GroundData& ground) const {
    const scene::Layer& layer = *slice_.layer();
    scene::SliceMoment moment;
    moment.height_m = height_or_lowest_m(ground.height_m, layer);
    moment.time_ns = time.is_date ? scene::start_of_data_step(time.utc.ns) : scene::own_time_ns(layer);
    if (ground.members == design::GroundMembers::mean) return moment;
    const std::uint32_t shown = members_shown(ground);
    moment.member =
        scene::spaced_member(scene::member_turn(time.utc.ns, step_ns(ground), shown), shown, slice_.attribute()->member_count());
    return moment;
}

std::uint32_t SpatialData::members_shown(const design::GroundData& ground) const {
    return std::clamp(ground.most_members, 1u, slice_.attribute()->member_count());
}

/// A part of the slice that follows: of the next data step or the next member, whichever comes first.
void SpatialData::prepare_next(const flight::FlightTime& time, const design::GroundData& ground) {
    const bool is_animated = ground.members == design::GroundMembers::animated;
    if (!time.is_date && !is_animated) return;
    flight::FlightTime next = time;
    next.utc.ns = time.is_date ? scene::start_of_data_step(time.utc.ns) + scene::kDataStep_ns : INT64_MAX;
    if (is_animated) next.utc.ns = std::min(next.utc.ns, scene::next_turn_ns(time.utc.ns, step_ns(ground)));
    slice_.prepare(moment_at(next, ground), std::max(1u, kPostsAhead / std::max(1u, slice_.columns())));
}

void SpatialData::show(bool shown) {
    if (shown != is_shown_) ++ground_key_;
    is_shown_ = shown;
}

}  // namespace tedavis::display
