/// The time from a frame of the CAN bus to the screen: from the kernel's stamp of the oldest frame that a picture is the first to
/// hold, until the screen has shown that picture.
///
/// Sorted into bins of fixed width as they come, so that percentiles over a flight of any length need no more memory.
///
/// Thread  one. Memory  inside, fixed. Time  the monotonic clock's. Failure  none: a time before its frame's stamp counts as 0.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "render_core/base/time.hpp"

namespace tedavis::target {

/// Percentiles are the upper ends of their bins, so they are never too small. Without pictures all are 0.
struct LatencyReport {
    std::uint64_t pictures = 0;  ///< that were the first to hold a frame of the bus
    base::Duration median, p99, longest;
    /// The same in pictures: each time is divided by the time from the picture before it on the screen to its own.
    double p99_pictures = 0, most_pictures = 0;
};
static_assert(std::is_trivially_copyable_v<LatencyReport>);

class CanLatency {
public:
    /// A frame of the bus, received at `stamp`, is in the next picture.
    void received(base::Time stamp);
    /// The screen has shown that picture since `shown`; returns the time from the oldest of its frames, nothing where it holds
    /// none. Where the screen has not shown a picture, its frames wait for the next.
    std::optional<base::Duration> shown(base::Time shown);
    /// Nobody could see that picture: its frames are not counted.
    void hidden() { has_oldest_ = has_shown_ = false; }
    [[nodiscard]] LatencyReport report() const;

private:
    static constexpr base::Duration kBin = base::Duration::milliseconds(1);
    static constexpr double kBinOfPictures = 1.0 / 16;
    static constexpr std::size_t kBins = 1024;  ///< what is longer is in the last one
    using Bins = std::array<std::uint64_t, kBins>;

    void add(base::Duration latency, base::Duration period);
    /// The number of the bin that holds this share of all.
    [[nodiscard]] std::size_t bin_of(const Bins& bins, double share) const;

    bool has_oldest_ = false, has_shown_ = false;
    base::Time oldest_, shown_;
    std::uint64_t count_ = 0;
    base::Duration longest_;
    double most_pictures_ = 0;
    Bins bins_{}, bins_of_pictures_{};
};

}  // namespace tedavis::target
