/// Shannon's entropy and information.
#pragma once

#include <cstdint>

#include "render_core/base/span.hpp"

namespace tedavis::perception {

/// Returns the entropy of a distribution in bits: the sum of -p log2 p, with p the share of each count and 0 log 0 = 0. 0
/// without counts.
[[nodiscard]] double shannon_entropy(base::Span<const std::uint32_t> counts) noexcept;

/// Returns the information, in bits, of an event that `count` of `total` pixels show: -log2 p. p = (count + 1) / (total + 2),
/// Laplace's estimate, so that it is finite and not 0, whatever the count.
[[nodiscard]] double information(std::uint64_t count, std::uint64_t total) noexcept;
/// Returns the information of an event that none of `total` pixels shows.
[[nodiscard]] double most_information(std::uint64_t total) noexcept;

}  // namespace tedavis::perception
