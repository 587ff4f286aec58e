#include "host_sim/terrain_builder/attributes/height_planes.hpp"

#include "render_core/base/check.hpp"

namespace tedavis::host_sim {
namespace {

void require_sound(const AttributeTile& tile) {
    const auto full_columns = static_cast<std::size_t>(tile.full_columns()),
               full_rows = static_cast<std::size_t>(tile.full_rows());
    TEDAVIS_CHECK(tile.columns > 0 && tile.rows > 0);
    TEDAVIS_CHECK(tile.height_m.size() == full_columns * full_rows && tile.post_class.size() == tile.height_m.size());
    TEDAVIS_CHECK(tile.east_m.size() == full_rows && tile.north_m > 0);
    for (const double east_m : tile.east_m) TEDAVIS_CHECK(east_m > 0);
}

void fill_between(const std::vector<float>& posts, const std::vector<float>& validity, std::size_t step,
                  std::vector<float>& middles) {
    middles = posts;
    for (std::size_t n = 0; n + step < posts.size(); ++n) {
        const bool here = validity[n] > 0, there = validity[n + step] > 0;
        const float mean = 0.5f * (posts[n] + posts[n + step]);
        middles[n] = here && there ? mean : here ? posts[n] : posts[n + step];
    }
}

}  // namespace

void fill_half_posts(HalfPlanes& planes, const std::vector<float>& validity, std::size_t stride) {
    fill_between(planes[at_post], validity, stride, planes[half_south]);
    fill_between(planes[at_post], validity, 1, planes[half_east]);
}

HeightPlanes::HeightPlanes(const AttributeTile& from)
    : tile(from), stride((static_cast<std::size_t>(from.full_columns()) + 2 * kLanes - 1) / kLanes * kLanes) {
    require_sound(tile);
    const std::size_t posts = stride * static_cast<std::size_t>(tile.full_rows()) + kLanes;
    high[at_post].assign(posts, -kNoHeight_m);
    low[at_post].assign(posts, kNoHeight_m);
    validity.assign(posts, 0.0f);
    const auto columns = static_cast<std::size_t>(tile.full_columns());
    for (std::size_t n = 0; n < tile.height_m.size(); ++n) {
        if (tile.post_class[n] > terrain::PostClass::sea) continue;
        const std::size_t to = n / columns * stride + n % columns;
        high[at_post][to] = low[at_post][to] = tile.height_m[n];
        validity[to] = 1;
    }
    fill_half_posts(high, validity, stride);
    fill_half_posts(low, validity, stride);
}

}  // namespace tedavis::host_sim
