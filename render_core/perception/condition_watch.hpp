/// The perceptual contract's judgement: whether a measured value kept within its limit over a flight.
///
/// A value stands from its time to the next one's, as the picture does that it was measured of. A condition is broken where
/// values beyond the limit stand for at least `for_s` without a pause; what is not measured is a pause. Values that are no number
/// are beyond every limit.
///
///   add(moment) or skip(time) in the order of time · end(time) once · verdict()
///
/// Pure, no memory, constant time a value. Thread  one.
#pragma once

#include <cstdint>

namespace tedavis::perception {

struct ConditionLimit {
    bool is_most = true;  ///< false: the value is to be at least that
    double limit = 0;
    double for_s = 0;  ///< 0: a single value beyond it breaks the condition

    [[nodiscard]] bool is_kept_by(double value) const { return is_most ? value <= limit : value >= limit; }
    /// Farther beyond the limit, or less within it; nothing is worse than what is no number.
    [[nodiscard]] bool is_worse(double value, double than) const {
        return than == than && (is_most ? !(value <= than) : !(value >= than));
    }
};

struct ConditionMoment {
    double time_s = 0;
    double value = 0;
    std::uint32_t place = 0;  ///< the caller's: of the frame
};

struct ConditionVerdict {
    bool is_broken = false;
    ConditionMoment first;       ///< with which the first break that counts began
    ConditionMoment worst;       ///< of the breaks that count; the first of equals
    ConditionMoment tightest;    ///< of all that was measured, also where it holds
    std::uint32_t measured = 0;  ///< values; 0: nothing is shown
    std::uint32_t beyond = 0;    ///< of them beyond the limit, also too briefly
    double longest_s = 0;        ///< that values beyond the limit stood without a pause
    double broken_s = 0;         ///< that breaks that count lasted, together
};

class ConditionWatch {
public:
    explicit ConditionWatch(const ConditionLimit& limit) : limit_(limit) {}

    void add(const ConditionMoment& moment) noexcept;
    void skip(double time_s) noexcept { close(time_s); }
    /// Until when the last value stands.
    void end(double time_s) noexcept { close(time_s); }
    [[nodiscard]] const ConditionVerdict& verdict() const { return verdict_; }

private:
    void close(double time_s) noexcept;
    void count() noexcept;

    ConditionLimit limit_;
    ConditionVerdict verdict_;
    bool is_beyond_ = false;         ///< what was added last
    ConditionMoment began_, worst_;  ///< of the values beyond the limit that stand without a pause
};

}  // namespace tedavis::perception
