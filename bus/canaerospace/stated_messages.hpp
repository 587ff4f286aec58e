/// Messages that a bus file states itself ([[message]]): a sensor that sends a signal on another identifier, as another type or
/// in another unit than the standard says.
///
/// A stated message takes the place of all identifiers by which the standard states its signal: these are then foreign, so that
/// one signal never has two meanings. Where its identifier has a meaning in the standard, that meaning goes.
#pragma once

#include <cstdint>
#include <string_view>
#include <type_traits>

#include "bus/canaerospace/data_type.hpp"
#include "render_core/base/config_reader.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/stamped.hpp"
#include "render_core/flight/signal.hpp"

namespace tedavis::bus {

inline constexpr std::size_t kMaxStatedMessages = 16;

/// SI = number * factor + offset, before the dialect's sign and reference.
struct StatedMessage {
    std::uint16_t identifier = 0;
    flight::Signal signal = flight::Signal::count_;
    DataType type = DataType::float32;
    double factor = 1;
    double offset = 0;
    base::FreshnessLimits limits;  ///< by the period at which it is sent
    bool states_period = false;
};
static_assert(std::is_trivially_copyable_v<StatedMessage>);

using StatedMessages = base::FixedVector<StatedMessage, kMaxStatedMessages>;

/// Returns the message of an identifier, or null.
[[nodiscard]] const StatedMessage* find_message(const StatedMessages& messages, std::uint16_t identifier) noexcept;
[[nodiscard]] bool is_stated(const StatedMessages& messages, flight::Signal signal) noexcept;

/// Reads the tables [[message]] of a bus file; faults go to the reader. `is_taken` says what the file gives an identifier to
/// besides, such as "the phase of flight", or is empty.
[[nodiscard]] StatedMessages read_stated_messages(base::ConfigSection& root,
                                                  std::string_view (*is_taken)(std::uint16_t identifier, const void* context),
                                                  const void* context);

}  // namespace tedavis::bus
