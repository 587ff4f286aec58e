/// The facts of a flight that an [[expect]] can state, as spans of frames in which they did not change.
///
/// Times are seconds since the first frame of the input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "host_sim/flight_test/flight_test.hpp"

namespace tedavis::host_sim {

/// The most important kinds first.
enum class FactKind : std::uint8_t { phase, phase_source, design, alert, obstacle_alert, signal, flag, effect };

inline constexpr const char* kFlagThere = "there";
inline constexpr const char* kFlagGone = "gone";

struct RecordedFact {
    FactKind kind = FactKind::phase;
    std::string name;   ///< of the signal, flag or effect; else empty
    std::string value;  ///< as a script states it; of a flag kFlagThere or kFlagGone
};

/// The alerts that are possible: none of terrain without a terrain database, none of obstacles without a scene.
struct WatchedAlerts {
    bool terrain = false, obstacles = false;
};

/// Returns the facts of one frame. Absent flags, flags that only repeat the state of a signal, and names that a script cannot
/// state are left out.
[[nodiscard]] std::vector<RecordedFact> facts_of(const ObservedFrame& frame, const WatchedAlerts& alerts);

struct FactSpan {
    RecordedFact fact;
    double first_s = 0, last_s = 0;           ///< the first and the last frame that show it
    bool from_start = false, to_end = false;  ///< of the recording
};

/// Takes frames in the order of time. A signal that is missing in the whole flight has no spans. A flag that is set in a part of
/// the flight also has spans in which it is gone. An effect has no spans while no design requests it.
class FactTracks {
public:
    explicit FactTracks(const WatchedAlerts& alerts) : alerts_(alerts) {}

    void take(const ObservedFrame& frame);
    /// In the order of kinds, names and times.
    [[nodiscard]] std::vector<FactSpan> spans() const;
    [[nodiscard]] double first_s() const { return first_s_; }
    [[nodiscard]] double last_s() const { return last_s_; }

private:
    struct Track {
        std::vector<FactSpan> spans;
        std::uint64_t last_frame = 0;  ///< that the last span was seen in
    };
    using Key = std::tuple<FactKind, std::string>;
    void extend(const RecordedFact& fact, double time_s);
    void begin(Track& track, const RecordedFact& fact, double time_s);
    void end_unseen(double time_s);

    WatchedAlerts alerts_;
    std::map<Key, Track> tracks_;
    std::uint64_t frames_ = 0;
    double first_s_ = 0, last_s_ = 0;
};

}  // namespace tedavis::host_sim
