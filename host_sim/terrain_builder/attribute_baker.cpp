#include "host_sim/terrain_builder/attribute_baker.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

constexpr std::uint32_t kSubtreeLevels = 3;  // a tile so many levels up is a task with all that lies below it: 2^20 posts
constexpr std::uint32_t kPageSteps = kAttributePosts - 1;
constexpr double kMinEast = 0.01;  // of a step north, where meridians run together

/// Bits of u and v in turn: tiles that follow each other mostly share the tiles above them.
std::uint64_t interleaved(std::uint32_t u, std::uint32_t v) {
    std::uint64_t code = 0;
    for (unsigned bit = 0; bit < 32; ++bit) {
        code |= (std::uint64_t{u} >> bit & 1) << (2 * bit);
        code |= (std::uint64_t{v} >> bit & 1) << (2 * bit + 1);
    }
    return code;
}

bool same(const TileKey& a, const TileKey& b) { return a.level == b.level && a.u == b.u && a.v == b.v; }

/// Spacings of posts of a level.
void measure_spacing(const BuildPlan& plan, const TileKey& key, AttributeTile& tile) {
    const double posts = std::exp2(key.level);
    const auto latitude = [&](double row) {
        return plan.lattice.latitude_rad(static_cast<std::uint32_t>(std::clamp(row * posts, 0.0, plan.header.rows - 1.0)));
    };
    const double first = static_cast<double>(key.v) * kTilePosts - kAttributeApron;
    tile.north_m =
        earth::meridian_radius_m(latitude(first + 0.5 * tile.full_rows())) * base::radians(plan.header.step_lat_deg) * posts;
    for (int row = 0; row < tile.full_rows(); ++row) {
        const double phi = latitude(first + row);
        const double east_m =
            earth::prime_vertical_radius_m(phi) * std::cos(phi) * base::radians(plan.header.step_lon_deg) * posts;
        tile.east_m.push_back(std::max(east_m, kMinEast * tile.north_m));
    }
}

/// What a texel is called, also where its height is known from other posts.
void name_classes(const AttributeTile& tile, const std::vector<PostClass>& classes, AttributeMaps& maps) {
    constexpr std::size_t kMap = static_cast<std::size_t>(AttributeChannel::post_class) / 4,
                          kByte = static_cast<std::size_t>(AttributeChannel::post_class) % 4;
    for (int row = 0; row < tile.rows; ++row)
        for (int column = 0; column < tile.columns; ++column)
            maps.rgba[kMap][4 * index_of(column, row, tile.columns) + kByte] =
                class_code(classes[index_of(column + kAttributeApron, row + kAttributeApron, tile.full_columns())]);
}

/// The part of a tile's maps that begins at a column and a row; beyond the maps their last post is repeated.
void cut_page(const AttributeMaps& maps, std::uint32_t column, std::uint32_t row, AttributePage& page) {
    const auto source = [](std::uint32_t first, std::uint32_t n, int posts) {
        return std::min(static_cast<int>(first + n), posts - 1);
    };
    for (std::uint32_t b = 0; b < kAttributePosts; ++b)
        for (std::uint32_t a = 0; a < kAttributePosts; ++a) {
            const std::size_t from = 4 * index_of(source(column, a, maps.columns), source(row, b, maps.rows), maps.columns);
            const std::size_t to = std::size_t{b} * kAttributePosts + a;
            std::memcpy(page.form[to], &maps.rgba[0][from], 4);
            std::memcpy(page.light[to], &maps.rgba[1][from], 4);
            std::memcpy(page.aperture[to], &maps.rgba[2][from], 4);
        }
    const int columns = (maps.columns + 1) / 2, rows = (maps.rows + 1) / 2;
    for (std::size_t direction = 0; direction < maps.horizon.size(); ++direction)
        for (std::uint32_t b = 0; b < kHorizonPosts; ++b)
            for (std::uint32_t a = 0; a < kHorizonPosts; ++a)
                page.horizon[direction][b * kHorizonPosts + a] =
                    maps.horizon[direction][index_of(source(column / 2, a, columns), source(row / 2, b, rows), columns)];
}

}  // namespace

AttributeBaker::AttributeBaker(const BuildPlan& plan, const TdbLayout& layout, const InsetCoverage& coverage,
                               const HeightLevels& heights, PartStore& store)
    : plan_(plan), layout_(layout), coverage_(coverage), heights_(heights), store_(store) {
    // The page of a chunk shows posts of one pyramid level less.
    const std::uint32_t base = coverage.base_level();
    if (plan.levels() >= base + 2) list_tasks(plan.levels() - 2, base);
    if (base > 0) list_tasks(base - 1, 0);
}

std::uint32_t AttributeBaker::tiles_across(std::uint32_t level) const {
    return std::max(1u, (heights_.columns(level) - 1 + kTilePosts - 1) / kTilePosts);
}
std::uint32_t AttributeBaker::tiles_down(std::uint32_t level) const {
    return std::max(1u, (heights_.rows(level) - 1 + kTilePosts - 1) / kTilePosts);
}

bool AttributeBaker::is_needed(const TileKey& tile) const {
    for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant) {
        const ChunkKey chunk{tile.level + 1, 2 * tile.u + (quadrant & 1), 2 * tile.v + (quadrant >> 1)};
        if (plan_.lattice.contains(chunk) && coverage_.has_children(chunk)) return true;
    }
    return false;
}

/// Tiles with a page to be made, so that those that follow each other mostly share the tiles above them.
std::vector<TileKey> AttributeBaker::tiles_of(std::uint32_t level) const {
    std::vector<PostRange> regions = coverage_.regions();
    if (level >= coverage_.base_level()) regions = {{0, 0, plan_.header.columns - 1, plan_.header.rows - 1}};
    std::vector<TileKey> tiles;
    for (const PostRange& region : regions) {
        const std::uint32_t side = kTilePosts << level;
        for (std::uint32_t v = region.j0 / side; v <= std::min((region.j1 - 1) / side, tiles_down(level) - 1); ++v)
            for (std::uint32_t u = region.i0 / side; u <= std::min((region.i1 - 1) / side, tiles_across(level) - 1); ++u)
                if (is_needed({level, u, v})) tiles.push_back({level, u, v});
    }
    std::sort(tiles.begin(), tiles.end(),
              [](const TileKey& a, const TileKey& b) { return interleaved(a.u, a.v) < interleaved(b.u, b.v); });
    tiles.erase(std::unique(tiles.begin(), tiles.end(), same), tiles.end());
    return tiles;
}

void AttributeBaker::list_tasks(std::uint32_t first_level, std::uint32_t last_level) {
    const std::uint32_t with_those_below = std::min(first_level, last_level + kSubtreeLevels);
    for (std::uint32_t level = first_level + 1; level-- > with_those_below;)
        for (const TileKey& tile : tiles_of(level)) tasks_.push_back({tile, level == with_those_below ? last_level : level});
}

std::unique_ptr<AttributeBaker::Sight> AttributeBaker::new_sight() const {
    auto sight = std::make_unique<Sight>();
    sight->levels.resize(heights_.level_count());
    return sight;
}

std::vector<BakedPage> AttributeBaker::run(std::uint32_t task) {
    std::unique_ptr<Sight> sight = sights_.take([this] { return new_sight(); });
    std::vector<BakedPage> pages;
    bake(tasks_[task], *sight, pages);
    sights_.give_back(std::move(sight));
    return pages;
}

/// Known heights and validity as the maps are made from; `classes` are what the posts are called.
AttributeTile AttributeBaker::load(const TileKey& key, std::vector<PostClass>& classes) const {
    const std::uint32_t i = key.u * kTilePosts, j = key.v * kTilePosts;
    AttributeTile tile;
    tile.columns = static_cast<int>(std::min(kTilePosts + 1, heights_.columns(key.level) - i));
    tile.rows = static_cast<int>(std::min(kTilePosts + 1, heights_.rows(key.level) - j));
    LatticeWindow window;
    window.i0 = std::int64_t{i} - kAttributeApron;
    window.j0 = std::int64_t{j} - kAttributeApron;
    window.columns = static_cast<std::uint32_t>(tile.full_columns());
    window.rows = static_cast<std::uint32_t>(tile.full_rows());
    heights_.read(key.level, window);
    classes = window.post_class;
    tile.height_m = std::move(window.height_m);
    tile.post_class = std::move(window.post_class);
    for (std::size_t n = 0; key.level > 0 && n < tile.height_m.size(); ++n) {
        const bool known = !std::isnan(tile.height_m[n]);
        if (!known) tile.height_m[n] = 0;
        if (tile.post_class[n] == PostClass::outside) continue;
        if (!known) tile.post_class[n] = PostClass::void_;
        if (known && tile.post_class[n] == PostClass::void_) tile.post_class[n] = PostClass::land;
    }
    measure_spacing(plan_, key, tile);
    return tile;
}

/// Makes what is missing, from the top of the pyramid down.
FarView AttributeBaker::view_above(const TileKey& tile, Sight& sight) const {
    FarView view;
    for (std::uint32_t level = heights_.level_count() - 1; level > tile.level; --level) {
        const std::uint32_t shift = level - tile.level;
        const TileKey above{level, tile.u >> shift, tile.v >> shift};
        Sight::Level& at = sight.levels[level];
        if (!at.known || !same(at.tile, above)) {
            std::vector<PostClass> classes;
            const AttributeTile posts = load(above, classes);
            at = {above, make_far_horizons(HeightPlanes(posts), view), true};
        }
        const std::uint32_t child = shift - 1;
        view = {&at.far, 0.5 * kTilePosts * (tile.u >> child & 1), 0.5 * kTilePosts * (tile.v >> child & 1)};
    }
    return view;
}

void AttributeBaker::bake(const Task& task, Sight& sight, std::vector<BakedPage>& pages) {
    // Depth first without recursion: the tile with the most recent sight above it goes next.
    std::vector<TileKey> open{task.tile};
    while (!open.empty()) {
        const TileKey next = open.back();
        open.pop_back();
        const FarView view = view_above(next, sight);
        std::vector<PostClass> classes;
        const AttributeTile posts = load(next, classes);
        const bool go_on = next.level > task.last_level;
        TileAttributes made = make_attributes(posts, FixedLight(), view, go_on);
        name_classes(posts, classes, made.maps);
        put_pages(next, made.maps, pages);
        if (!go_on) continue;
        sight.levels[next.level] = {next, std::move(*made.far), true};
        for (std::uint32_t quadrant = 4; quadrant-- > 0;) {
            const TileKey child{next.level - 1, 2 * next.u + (quadrant & 1), 2 * next.v + (quadrant >> 1)};
            const bool inside = child.u < tiles_across(child.level) && child.v < tiles_down(child.level);
            if (inside && is_needed(child)) open.push_back(child);
        }
    }
}

void AttributeBaker::put_pages(const TileKey& tile, const AttributeMaps& maps, std::vector<BakedPage>& pages) {
    const auto page = std::make_unique<AttributePage>();
    for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant) {
        const ChunkKey chunk{tile.level + 1, 2 * tile.u + (quadrant & 1), 2 * tile.v + (quadrant >> 1)};
        if (!plan_.lattice.contains(chunk) || !coverage_.has_children(chunk)) continue;
        cut_page(maps, (quadrant & 1) * kPageSteps, (quadrant >> 1) * kPageSteps, *page);
        pages.push_back(placed(chunk, *page));
    }
}

BakedPage AttributeBaker::placed(const ChunkKey& chunk, const AttributePage& page) {
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(&page);
    const std::uint32_t base = coverage_.base_level();
    BakedPage baked{chunk, {0, sizeof page, checksum(bytes, sizeof page)}, {}};
    if (chunk.level <= base) {
        baked.bytes.assign(bytes, bytes + sizeof page);
        return baked;
    }
    baked.place.offset = layout_.attribute_place({chunk.level - base, chunk.i, chunk.j}).offset;
    store_.put(ChunkPart::attributes, chunk, baked.place, {bytes, sizeof page});
    return baked;
}

}  // namespace tedavis::host_sim
