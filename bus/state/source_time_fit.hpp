/// Reconstructs when a periodic message was sent, although CANaerospace messages carry no time.
///
/// A sender counts its messages (message code) and sends them at a steady period, so the sending time is a linear function of the
/// count. The line is fitted to the receive stamps by a growing-memory least-squares filter (alpha = 2(2n-1)/(n(n+1)), beta =
/// 6/(n(n+1)); E. Brookner, Tracking and Kalman Filtering Made Easy, 1998, chapter 1) whose memory stops growing at kMaxMemory
/// messages. A receiver cannot estimate the mean transport delay, so the result contains it.
///
/// The fit is locked once kMessagesToLock messages lie close to the line; without a lock the receive stamp is the answer.
/// Stamps far off the line (a burst after a busy bus) do not move it. Only differences of times enter, so the same messages
/// with another time origin give the same bits.
/// Thread  one. Memory  fixed, trivially copyable.
#pragma once

#include <cstdint>
#include <type_traits>

#include "render_core/base/time.hpp"

namespace tedavis::bus {

struct SourceTime {
    base::Time time;
    bool locked = false;  ///< false: `time` is the receive stamp
};

class SourceTimeFit {
public:
    static constexpr std::uint16_t kMaxMemory = 512;
    static constexpr std::uint16_t kMessagesToLock = 8;

    /// `code` must differ from the previous one: the caller drops duplicates and older messages.
    [[nodiscard]] SourceTime add(std::uint8_t code, base::Time received);
    void reset() { *this = SourceTimeFit(); }

    [[nodiscard]] bool locked() const;
    /// Seconds between consecutive message codes; 0 before the second message.
    [[nodiscard]] double period_s() const { return period_ns_ * 1e-9; }

private:
    void start(std::uint8_t code, base::Time received);
    [[nodiscard]] bool follow_line(std::uint8_t code, double steps, base::Time received);
    void correct_line(double residual_ns, double steps);
    void advance(double by_ns);

    base::Time line_;         // the line at the last message, whole nanoseconds
    double fraction_ns_ = 0;  // and its fraction
    double period_ns_ = 0;
    double variance_ns2_ = 0;  // of the stamps about the line
    std::uint16_t messages_ = 0;
    std::uint8_t code_ = 0;
    std::uint8_t misses_ = 0;  // stamps off the line in a row
};
static_assert(std::is_trivially_copyable_v<SourceTimeFit>);

}  // namespace tedavis::bus
