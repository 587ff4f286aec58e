/// Evaluates one condition of a perceptual contract: whether a measured value stays within its limit over a flight.
///
/// A value holds from its time to the next one's, like the picture in which it was measured. The condition is broken where
/// values beyond the limit hold for at least `for_s` without interruption; times without a measurement interrupt. NaN is beyond
/// every limit.
///
///   add(moment) or skip(time) in the order of time · end(time) once · verdict()
///
/// Pure, no memory, constant time per value. Thread  one.
#pragma once

#include <cstdint>

namespace tedavis::perception {

struct ConditionLimit {
    bool is_most = true;  ///< false: the limit is a lower one
    double limit = 0;
    double for_s = 0;  ///< 0: a single value beyond it breaks the condition

    [[nodiscard]] bool is_kept_by(double value) const { return is_most ? value <= limit : value >= limit; }
    /// True where `value` is farther beyond the limit, or less within it, than `than`; NaN is the worst.
    [[nodiscard]] bool is_worse(double value, double than) const {
        return than == than && (is_most ? !(value <= than) : !(value >= than));
    }
};

struct ConditionMoment {
    double time_s = 0;
    double value = 0;
    std::uint32_t place = 0;  ///< chosen by the caller: the frame
};

struct ConditionVerdict {
    bool is_broken = false;
    ConditionMoment first;       ///< beginning of the first break that counts
    ConditionMoment worst;       ///< worst value in breaks that count; the first of equal ones
    ConditionMoment tightest;    ///< value closest to or farthest beyond the limit, of all measured ones
    std::uint32_t measured = 0;  ///< number of measured values; 0: there is no result
    std::uint32_t beyond = 0;    ///< number of values beyond the limit, too brief ones included
    double longest_s = 0;        ///< longest uninterrupted time beyond the limit
    double broken_s = 0;         ///< total duration of breaks that count
};

class ConditionWatch {
public:
    explicit ConditionWatch(const ConditionLimit& limit) : limit_(limit) {}

    void add(const ConditionMoment& moment) noexcept;
    void skip(double time_s) noexcept { close(time_s); }
    /// Ends the flight: the last value holds until `time_s`.
    void end(double time_s) noexcept { close(time_s); }
    [[nodiscard]] const ConditionVerdict& verdict() const { return verdict_; }

private:
    void close(double time_s) noexcept;
    void count() noexcept;

    ConditionLimit limit_;
    ConditionVerdict verdict_;
    bool is_beyond_ = false;         ///< the last value is beyond the limit
    ConditionMoment began_, worst_;  ///< of the current uninterrupted values beyond the limit
};

}  // namespace tedavis::perception
