/// Rewrites a token stream on several workers, round by round, until no call is left (thesis 6.2.2.1).
///
/// A round executes every call that is complete when it begins and has room (allocate_round.hpp), and the output of these calls
/// a few times more where it consists of calls only (segment.hpp). So the stream after each round, and the effect of tasks
/// changed between rounds, are the same for every number of workers and every block size, bit for bit. Counts of batches and
/// lanes are not.
///
/// Memory  from an arena, at start; no heap. One caller; the workers' tasks have ended when a function returns.
#pragma once

#include "render_core/base/ports/workers.hpp"
#include "render_core/raytrace/stream/segment.hpp"
#include "render_core/raytrace/stream/token_stream.hpp"

namespace tedavis::raytrace {

struct RewriteReport {
    std::uint32_t rounds = 0;
    bool is_finished = false;  ///< no calls are left
    RewriteCounts counts;
    std::uint32_t waits = 0;  ///< rounds in which calls had to wait for room
    /// Largest number of groups in a round, which is the largest number of workers that could be used at once.
    std::uint32_t most_groups = 0;
};

class ThreadTeam;

class StreamRewriter {
public:
    using Answer = base::Result<RewriteReport, base::FaultText>;

    [[nodiscard]] static std::uint64_t bytes_needed(const StreamSettings& settings);
    /// Returns the allocated bytes, or one sentence. The stream must have been started; it is borrowed.
    [[nodiscard]] base::Result<std::uint64_t, base::FaultText> start(TokenStream& stream, base::Arena& arena);

    /// Runs at most `most_rounds` rounds. Returns one sentence where calls are left and none can be executed (no room, missing
    /// arguments, unknown task), or where a task wrote invalid output; the stream is then unchanged and can be read or cleared.
    [[nodiscard]] Answer rewrite(const TaskNetwork& network, base::Workers& workers, std::uint32_t most_rounds);

private:
    struct Pass;
    struct Run;

    void form_groups(std::uint32_t lanes);
    void run_round(Run& run, ThreadTeam& team);
    void rewrite_once(Run& run, ThreadTeam& team);
    void link_groups();
    [[nodiscard]] base::Span<BlockGroup> groups() const { return groups_.subspan(0, group_count_); }
    [[nodiscard]] base::FaultText task_fault() const;
    [[nodiscard]] base::FaultText stuck_text(const TaskNetwork& network) const;
    [[nodiscard]] base::FaultText stuck_at(const TaskNetwork& network, std::uint32_t call, std::uint32_t literals) const;

    TokenStream* stream_ = nullptr;
    base::Span<BlockGroup> groups_;
    base::Span<Segment> segments_;
    std::uint32_t group_count_ = 0, call_count_ = 0, most_group_calls_ = 0;
};

}  // namespace tedavis::raytrace
