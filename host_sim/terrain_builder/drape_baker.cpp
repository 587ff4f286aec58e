#include "host_sim/terrain_builder/drape_baker.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace tedavis::host_sim {
namespace {

using namespace terrain;

/// The pages below one page and beside those: texels from one before its first to one after its last.
class FinerPages {
public:
    static constexpr std::int64_t kAcross = 4;

    FinerPages(const Lattice& lattice, const ChunkKey& finer_corner)
        : level_(finer_corner.level),
          i0_(std::int64_t{finer_corner.i} - 1),
          j0_(std::int64_t{finer_corner.j} - 1),
          last_column_(std::int64_t{lattice.grid_columns(level_)} * kDrapeSteps),
          last_row_(std::int64_t{lattice.grid_rows(level_)} * kDrapeSteps) {}

    template <class Load>
    void load(const Lattice& lattice, Load load) {
        for (std::int64_t n = 0; n < kAcross * kAcross; ++n) {
            const std::int64_t i = i0_ + n % kAcross, j = j0_ + n / kAcross;
            if (i < 0 || j < 0) continue;
            const ChunkKey key{level_, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)};
            if (lattice.contains(key)) pages_[static_cast<std::size_t>(n)] = load(key);
        }
    }
    /// By its place in the whole level; beyond the level its border. Null: the image has nothing there.
    [[nodiscard]] const std::uint8_t* texel(std::int64_t x, std::int64_t y) const {
        x = std::clamp<std::int64_t>(x, 0, last_column_);
        y = std::clamp<std::int64_t>(y, 0, last_row_);
        // The last texels of the last pages are no other page's first.
        const std::int64_t i = x == last_column_ ? x / kDrapeSteps - 1 : x / kDrapeSteps,
                           j = y == last_row_ ? y / kDrapeSteps - 1 : y / kDrapeSteps;
        const auto& page = pages_[static_cast<std::size_t>((j - j0_) * kAcross + i - i0_)];
        return page == nullptr ? nullptr : page->rgba[(y - j * kDrapeSteps) * kDrapePosts + x - i * kDrapeSteps];
    }

private:
    std::uint32_t level_;
    std::int64_t i0_, j0_, last_column_, last_row_;
    std::array<std::unique_ptr<DrapePage>, kAcross * kAcross> pages_;
};

/// A quarter of the texel's own place and of each half beside it, both ways.
void mean_texel(const FinerPages& finer, std::int64_t x, std::int64_t y, std::uint8_t* rgba) {
    std::array<std::uint32_t, 4> sum{};
    for (int down = -1; down <= 1; ++down)
        for (int east = -1; east <= 1; ++east) {
            const std::uint8_t* const texel = finer.texel(x + east, y + down);
            const std::uint32_t weight = (east == 0 ? 2u : 1u) * (down == 0 ? 2u : 1u);
            for (std::size_t c = 0; c < 4 && texel != nullptr; ++c) sum[c] += weight * texel[c];
        }
    for (std::size_t c = 0; c < 4; ++c) rgba[c] = static_cast<std::uint8_t>((sum[c] + 8) / 16);
}

bool shows_nothing(const DrapePage& page) {
    return std::none_of(std::begin(page.rgba), std::end(page.rgba), [](const std::uint8_t(&texel)[4]) { return texel[3] != 0; });
}

}  // namespace

DrapeBaker::DrapeBaker(const BuildPlan& coarse, std::uint32_t base_level, const DrapeOptions& options, const PartStore& store,
                       PlaceOf place_of)
    : coarse_(coarse), base_level_(base_level), sampler_(coarse, options), store_(store), place_of_(std::move(place_of)) {}

std::uint32_t DrapeBaker::task_count(std::uint32_t level) const {
    return coarse_.lattice.grid_columns(level) * coarse_.lattice.grid_rows(level);
}

std::optional<BakedPage> DrapeBaker::run(std::uint32_t level, std::uint32_t task) {
    const std::uint32_t across = coarse_.lattice.grid_columns(level), i = task % across, j = task / across;
    const auto page = std::make_unique<DrapePage>();
    if (level == first_level())
        sampler_.sample(i, j, *page);
    else
        reduce(level, i, j, *page);
    if (shows_nothing(*page)) return std::nullopt;
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(page.get());
    return BakedPage{
        {level + base_level_, i, j}, {0, sizeof *page, checksum(bytes, sizeof *page)}, {bytes, bytes + sizeof *page}};
}

void DrapeBaker::reduce(std::uint32_t level, std::uint32_t i, std::uint32_t j, DrapePage& page) const {
    FinerPages finer(coarse_.lattice, {level - 1, 2 * i, 2 * j});
    finer.load(coarse_.lattice, [this](const ChunkKey& key) -> std::unique_ptr<DrapePage> {
        const PartPlace place = place_of_({key.level + base_level_, key.i, key.j});
        if (place.bytes == 0) return nullptr;
        auto below = std::make_unique<DrapePage>();
        store_.get(place, reinterpret_cast<std::uint8_t*>(below.get()));
        return below;
    });
    for (std::uint32_t b = 0; b < kDrapePosts; ++b)
        for (std::uint32_t a = 0; a < kDrapePosts; ++a)
            mean_texel(finer, 2 * (std::int64_t{i} * kDrapeSteps + a), 2 * (std::int64_t{j} * kDrapeSteps + b),
                       page.rgba[std::size_t{b} * kDrapePosts + a]);
}

}  // namespace tedavis::host_sim
