#include "host_sim/replay/interval_track.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <type_traits>
#include <utility>

#include "host_sim/replay/byte_stream.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/check.hpp"

namespace tedavis::host_sim {
namespace {

constexpr char kIntervalMagic[] = "TEDAVIS intervals 2\n";
constexpr int kQuickIntervalCompression = 1;

/// All that an interval leaves to the next one, and to the frames in it.
constexpr std::size_t kBoostBytes = sizeof(policy::PriorityBoost), kLabelBytes = sizeof(display::LabelHistory);
static_assert(std::is_trivially_copyable_v<policy::PriorityBoost> && std::is_trivially_copyable_v<display::LabelHistory>);

std::string packed_interval(const display::PlannerMemory& decided) {
    unsigned char plain[kBoostBytes + kLabelBytes];
    std::memcpy(plain, &decided.boost, kBoostBytes);
    std::memcpy(plain + kBoostBytes, &decided.labels, kLabelBytes);
    uLongf size = compressBound(sizeof plain);
    std::string bytes(size, '\0');
    const int code = compress2(reinterpret_cast<Bytef*>(bytes.data()), &size, plain, sizeof plain, kQuickIntervalCompression);
    TEDAVIS_CHECK(code == Z_OK);
    bytes.resize(size);
    bytes.shrink_to_fit();
    return bytes;
}

display::PlannerMemory unpacked_interval(const std::string& bytes) {
    unsigned char plain[kBoostBytes + kLabelBytes];
    uLongf size = sizeof plain;
    const int code = uncompress(plain, &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    if (code != Z_OK || size != sizeof plain) throw UserError("a checkpoint of the labels is damaged; delete the .tdi file");
    display::PlannerMemory memory;
    std::memcpy(&memory.boost, plain, kBoostBytes);
    std::memcpy(&memory.labels, plain + kBoostBytes, kLabelBytes);
    return memory;
}

}  // namespace

std::size_t IntervalTrack::plain_bytes() { return kBoostBytes + kLabelBytes; }

void IntervalTrack::keep(std::int64_t interval, const display::PlannerMemory& decided) {
    if (interval % kEvery == 0 && packed_.count(interval) == 0) packed_[interval] = packed_interval(decided);
    recent_[interval] = decided;
    if (alerts_.empty()) first_alert_ = interval;
    if (interval == first_alert_ + static_cast<std::int64_t>(alerts_.size()))
        alerts_.push_back(static_cast<char>(decided.boost.terrain_ahead()));
    while (recent_.size() > kRecent) {
        const bool is_first_farther = interval - recent_.begin()->first >= recent_.rbegin()->first - interval;
        recent_.erase(is_first_farther ? recent_.begin() : std::prev(recent_.end()));
    }
}

std::optional<std::int64_t> IntervalTrack::last_by(std::int64_t interval) const {
    std::optional<std::int64_t> last;
    if (const auto next = packed_.upper_bound(interval); next != packed_.begin()) last = std::prev(next)->first;
    if (const auto next = recent_.upper_bound(interval); next != recent_.begin())
        last = std::max(last.value_or(std::prev(next)->first), std::prev(next)->first);
    return last;
}

display::PlannerMemory IntervalTrack::restore(std::int64_t interval) const {
    if (const auto recent = recent_.find(interval); recent != recent_.end()) return recent->second;
    return unpacked_interval(packed_.at(interval));
}

std::optional<policy::TerrainAhead> IntervalTrack::alert(std::int64_t interval) const {
    if (interval < first_alert_ || interval >= first_alert_ + static_cast<std::int64_t>(alerts_.size())) return std::nullopt;
    return static_cast<policy::TerrainAhead>(alerts_[static_cast<std::size_t>(interval - first_alert_)]);
}

void IntervalTrack::take_alerts(std::int64_t first, std::string alerts) {
    first_alert_ = first;
    alerts_ = std::move(alerts);
}

void IntervalTrack::clear() {
    packed_.clear();
    recent_.clear();
    alerts_.clear();
}

std::string pack_intervals(const IntervalTrack& track, std::string_view made_from) {
    ByteWriter writer;
    writer.put(kIntervalMagic);
    writer.put(std::uint64_t{IntervalTrack::plain_bytes()});
    writer.put_text(made_from);
    writer.put(track.first_alert());
    writer.put_text(track.alerts());
    writer.put(std::uint64_t{track.packed().size()});
    for (const auto& [interval, bytes] : track.packed()) {
        writer.put(interval);
        writer.put_text(bytes);
    }
    writer.put(checksum_of(writer.bytes()));
    return writer.take();
}

std::optional<IntervalTrack> unpack_intervals(std::string_view bytes, std::string_view made_from) {
    constexpr std::size_t kSumBytes = sizeof(std::uint64_t);
    const std::string_view magic(kIntervalMagic, sizeof kIntervalMagic);
    if (bytes.size() < magic.size() + kSumBytes || bytes.substr(0, magic.size()) != magic) return std::nullopt;
    const std::string_view body = bytes.substr(0, bytes.size() - kSumBytes);
    if (ByteReader(bytes.substr(body.size())).get<std::uint64_t>() != checksum_of(body)) return std::nullopt;
    ByteReader reader(body.substr(magic.size()));
    if (reader.get<std::uint64_t>() != IntervalTrack::plain_bytes() || reader.get_text() != made_from) return std::nullopt;
    IntervalTrack track;
    const auto first_alert = reader.get<std::int64_t>();
    track.take_alerts(first_alert, std::string(reader.get_text()));
    for (auto left = reader.get<std::uint64_t>(); left > 0 && reader.good(); --left) {
        const auto interval = reader.get<std::int64_t>();
        track.take(interval, std::string(reader.get_text()));
    }
    if (!reader.good() || reader.left() != 0) return std::nullopt;
    return track;
}

}  // namespace tedavis::host_sim
