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

/// The sums have 24 bits: their upper and lower bytes are added up apart, so that sixteen suffice for each.
template <int Radius>
void blur_down_by(const BlurRows& rows, std::uint8_t* __restrict out, int count, const std::uint16_t* weights) {
    for (int i = 0; i < count; ++i) {
        const std::uint16_t middle = rows[Radius][i];
        auto low = static_cast<std::uint16_t>(weights[0] * (middle & 0xFF));
        auto high = static_cast<std::uint16_t>(weights[0] * (middle >> 8));
        for (int k = 1; k <= Radius; ++k) {
            const std::uint16_t above = rows[Radius - k][i], below = rows[Radius + k][i];
            low = static_cast<std::uint16_t>(low + weights[k] * ((above & 0xFF) + (below & 0xFF)));
            high = static_cast<std::uint16_t>(high + weights[k] * ((above >> 8) + (below >> 8)));
        }
        out[i] = static_cast<std::uint8_t>(static_cast<std::uint16_t>(high + (low >> 8) + 128) >> 8);
    }
}

using AcrossByRadius = void (*)(const std::uint8_t*, std::uint16_t*, int, const std::uint16_t*);
using DownByRadius = void (*)(const BlurRows&, std::uint8_t*, int, const std::uint16_t*);

template <int... Radius>
constexpr std::array<AcrossByRadius, kMaxRadius + 1> across_table(std::integer_sequence<int, Radius...>) {
    return {blur_across_by<Radius>...};
}
template <int... Radius>
constexpr std::array<DownByRadius, kMaxRadius + 1> down_table(std::integer_sequence<int, Radius...>) {
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

/// All bits of a number or none, by bits of a mask: `one` where they are set.
std::int32_t either(std::int32_t mask, std::int32_t one, std::int32_t other) { return other ^ ((one ^ other) & mask); }
std::int32_t mask_of(bool holds) { return -static_cast<std::int32_t>(holds); }

/// 0: no edge, 1: weak, 2: strong.
void thin_block(const GradientRows& rows, int first, const EdgeThresholds& thresholds, std::int32_t* __restrict out) {
    BlockDirections to;
    find_directions(rows.here.across + first, rows.here.down + first, to);
    const std::int32_t *here = rows.here.squared + first, *above = rows.above + first, *below = rows.below + first;
    for (int i = 0; i < kRowBlock; ++i) {
        const std::int32_t across = to.is_across[i], down = to.is_down[i], falls = to.falls[i];
        const std::int32_t upper = either(falls, above[i + kColors], above[i - kColors]);
        const std::int32_t lower = either(falls, below[i - kColors], below[i + kColors]);
        const std::int32_t before = either(across, here[i - kColors], either(down, above[i], upper));
        const std::int32_t after = either(across, here[i + kColors], either(down, below[i], lower));
        const std::int32_t is_crest = mask_of(here[i] > before) & mask_of(here[i] - (across | down) > after);
        out[i] = (mask_of(here[i] > thresholds.low) & is_crest & 1) + (mask_of(here[i] > thresholds.high) & is_crest & 1);
    }
}

bool has_any_above(const std::int32_t* squared, std::int32_t low) {
    std::int32_t any = 0;
    for (int i = 0; i < kRowBlock; ++i) any |= squared[i] > low ? -1 : 0;
    return any != 0;
}

}  // namespace

void repeat_ends(std::uint8_t* row, int width, int times) noexcept {
    std::uint8_t* end = row + kColors * width;
    for (int n = 0; n < times; ++n) {
        std::memcpy(row - kColors * (n + 1), row, kColors);
        std::memcpy(end + kColors * n, end - kColors, kColors);
    }
}

void blur_across(const std::uint8_t* source, std::uint16_t* out, int width, const GaussianWeights& weights) noexcept {
    static constexpr auto kTable = across_table(std::make_integer_sequence<int, kMaxRadius + 1>());
    kTable[weights.radius](source, out, elements_of(width), weights.at.data());
}

void blur_down(const BlurRows& rows, std::uint8_t* out, int width, const GaussianWeights& weights) noexcept {
    static constexpr auto kTable = down_table(std::make_integer_sequence<int, kMaxRadius + 1>());
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
        std::int32_t kinds[kRowBlock];
        thin_block(rows, kColors * x, thresholds, kinds);
        const int pixels = width - x < kPixels ? width - x : kPixels;
        for (int n = 0; n < pixels; ++n) {
            const std::int32_t* kind = kinds + kColors * n;
            edges[x + n] = static_cast<std::uint8_t>(kBits[kind[0]] | kBits[kind[1]] << 1 | kBits[kind[2]] << 2);
        }
    }
}

}  // namespace tedavis::perception
