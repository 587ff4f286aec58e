#include "target/can_latency.hpp"

#include <algorithm>

namespace tedavis::target {

void CanLatency::received(base::Time stamp) {
    if (!has_oldest_ || stamp < oldest_) oldest_ = stamp;
    has_oldest_ = true;
}

std::optional<base::Duration> CanLatency::shown(base::Time shown) {
    std::optional<base::Duration> latency;
    if (has_oldest_) latency = std::max(base::Duration{}, shown - oldest_);
    // The first picture has none before it.
    if (latency && has_shown_) add(*latency, shown - shown_);
    has_oldest_ = false;
    has_shown_ = true;
    shown_ = shown;
    return latency;
}

void CanLatency::add(base::Duration latency, base::Duration period) {
    const auto bin = static_cast<std::size_t>(latency.ns / kBin.ns);
    ++bins_[std::min(bin, kBins - 1)];
    const double pictures = period.ns > 0 ? latency.to_seconds() / period.to_seconds() : 0;
    const double most_bins = static_cast<double>(kBins - 1);
    ++bins_of_pictures_[static_cast<std::size_t>(std::min(pictures / kBinOfPictures, most_bins))];
    longest_ = std::max(longest_, latency);
    most_pictures_ = std::max(most_pictures_, pictures);
    ++count_;
}

std::size_t CanLatency::bin_of(const Bins& bins, double share) const {
    std::uint64_t sum = 0;
    for (std::size_t n = 0; n < kBins; ++n) {
        sum += bins[n];
        if (static_cast<double>(sum) >= share * static_cast<double>(count_)) return n;
    }
    return kBins - 1;
}

LatencyReport CanLatency::report() const {
    if (count_ == 0) return {};
    const auto until = [&](double share) {
        const std::size_t bin = bin_of(bins_, share);
        return bin + 1 == kBins ? longest_ : std::min(longest_, base::Duration{kBin.ns * static_cast<std::int64_t>(bin + 1)});
    };
    const std::size_t bin = bin_of(bins_of_pictures_, 0.99);
    const double end = bin + 1 == kBins ? most_pictures_ : kBinOfPictures * static_cast<double>(bin + 1);
    return {count_, until(0.5), until(0.99), longest_, std::min(most_pictures_, end), most_pictures_};
}

}  // namespace tedavis::target
