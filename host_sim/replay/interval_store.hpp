/// Stores the display's results for the decision intervals of a long log beside it, as LOG.tdi, so that the next run with the
/// same display draws its first frame at any time without delay, and finds alerts without delay. It stores only where the log's
/// index is stored, too, and without a deadline, since the governor's decisions would be a part of the results. It does not store
/// where a file of the display was changed during the start, since it is then not known which version was read.
///
/// The file is a cache for this machine and this build, with the intervals of the display that was used last.
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
    /// Identifies the files of the display; to be called before it is started. Nothing where the options exclude storing.
    [[nodiscard]] static std::optional<DisplayFiles> files_before_start(const ReplayOptions& options);
    /// Gives `preroll` the intervals that an earlier run has stored; to be called before its first frame and its look_ahead().
    /// `files` is the result of files_before_start(). The other references, except the options, must outlive the store.
    IntervalStore(const ReplayOptions& options, const std::optional<DisplayFiles>& files, DisplaySession& session,
                  FlightPlayer& player, FramePreroll& preroll, Console& console);
    /// Writes the file if more intervals are known than it contains. Where it cannot be written, the console states why; the run
    /// is not affected, but the next one starts more slowly.
    ~IntervalStore();
    IntervalStore(const IntervalStore&) = delete;
    IntervalStore& operator=(const IntervalStore&) = delete;

private:
    void write();

    DisplaySession& session_;
    FramePreroll& preroll_;
    Console& console_;
    std::string path_;       ///< empty: nothing is kept
    std::string made_from_;  ///< the identities of all that the intervals depend on
    std::size_t held_ = 0;   ///< number of intervals in the file
};

}  // namespace tedavis::host_sim
