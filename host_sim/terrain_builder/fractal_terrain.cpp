#include "host_sim/terrain_builder/fractal_terrain.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/check.hpp"

namespace tedavis::host_sim {
namespace {

constexpr float kMeanLand_m = 1100, kHighest_m = 4000, kBendFrom_m = 3000;
constexpr float kSlope = 4.4f;                         // amplitude over wavelength in posts, in metres
constexpr float kContinent_m = 2800;                   // of octaves that are too long to be mountains
constexpr int kFirstRidged = 7, kFirstContinent = 10;  // log2 of the wavelength in posts

/// Pythagorean triples: turns by rational angles.
struct Rotation {
    std::int64_t cosine, sine, hypotenuse;
};
constexpr std::array<Rotation, 4> kRotations = {{{12, 5, 13}, {4, 3, 5}, {24, 7, 25}, {20, 21, 29}}};

/// Steele, Lea, Flood 2014: the finishing steps of SplitMix64.
std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

struct Gradient {
    float u, v;  ///< from -1 to 1
};

Gradient gradient(std::uint64_t key, std::int64_t cell_u, std::int64_t cell_v) {
    constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15u;
    const std::uint64_t place = static_cast<std::uint64_t>(cell_u) << 32 ^ (static_cast<std::uint64_t>(cell_v) & 0xFFFFFFFFu);
    const std::uint64_t bits = mixed(key + place * kGolden);
    constexpr float kUnit = 1.0f / 8388608.0f;  // 2^-23
    return {static_cast<float>(bits >> 40) * kUnit - 1.0f, static_cast<float>(bits >> 16 & 0xFFFFFFu) * kUnit - 1.0f};
}

/// Gradients at the corners of a cell.
struct Cell {
    Gradient a, b, c, d;

    Cell(std::uint64_t key, std::int64_t u, std::int64_t v)
        : a(gradient(key, u, v)), b(gradient(key, u + 1, v)), c(gradient(key, u, v + 1)), d(gradient(key, u + 1, v + 1)) {}

    /// Perlin 2002, with u and v from 0 to 1 across the cell; about -0.9 to 0.9.
    [[nodiscard]] float noise(float u, float v) const {
        const float fade_u = u * u * u * (u * (u * 6 - 15) + 10), fade_v = v * v * v * (v * (v * 6 - 15) + 10);
        const float at_a = a.u * u + a.v * v, at_b = b.u * (u - 1) + b.v * v, at_c = c.u * u + c.v * (v - 1),
                    at_d = d.u * (u - 1) + d.v * (v - 1);
        const float north = at_a + fade_u * (at_b - at_a), south = at_c + fade_u * (at_d - at_c);
        return north + fade_v * (south - north);
    }
};

/// Crests where the noise changes its sign; the mean is about zero.
float folded(float noise) {
    const float crest = 1 - 1.25f * std::abs(noise);
    return crest * crest - 0.55f;
}

std::int64_t floor_divide(std::int64_t a, std::int64_t b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

/// Summits bend gently towards the highest height; the sea is flat.
float settled(float height_m) {
    if (height_m <= 0) return 0;
    if (height_m <= kBendFrom_m) return height_m;
    const float above = (height_m - kBendFrom_m) / (kHighest_m - kBendFrom_m);
    return kBendFrom_m + (kHighest_m - kBendFrom_m) * (above / (1 + above));
}

}  // namespace

FractalTerrain::FractalTerrain(std::uint64_t seed) {
    for (int n = 0; n < kOctaves; ++n) {
        // Wavelengths of 2 to 512 posts, then two of continents: 2048 and 8192.
        const int power = n < 9 ? n + 1 : 2 * n - 7;
        const Rotation& turn = kRotations[static_cast<std::size_t>(n) % kRotations.size()];
        const std::uint64_t key = mixed(mixed(seed) + static_cast<std::uint64_t>(power));
        const bool continent = power >= kFirstContinent;
        const std::int64_t side = turn.hypotenuse << power;
        octaves_[static_cast<std::size_t>(n)] = {turn.cosine,
                                                 turn.sine,
                                                 side,
                                                 static_cast<std::int64_t>(mixed(key + 1) % static_cast<std::uint64_t>(side)),
                                                 static_cast<std::int64_t>(mixed(key + 2) % static_cast<std::uint64_t>(side)),
                                                 key,
                                                 continent ? kContinent_m : kSlope * static_cast<float>(1 << power),
                                                 power >= kFirstRidged && !continent};
    }
}

void FractalTerrain::add_octave(const Octave& o, std::int32_t i, std::int32_t j, base::Span<float> row) const {
    const std::int64_t u = o.cosine * i - o.sine * j + o.offset_u, v = o.sine * i + o.cosine * j + o.offset_v;
    std::int64_t cell_u = floor_divide(u, o.side), cell_v = floor_divide(v, o.side);
    std::int64_t in_u = u - cell_u * o.side, in_v = v - cell_v * o.side;
    Cell cell(o.key, cell_u, cell_v);
    const float scale = 1.0f / static_cast<float>(o.side);
    for (float& height_m : row) {
        const float noise = cell.noise(static_cast<float>(in_u) * scale, static_cast<float>(in_v) * scale);
        height_m += o.amplitude_m * (o.ridged ? folded(noise) : noise);
        in_u += o.cosine;
        in_v += o.sine;
        if (in_u < o.side && in_v < o.side) continue;
        if (in_u >= o.side) in_u -= o.side, ++cell_u;
        if (in_v >= o.side) in_v -= o.side, ++cell_v;
        cell = Cell(o.key, cell_u, cell_v);
    }
}

void FractalTerrain::read(std::int32_t i, std::int32_t j, std::uint32_t columns, std::uint32_t rows,
                          base::Span<float> heights_m) const {
    TEDAVIS_CHECK(heights_m.size() == std::size_t{columns} * rows);
    for (std::uint32_t b = 0; b < rows; ++b) {
        const base::Span<float> row = heights_m.subspan(std::size_t{b} * columns, columns);
        std::fill(row.begin(), row.end(), kMeanLand_m);
        for (const Octave& octave : octaves_) add_octave(octave, i, j + static_cast<std::int32_t>(b), row);
        for (float& height_m : row) height_m = settled(height_m);
    }
}

}  // namespace tedavis::host_sim
