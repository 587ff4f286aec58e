/// Random numbers that are the same on every machine: the generator is standardised, the distributions are our own.
#pragma once

#include <cstdint>
#include <random>

namespace tedavis::host_sim {

class SeededRandom {
public:
    explicit SeededRandom(std::uint64_t seed) : engine_(seed) {}

    /// Uniform in [0, 1), 53 bits.
    [[nodiscard]] double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    /// Uniform in [low, high).
    [[nodiscard]] double between(double low, double high) { return low + (high - low) * unit(); }
    /// Uniform in [centre - spread, centre + spread).
    [[nodiscard]] double within(double centre, double spread) { return centre + spread * (2 * unit() - 1); }

private:
    std::mt19937_64 engine_;
};

}  // namespace tedavis::host_sim
