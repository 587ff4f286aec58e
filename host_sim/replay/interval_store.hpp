/// Keeps what the display has decided for the intervals of a long log beside it, as LOG.tdi, so that the next run with the same
/// display draws its first frame anywhere at once. Only where the log's index is kept, too, and no deadline is held: what the
/// governor decides would be a part of it.
///
/// The file is a cache of this machine and this build, and holds the intervals of the display that was used last.
#pragma once

#include <string>

#include "host_sim/console.hpp"
#include "host_sim/options/replay_options.hpp"
#include "host_sim/replay/frame_preroll.hpp"

namespace tedavis::host_sim {

class IntervalStore {
public:
    /// Gives `preroll` the intervals that an earlier run has left, before its first frame. All but the options must outlive the
    /// store. Throws UserError where a file of the options is gone.
    IntervalStore(const ReplayOptions& options, DisplaySession& session, FlightPlayer& player, FramePreroll& preroll,
                  Console& console);
    /// Writes the file where more intervals are known than it holds. A run that cannot keep them is as good, only the next one
    /// takes longer to start; the console says why.
    ~IntervalStore();
    IntervalStore(const IntervalStore&) = delete;
    IntervalStore& operator=(const IntervalStore&) = delete;

private:
    void write();

    DisplaySession& session_;
    FramePreroll& preroll_;
    Console& console_;
    std::string path_;       ///< empty: nothing is kept
    std::string made_from_;  ///< all that the intervals follow from
    std::size_t held_ = 0;   ///< by the file
};

}  // namespace tedavis::host_sim
