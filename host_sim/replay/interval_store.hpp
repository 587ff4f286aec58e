/// Keeps what the display has decided for the intervals of a long log beside it, as LOG.tdi, so that the next run with the same
/// display draws its first frame anywhere at once, and looks ahead for alerts at once. Only where the log's index is kept, too,
/// and no deadline is held: what the governor decides would be a part of it. Nothing is kept either where a file of the display
/// was changed while the display was started: nobody knows which of the two it has read.
///
/// The file is a cache of this machine and this build, and holds the intervals of the display that was used last.
#pragma once

#include <optional>
#include <string>

#include "host_sim/console.hpp"
#include "host_sim/options/replay_options.hpp"
#include "host_sim/replay/display_files.hpp"
#include "host_sim/replay/frame_preroll.hpp"

namespace tedavis::host_sim {

class IntervalStore {
public:
    /// The files of the display, to be asked for before it is started; nothing where the options let nothing be kept.
    [[nodiscard]] static std::optional<DisplayFiles> files_before_start(const ReplayOptions& options);
    /// Gives `preroll` the intervals that an earlier run has left, before its first frame and its look ahead. `files`: what
    /// files_before_start() was. All but the options and the files must outlive the store.
    IntervalStore(const ReplayOptions& options, const std::optional<DisplayFiles>& files, DisplaySession& session,
                  FlightPlayer& player, FramePreroll& preroll, Console& console);
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
