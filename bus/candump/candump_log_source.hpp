/// A recorded candump log as a source of frames.
///
/// Frames come in the order of the file. Lines that are not frames are counted by kind; the first kMaxLineReports malformed
/// ones are kept with line number and reason. Stamps may be out of order: a frame is returned once no earlier line lies in the
/// future, so that what has been read up to T depends on T alone. A clock that steps back by more than a second (set by hand or
/// by NTP while recording) is re-anchored: all later stamps are shifted so that the frame after the step has the time of the
/// frame before it. A single stamp that jumps ahead, with the next one back in order, is replaced by that of the line before.
/// Both cases are counted.
///
/// Thread  one. Memory  inside the object, and the caller's text or window. Failure  counted; health() says `failed` when the
/// medium cannot be read.
#pragma once

#include <cstdint>
#include <type_traits>

#include "bus/candump/candump_line.hpp"
#include "bus/candump/line_reader.hpp"
#include "bus/frame/can_source.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"

namespace tedavis::bus {

inline constexpr std::size_t kMaxLineReports = 32;
inline constexpr std::size_t kMaxLogInterfaces = 16;

struct LineReport {
    std::uint64_t line = 0;  ///< counted from 1
    LineFault fault = LineFault::none;
};

struct LogLineCounts {
    std::uint64_t lines = 0;
    std::uint64_t blank = 0;
    std::uint64_t other = 0;
    std::uint64_t drop_reports = 0;
    std::uint64_t out_of_order = 0;  ///< frames stamped before an earlier line
    std::uint64_t clock_steps = 0;   ///< backward clock steps that were re-anchored
    std::uint64_t leaping_stamps = 0;
    std::uint64_t runs_back = 0;              ///< frames stamped before their predecessor, by any amount
    std::uint64_t first_back_line = 0;        ///< line of the first of them; 0: none
    base::Duration first_back, longest_back;  ///< amount of the first and of the largest
};

/// A position in the log with all counts up to it. Reading on from here gives the same frames and counts as reading the log
/// from its start.
struct LogPosition {
    std::uint64_t offset = 0;
    base::Time newest;      ///< newest stamp returned so far, after re-anchoring
    base::Time last_stamp;  ///< the previous frame's, as in the file
    base::Duration shift;   ///< added to the stamps that follow
    bool any_frame = false;
    SourceStatistics statistics;
    LogLineCounts lines;
};
static_assert(std::is_trivially_copyable_v<LogPosition>);

class CandumpLogSource final : public CanSource {
public:
    explicit CandumpLogSource(base::Span<const char> text);
    CandumpLogSource(base::ByteSource& source, base::Span<char> window);

    [[nodiscard]] std::size_t read(base::Time until, base::Span<CanFrame> out) override;
    [[nodiscard]] SourceHealth health() const override { return health_; }
    [[nodiscard]] const SourceStatistics& statistics() const override { return position_.statistics; }
    [[nodiscard]] const LogLineCounts& line_counts() const { return position_.lines; }
    [[nodiscard]] base::Span<const LineReport> reports() const { return {reports_.data(), reports_.size()}; }
    /// Interface names by channel index.
    [[nodiscard]] base::Span<const base::FixedString<15>> interface_names() const { return {names_.data(), names_.size()}; }

    [[nodiscard]] const LogPosition& position() const { return position_; }
    void seek(const LogPosition& position);

private:
    [[nodiscard]] bool next_frame(CanFrame& frame);
    [[nodiscard]] bool parse_next_frame(CanFrame& frame);
    void count_line(const CandumpLine& line);
    void report(LineFault fault);
    void record_order(base::Time stamp);
    void settle_stamp(CanFrame& frame);
    [[nodiscard]] bool leaps_and_returns(base::Time stamp);
    [[nodiscard]] std::uint8_t channel_of(std::string_view name);

    LineReader reader_;
    LogPosition position_;
    SourceHealth health_ = SourceHealth::running;
    base::FixedVector<LineReport, kMaxLineReports> reports_;
    base::FixedVector<base::FixedString<15>, kMaxLogInterfaces> names_;
    std::uint8_t last_channel_ = 0;
};

}  // namespace tedavis::bus
