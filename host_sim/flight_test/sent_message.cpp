#include "host_sim/flight_test/sent_message.hpp"

#include "bus/canaerospace/identifier_table.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint16_t kUsualPeriod_ms = 100, kUsualOffset_ms = 17;

/// Types that hold a number, the most exact one first.
bus::DataType type_of_entry(const bus::IdentifierEntry& entry) {
    for (const bus::DataType type : {bus::DataType::double_high, bus::DataType::float32, bus::DataType::uchar8})
        if ((entry.types & bus::type_bit(type)) != 0) return type;
    return bus::DataType::float32;
}

std::uint16_t identifier_at(std::uint16_t place, const bus::GuidanceSettings& guidance) {
    const std::uint16_t of_standard = bus::entry_at(place).identifier;
    if (bus::place_of(of_standard, guidance) == place) return of_standard;
    return static_cast<std::uint16_t>(of_standard + guidance.first_identifier);
}

}  // namespace

const std::vector<std::string>& phase_origin_names() {
    static const std::vector<std::string> kNames = {"unknown", "fms", "pilot", "computed", "simulator"};
    return kNames;
}

std::optional<ScheduledMessage> sent_message(flight::Signal signal, const bus::BusSettings& bus) {
    for (const ScheduledMessage& scheduled : message_schedule()) {
        if (scheduled.signal != signal) continue;
        if (scheduled.is_guidance && !bus.guidance.is_carried()) return std::nullopt;
        ScheduledMessage message = scheduled;
        if (scheduled.is_guidance)
            message.identifier = static_cast<std::uint16_t>(message.identifier + bus.guidance.first_identifier);
        return message;
    }
    const std::uint16_t place = bus::place_of_signal(signal);
    if (place == bus::kNotInTable) return std::nullopt;
    return ScheduledMessage{identifier_at(place, bus.guidance), signal, type_of_entry(bus::entry_at(place)), kUsualPeriod_ms,
                            kUsualOffset_ms};
}

}  // namespace tedavis::host_sim
