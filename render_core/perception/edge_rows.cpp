#include "render_core/perception/edge_rows.hpp"

#include <cstring>
#include <utility>

namespace tedavis::perception {
namespace {

/// Of a row, of whole blocks.
int elements_of(int width) { return static_cast<int>(row_elements(width)) - 2 * kRowLead; }

template <int Radius>
void blur_across_by(const std::uint8_t* __restrict source, std::uint16_t* __restrict out, int count,
                    const std::uint16_t* weights) {
    for (int i = 0; i < count; ++i) {
        int sum = weights[0] * source[i];
        for (int k = 1; k <= Radius; ++k) sum += weights[k] * (source[i - kColors * k] + source[i + kColors * k]);
        out[i] = static_cast<std::uint16_t>(sum);
    }
}

template <int Radius>
void blur_down_by(const BlurRows& rows, std::uint8_t* __restrict out, int count, const std::uint16_t* weights) {
    const std::uint16_t* row[2 * Radius + 1];
    for (int k = 0; k <= 2 * Radius; ++k) row[k] = rows[k];
    for (int i = 0; i < count; ++i) {
        std::uint32_t sum = 1u << 15;
        for (int k = -Radius; k <= Radius; ++k)
            sum += static_cast<std::uint32_t>(weights[k < 0 ? -k : k]) * static_cast<std::uint32_t>(row[Radius + k][i]);
        out[i] = static_cast<std::uint8_t>(sum >> 16);
    }
}

using AcrossByRadius = void (*)(const std::uint8_t*, std::uint16_t*, int, const std::uint16_t*);
using DownByRadius = void (*)(const BlurRows&, std::uint8_t*, int, const std::uint16_t*);

template <int... Radius>
constexpr std::array<AcrossByRadius, kMostRadius + 1> across_table(std::integer_sequence<int, Radius...>) {
    return {blur_across_by<Radius>...};
}
template <int... Radius>
constexpr std::array<DownByRadius, kMostRadius + 1> down_table(std::integer_sequence<int, Radius...>) {
    return {blur_down_by<Radius>...};
}

/// Which way a gradient points, one of three as masks; `falls`: along the diagonal from the upper right.
struct BlockDirections {
    std::int16_t is_across[kRowBlock], is_down[kRowBlock], falls[kRowBlock];
};

void find_directions(const std::int16_t* __restrict across, const std::int16_t* __restrict down, BlockDirections& out) {
    // tan(22.5 degrees) in 65536ths; that of 67.5 degrees is larger by 2.
    constexpr int kTangent = 27146;
    for (int i = 0; i < kRowBlock; ++i) {
        const std::int16_t x = static_cast<std::int16_t>(across[i] < 0 ? -across[i] : across[i]);
        const std::int16_t y = static_cast<std::int16_t>(down[i] < 0 ? -down[i] : down[i]);
        const std::int16_t part = static_cast<std::int16_t>((x * kTangent) >> 16);
        out.is_across[i] = y <= part ? -1 : 0;
        out.is_down[i] = static_cast<std::int16_t>(y - 2 * x) > part ? -1 : 0;
        out.falls[i] = static_cast<std::int16_t>(across[i] ^ down[i]) < 0 ? -1 : 0;
    }
}

/// 0: no edge, 1: weak, 2: strong.
void thin_block(const GradientRows& rows, int first, const EdgeThresholds& thresholds, std::uint8_t* __restrict out) {
    BlockDirections to;
    find_directions(rows.here.across + first, rows.here.down + first, to);
    const std::int32_t *here = rows.here.squared + first, *above = rows.above + first, *below = rows.below + first;
    for (int i = 0; i < kRowBlock; ++i) {
        const std::int32_t across = to.is_across[i], down = to.is_down[i], falls = to.falls[i];
        const std::int32_t diagonal_above = falls != 0 ? above[i + kColors] : above[i - kColors];
        const std::int32_t diagonal_below = falls != 0 ? below[i - kColors] : below[i + kColors];
        const std::int32_t before = across != 0 ? here[i - kColors] : down != 0 ? above[i] : diagonal_above;
        const std::int32_t after = across != 0 ? here[i + kColors] : down != 0 ? below[i] : diagonal_below;
        const std::int32_t or_equal = (across | down) & 1;
        const bool is_crest = (here[i] > before) & (here[i] + or_equal > after) & (here[i] > thresholds.low);
        out[i] = static_cast<std::uint8_t>(is_crest ? (here[i] > thresholds.high ? 2 : 1) : 0);
    }
}

bool has_any_above(const std::int32_t* squared, std::int32_t low) {
    std::int32_t any = 0;
    for (int i = 0; i < kRowBlock; ++i) any |= squared[i] > low ? -1 : 0;
    return any != 0;
}

}  // namespace

void repeat_ends(std::uint8_t* row, int width) noexcept {
    std::uint8_t* last = row + kColors * (width - 1);
    for (int i = 1; i <= kRowLead; ++i) row[-i] = row[(3 * kRowLead - i) % kColors];
    for (int i = 0; i < kRowLead; ++i) last[kColors + i] = last[i % kColors];
}

void blur_across(const std::uint8_t* source, std::uint16_t* out, int width, const GaussianWeights& weights) noexcept {
    static constexpr auto kTable = across_table(std::make_integer_sequence<int, kMostRadius + 1>());
    kTable[weights.radius](source, out, elements_of(width), weights.at.data());
}

void blur_down(const BlurRows& rows, std::uint8_t* out, int width, const GaussianWeights& weights) noexcept {
    static constexpr auto kTable = down_table(std::make_integer_sequence<int, kMostRadius + 1>());
    kTable[weights.radius](rows, out, elements_of(width), weights.at.data());
}

void gradient(const LevelRows& levels, std::int16_t* sums, int width, const GradientRow& out) noexcept {
    const int count = elements_of(width);
    const auto stride = static_cast<std::ptrdiff_t>(row_elements(width));
    std::int16_t* __restrict smooth = sums + kRowLead, * __restrict steep = sums + kRowLead + stride;
    const std::uint8_t *above = levels.above, *here = levels.here, *below = levels.below;
    for (int i = -kColors; i < count + kColors; ++i) {
        smooth[i] = static_cast<std::int16_t>(above[i] + 2 * here[i] + below[i]);
        steep[i] = static_cast<std::int16_t>(below[i] - above[i]);
    }
    std::int16_t* __restrict across = out.across, * __restrict down = out.down;
    std::int32_t* __restrict squared = out.squared;
    for (int i = 0; i < count; ++i) {
        const auto x = static_cast<std::int16_t>(smooth[i + kColors] - smooth[i - kColors]);
        const auto y = static_cast<std::int16_t>(steep[i - kColors] + 2 * steep[i] + steep[i + kColors]);
        across[i] = x;
        down[i] = y;
        squared[i] = x * x + y * y;
    }
    for (int i = kColors * width; i < count + kColors; ++i) squared[i] = 0;
}

void thin(const GradientRows& rows, const EdgeThresholds& thresholds, int width, std::uint8_t* edges) noexcept {
    constexpr int kPixels = kRowBlock / kColors;
    constexpr std::uint8_t kBits[3] = {0x00, 0x01, 0x10};
    std::memset(edges, 0, static_cast<std::size_t>(width));
    for (int x = 0; x < width; x += kPixels) {
        if (!has_any_above(rows.here.squared + kColors * x, thresholds.low)) continue;
        std::uint8_t kinds[kRowBlock];
        thin_block(rows, kColors * x, thresholds, kinds);
        const int pixels = width - x < kPixels ? width - x : kPixels;
        for (int n = 0; n < pixels; ++n) {
            const std::uint8_t* kind = kinds + kColors * n;
            edges[x + n] = static_cast<std::uint8_t>(kBits[kind[0]] | kBits[kind[1]] << 1 | kBits[kind[2]] << 2);
        }
    }
}

}  // namespace tedavis::perception
