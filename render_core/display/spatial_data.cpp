#include "render_core/display/spatial_data.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/scene/data_time.hpp"

namespace tedavis::display {
namespace {

constexpr std::uint32_t kPostsAhead = 8192;  // made a frame; some hundred microseconds

constexpr std::string_view kOfScene = "the scene database ";

double slice_height_m(const design::GroundData& ground, const scene::Layer& layer) {
    if (!std::isnan(ground.height_m)) return ground.height_m;
    return layer.levels_m.empty() ? 0 : static_cast<double>(layer.levels_m[0]);
}

}  // namespace

const char* reason_of(GroundDataState state) noexcept {
    switch (state) {
        case GroundDataState::not_asked_for: return "not asked for by the design";
        case GroundDataState::no_terrain: return "the display has no terrain";
        case GroundDataState::no_scene: return "the display has no scene";
        case GroundDataState::no_such_layer: return "the scene has no such layer";
        case GroundDataState::no_such_attribute: return "the layer has no such attribute";
        case GroundDataState::too_large: return "the layer is no grid, or too large for the device";
        case GroundDataState::out_of_date: return "the data are not valid at this time";
        case GroundDataState::shown: return "asked for by the design";
    }
    return "unknown";
}

std::string_view scene_fault(std::string_view sentence) noexcept { return base::text_behind(kOfScene, sentence); }

gl::GlError SpatialData::start(base::ByteSource* file, const Memory& memory, std::uint32_t most_side) {
    most_side_ = most_side;
    const auto posts = static_cast<std::uint32_t>(memory.slices.use().capacity / (2 * sizeof(scene::SliceTexel)));
    if (!slice_.start(posts, memory.slices))
        return gl::make_error("the budget line 'scene_slices' is too small for data on the ground; raise it in the device file");
    const std::size_t half = memory.scene.use().capacity / 2 & ~std::size_t{63};
    for (base::Arena& room : rooms_) room = memory.scene.carve(half);
    if (file == nullptr) return {};
    auto loaded = scene::Scene::load(*file, rooms_[room_]);
    if (!loaded.ok()) return gl::make_error(kOfScene, scene::describe(loaded.error()).view());
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
    if (has_scene_ && scene.header().revision <= scene_.header().revision) return false;
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
    const scene::GridShape& grid = layer->entry->grid;
    const bool fits = std::max(grid.columns, grid.rows) <= most_side_ && slice_.set_field(*layer, *attribute);
    return fits ? GroundDataState::shown : GroundDataState::too_large;
}

GroundDataState SpatialData::plan(const design::DataStyle& design, const flight::FlightTime& time) {
    const GroundDataState state = choose(design.ground);
    if (state != GroundDataState::shown) {
        show(false);
        return state;
    }
    const scene::Layer& layer = *slice_.layer();
    const std::int64_t time_ns = time.is_date ? scene::start_of_data_step(time.utc.ns) : scene::own_time_ns(layer);
    if (time_ns < layer.entry->valid_from_ns || time_ns > layer.entry->valid_until_ns) {
        show(false);
        return GroundDataState::out_of_date;
    }
    const double height_m = slice_height_m(design.ground, layer);
    if (slice_.show(height_m, time_ns)) has_changed_ = true;
    show(true);
    if (time.is_date)
        slice_.prepare(height_m, time_ns + scene::kDataStep_ns, std::max(1u, kPostsAhead / std::max(1u, slice_.columns())));
    return state;
}

void SpatialData::show(bool shown) {
    has_changed_ = has_changed_ || shown != is_shown_;
    is_shown_ = shown;
}

bool SpatialData::take_change() {
    const bool has_changed = has_changed_;
    has_changed_ = false;
    return has_changed;
}

}  // namespace tedavis::display
