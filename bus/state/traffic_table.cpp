#include "bus/state/traffic_table.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::bus {
namespace {

constexpr std::uint16_t kAllParts = (1u << kTrafficParts) - 1;

bool are_within(base::Time a, base::Time b, base::Duration limit) { return a - b <= limit && b - a <= limit; }

/// Neither empty, nor outlived, nor of a time that has not come: the source's time may have run back.
bool is_held(const flight::TrafficReport& report, base::Time now) {
    return report.address != 0 && report.place.at <= now && now - report.place.at <= flight::kTrafficKept;
}

double distance_m(const flight::TrafficReport& report, const earth::Ecef& from) {
    const flight::TrafficPlace& place = report.place;
    return glm::distance(from, earth::to_ecef({place.latitude_rad, place.longitude_rad, {static_cast<double>(place.height_m)}}));
}

/// The way to a report, from the one before.
void take_way(const flight::TrafficReport& last, flight::TrafficReport& report) {
    if (report.place.at - last.place.at > flight::kTrafficGap) return;
    report.before = last.before;
    auto& way = report.before;
    if (!way.empty() && last.place.at - way.back().at < flight::kTrafficSpacing) return;
    if (way.full()) {
        std::copy(way.begin() + 1, way.end(), way.begin());
        way.pop_back();
    }
    static_cast<void>(way.try_push_back(last.place));
}

}  // namespace

void TrafficTable::take(const DecodedMessage& message, TrafficPart part, base::Time received,
                        const flight::OwnShipEstimate& own_ship) {
    const MessageHeader& header = message.header;
    if (header.service_code >= kTrafficNumbers) {
        ++counts_.refused;
        return;
    }
    Assembly& assembly = assemblies_[header.service_code];
    const auto bit = static_cast<std::uint16_t>(1u << static_cast<unsigned>(part));
    if (begins(assembly, header, received)) {
        if (assembly.parts != 0 && assembly.parts != kAllParts) ++counts_.incomplete;
        assembly = {{}, received, 0, header.node, header.message_code, false};
    } else if (header.message_code != assembly.code || (assembly.parts & bit) != 0 ||
               !are_within(received, assembly.begun, kWindow)) {
        ++counts_.repeated;
        return;
    }
    assembly.parts |= bit;
    assembly.numbers[static_cast<std::size_t>(part)] = message.value;
    assembly.is_refused = assembly.is_refused || !message.healthy;
    if (assembly.parts != kAllParts) return;
    if (assembly.is_refused)
        ++counts_.refused;
    else
        keep(traffic_report(assembly.numbers, assembly.begun), received, own_ship);
}

bool TrafficTable::begins(const Assembly& assembly, const MessageHeader& header, base::Time received) const {
    if (assembly.parts == 0 || header.node != assembly.node || !are_within(received, assembly.begun, sender_timeout_))
        return true;
    return code_step(header.message_code, assembly.code) > 0;
}

void TrafficTable::keep(const flight::TrafficReport& report, base::Time received, const flight::OwnShipEstimate& own_ship) {
    const std::size_t place = place_for(report, received, own_ship);
    if (place == places_.size()) {
        ++counts_.no_room;
        cut_at_ = received;
        return;
    }
    flight::TrafficReport& held = places_[place];
    flight::TrafficReport next = report;
    if (is_held(held, received)) {
        const bool is_same = held.address == report.address;
        if (is_same && report.place.at < held.place.at) {
            ++counts_.outdated;
            return;
        }
        if (is_same) {
            take_way(held, next);
        } else {
            ++counts_.no_room;
            cut_at_ = received;
        }
    }
    held = next;
    ++counts_.reports;
}

/// The aircraft's own place, a free one, or that of one farther away; places_.size() for none.
std::size_t TrafficTable::place_for(const flight::TrafficReport& report, base::Time received,
                                    const flight::OwnShipEstimate& own_ship) {
    std::size_t free = places_.size();
    for (std::size_t n = places_.size(); n-- > 0;) {
        if (places_[n].address == report.address) return n;
        if (!is_held(places_[n], received)) free = n;
    }
    return free < places_.size() ? free : farthest_but(report, own_ship);
}

std::size_t TrafficTable::farthest_but(const flight::TrafficReport& report, const flight::OwnShipEstimate& own_ship) const {
    std::size_t farthest = places_.size();
    if (own_ship.state != base::SignalState::valid && own_ship.state != base::SignalState::stale) return farthest;
    const earth::Ecef own = earth::to_ecef(own_ship.position);
    double farthest_m = distance_m(report, own);
    for (std::size_t n = 0; n < places_.size(); ++n) {
        const double here_m = distance_m(places_[n], own);
        if (!(here_m > farthest_m)) continue;
        farthest_m = here_m;
        farthest = n;
    }
    return farthest;
}

bool TrafficTable::has_room(base::Time now) const {
    for (const flight::TrafficReport& place : places_)
        if (!is_held(place, now)) return true;
    return false;
}

flight::Traffic TrafficTable::estimate(base::Time now) const {
    flight::Traffic traffic;
    traffic.is_received = is_carried_;
    traffic.is_cut = counts_.no_room > 0 && are_within(now, cut_at_, kCutIsSaid);
    for (const flight::TrafficReport& place : places_)
        if (is_held(place, now)) static_cast<void>(traffic.reports.try_push_back(place));
    return traffic;
}

}  // namespace tedavis::bus
