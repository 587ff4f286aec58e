#include "host_sim/terrain_builder/inset_import.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

constexpr double kSnap = 1e-6;  // of a post: places that agree so well are the same

LatticeWindow window_of(const PostRange& posts, std::uint32_t margin) {
    LatticeWindow window;
    window.i0 = std::int64_t{posts.i0} - margin;
    window.j0 = std::int64_t{posts.j0} - margin;
    window.columns = posts.i1 - posts.i0 + 1 + 2 * margin;
    window.rows = posts.j1 - posts.j0 + 1 + 2 * margin;
    return window;
}

bool is_known(PostClass post_class) { return post_class <= PostClass::sea; }

constexpr std::uint32_t kMargin = kBlendPosts + 1;

/// Steps to the nearest post that is not known, along rows, columns and diagonals; at most kMargin. Two sweeps make this
/// distance exactly (Rosenfeld, Pfaltz, "Distance Functions on Digital Pictures", Pattern Recognition 1, 1968).
std::vector<std::uint8_t> steps_to_unknown(const LatticeWindow& window) {
    std::vector<std::uint8_t> steps(window.post_class.size());
    const std::int64_t columns = window.columns, rows = window.rows;
    const auto sweep = [&](std::int64_t i, std::int64_t j, std::int64_t before) {
        const auto n = static_cast<std::size_t>(j * columns + i);
        std::uint8_t least = steps[n];
        for (const auto& [di, dj] : {std::pair{-1, 0}, {-1, -1}, {0, -1}, {1, -1}}) {
            const std::int64_t a = i + before * di, b = j + before * dj;
            if (a < 0 || b < 0 || a >= columns || b >= rows) continue;
            least = std::min(least, static_cast<std::uint8_t>(steps[static_cast<std::size_t>(b * columns + a)] + 1));
        }
        steps[n] = least;
    };
    for (std::size_t n = 0; n < steps.size(); ++n) steps[n] = is_known(window.post_class[n]) ? kMargin : 0;
    for (std::int64_t j = 0; j < rows; ++j)
        for (std::int64_t i = 0; i < columns; ++i) sweep(i, j, 1);
    for (std::int64_t j = rows - 1; j >= 0; --j)
        for (std::int64_t i = columns - 1; i >= 0; --i) sweep(i, j, -1);
    return steps;
}

/// Lays an inset, read with a margin of kMargin posts, over a window.
void blend(const LatticeWindow& inset, LatticeWindow& window) {
    const std::vector<std::uint8_t> steps = steps_to_unknown(inset);
    for (std::uint32_t j = 0; j < window.rows; ++j)
        for (std::uint32_t i = 0; i < window.columns; ++i) {
            const std::size_t from = std::size_t{j + kMargin} * inset.columns + i + kMargin,
                              to = std::size_t{j} * window.columns + i;
            if (!is_known(inset.post_class[from]) || window.post_class[to] == PostClass::outside) continue;
            // Where nothing is known below, there is nothing to blend with.
            const double weight = window.post_class[to] == PostClass::void_ ? 1.0 : (steps[from] - 1.0) / kBlendPosts;
            if (weight <= 0) continue;
            const bool is_sea =
                inset.post_class[from] == PostClass::sea && (weight >= 1 || window.post_class[to] == PostClass::sea);
            window.height_m[to] = static_cast<float>((1 - weight) * window.height_m[to] + weight * inset.height_m[from]);
            window.post_class[to] = is_sea ? PostClass::sea : PostClass::land;
        }
}

/// A sample between posts; corners without weight do not count.
struct Sample {
    double height_m = 0;
    bool known = true, sea = true;

    void add(double weight, float height, PostClass post_class) {
        if (weight <= 0) return;
        known = known && is_known(post_class);
        sea = sea && post_class == PostClass::sea;
        height_m += weight * height;
    }
};

double snapped(double place) {
    const double nearest = std::round(place);
    return std::abs(place - nearest) < kSnap ? nearest : place;
}

/// Posts of an inset that a stretch of lattice posts stands on: none where count is 0.
struct Stretch {
    std::uint32_t first = 0, count = 0;

    Stretch(double from, double to, std::uint32_t posts) {
        const double low = std::max(std::floor(from), 0.0), high = std::min(std::ceil(to), posts - 1.0);
        if (high < low) return;
        first = static_cast<std::uint32_t>(low);
        count = static_cast<std::uint32_t>(high - low) + 1;
    }
};

}  // namespace

InsetSampler::Axis InsetSampler::east_axis(const PostGrid& grid) const {
    // The same meridian has many names; the inset nearest to the lattice's middle is meant.
    const FileHeader& h = fine_.header;
    const double middle_deg = h.west_deg + 0.5 * h.step_lon_deg * (h.columns - 1);
    const double inset_deg = grid.west_deg + 0.5 * grid.step_lon_deg * (grid.columns - 1);
    const double west_deg = grid.west_deg + 360 * std::round((middle_deg - inset_deg) / 360);
    return {(h.west_deg - west_deg) / grid.step_lon_deg, h.step_lon_deg / grid.step_lon_deg};
}

InsetSampler::Axis InsetSampler::south_axis(const PostGrid& grid) const {
    const FileHeader& h = fine_.header;
    return {(grid.north_deg - h.north_deg) / grid.step_lat_deg, h.step_lat_deg / grid.step_lat_deg};
}

PostRange InsetSampler::footprint() {
    std::unique_ptr<PostReader> reader = readers_.take(open_);
    const PostGrid grid = reader->grid();
    readers_.give_back(std::move(reader));
    const auto within = [](const Axis& axis, std::uint32_t posts, std::uint32_t lattice_posts) {
        const double low = std::ceil(-axis.first / axis.step - kSnap),
                     high = std::floor((posts - 1 - axis.first) / axis.step + kSnap);
        const double last = lattice_posts - 1.0;
        return std::pair{std::clamp(low, 0.0, last + 1), std::clamp(high, -1.0, last)};
    };
    const auto [west, east] = within(east_axis(grid), grid.columns, fine_.header.columns);
    const auto [north, south] = within(south_axis(grid), grid.rows, fine_.header.rows);
    if (east < west || south < north) return {1, 1, 0, 0};
    return {static_cast<std::uint32_t>(west), static_cast<std::uint32_t>(north), static_cast<std::uint32_t>(east),
            static_cast<std::uint32_t>(south)};
}

void InsetSampler::read(LatticeWindow& window) {
    window.height_m.assign(std::size_t{window.columns} * window.rows, 0.0f);
    window.post_class.assign(window.height_m.size(), PostClass::void_);
    std::unique_ptr<PostReader> reader = readers_.take(open_);
    const PostGrid& grid = reader->grid();
    const Axis east = east_axis(grid), south = south_axis(grid);
    const auto x_of = [&](std::int64_t i) { return snapped(east.first + east.step * static_cast<double>(i)); };
    const auto y_of = [&](std::int64_t j) { return snapped(south.first + south.step * static_cast<double>(j)); };
    const Stretch columns(x_of(window.i0), x_of(window.i0 + window.columns - 1), grid.columns),
        rows(y_of(window.j0), y_of(window.j0 + window.rows - 1), grid.rows);
    std::vector<float> heights(std::size_t{columns.count} * rows.count);
    std::vector<PostClass> classes(heights.size());
    if (!heights.empty()) reader->read(columns.first, rows.first, columns.count, rows.count, heights, classes);
    for (std::int64_t j = window.j0; !heights.empty() && j < window.j0 + window.rows; ++j)
        for (std::int64_t i = window.i0; i < window.i0 + window.columns; ++i) {
            const double x = x_of(i), y = y_of(j);
            if (!(x >= 0 && y >= 0 && x <= grid.columns - 1.0 && y <= grid.rows - 1.0)) continue;
            const double a = std::min(std::floor(x), grid.columns - 2.0), b = std::min(std::floor(y), grid.rows - 2.0);
            const double u = x - a, v = y - b;
            const std::size_t nw =
                (static_cast<std::size_t>(b) - rows.first) * columns.count + static_cast<std::size_t>(a) - columns.first;
            Sample sample;
            const double weights[4] = {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v};
            for (std::size_t n = 0; n < 4; ++n)
                if (weights[n] > 0) {
                    const std::size_t at = nw + (n / 2) * columns.count + n % 2;
                    sample.add(weights[n], heights[at], classes[at]);
                }
            if (!sample.known) continue;
            window.height_m[window.at(i, j)] = static_cast<float>(sample.height_m);
            window.post_class[window.at(i, j)] = sample.sea ? PostClass::sea : PostClass::land;
        }
    readers_.give_back(std::move(reader));
}

PostStatistics InsetImport::import(const PostRange& block) {
    LatticeWindow window = window_of(block, 0);
    interpolate_posts(coarse_, shift_, window);
    for (const std::unique_ptr<InsetSampler>& sampler : insets_) {
        LatticeWindow inset = window_of(block, kMargin);
        sampler->read(inset);
        blend(inset, window);
    }
    posts_.write(window);
    PostStatistics statistics;
    statistics.include({window.height_m.data(), window.height_m.size()}, {window.post_class.data(), window.post_class.size()});
    return statistics;
}

void InsetImport::write_back(const PostRange& block, PostsFile& coarse) const {
    LatticeWindow window = window_of(block, 0);
    posts_.read(window);
    const std::uint32_t side = 1u << shift_;
    for (std::uint32_t j = block.j0; j <= block.j1; j += side)
        for (std::uint32_t i = block.i0; i <= block.i1; i += side) {
            const std::size_t n = window.at(i, j);
            coarse.write(i >> shift_, j >> shift_, 1, 1, {&window.height_m[n], 1}, {&window.post_class[n], 1});
        }
}

void InsetImport::fill_voids(const PostRange& block) {
    LatticeWindow window = window_of(block, 0);
    posts_.read(window);
    if (std::find(window.post_class.begin(), window.post_class.end(), PostClass::void_) == window.post_class.end()) return;
    LatticeWindow filled = window_of(block, 0);
    interpolate_posts(coarse_, shift_, filled);
    for (std::size_t n = 0; n < window.height_m.size(); ++n)
        if (window.post_class[n] == PostClass::void_) window.height_m[n] = filled.height_m[n];
    posts_.write(window);
}

}  // namespace tedavis::host_sim
