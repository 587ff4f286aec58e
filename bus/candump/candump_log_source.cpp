#include "bus/candump/candump_log_source.hpp"

namespace tedavis::bus {
namespace {

constexpr base::Duration kStepBack = base::Duration::seconds(1);
constexpr base::Duration kLeapAhead = base::Duration::seconds(4);

/// `shift` is never negative; a log whose clock was set back again and again cannot carry time past the latest stamp.
base::Time shifted(base::Time stamp, base::Duration shift) { return shift < kLatestStamp - stamp ? stamp + shift : kLatestStamp; }

}  // namespace

CandumpLogSource::CandumpLogSource(base::Span<const char> text) : reader_(text) {}

CandumpLogSource::CandumpLogSource(base::ByteSource& source, base::Span<char> window) : reader_(source, window) {}

std::size_t CandumpLogSource::read(base::Time until, base::Span<CanFrame> out) {
    std::size_t count = 0;
    while (count < out.size()) {
        const LogPosition before = position_;
        if (!next_frame(out[count])) break;
        if (out[count].time > until) {
            seek(before);
            break;
        }
        ++count;
    }
    return count;
}

void CandumpLogSource::seek(const LogPosition& position) {
    position_ = position;
    reader_.seek(position.offset);
    health_ = SourceHealth::running;
}

bool CandumpLogSource::next_frame(CanFrame& frame) {
    if (!parse_next_frame(frame)) return false;
    settle_stamp(frame);
    ++position_.statistics.frames;
    if (frame.kind == FrameKind::error) ++position_.statistics.error_frames;
    return true;
}

bool CandumpLogSource::parse_next_frame(CanFrame& frame) {
    std::string_view text;
    while (true) {
        const LineReader::Status status = reader_.next(text);
        if (status == LineReader::Status::end || status == LineReader::Status::failed) {
            health_ = status == LineReader::Status::end ? SourceHealth::ended : SourceHealth::failed;
            return false;
        }
        ++position_.lines.lines;
        position_.offset = reader_.offset();
        if (status == LineReader::Status::too_long) {
            report(LineFault::too_long);
            continue;
        }
        const CandumpLine line = parse_candump_line(text, frame);
        if (line.kind == LineKind::frame) {
            frame.channel = channel_of(line.interface_name);
            return true;
        }
        count_line(line);
    }
}

void CandumpLogSource::count_line(const CandumpLine& line) {
    switch (line.kind) {
        case LineKind::blank: ++position_.lines.blank; break;
        case LineKind::other: ++position_.lines.other; break;
        case LineKind::drop_report:
            ++position_.lines.drop_reports;
            position_.statistics.dropped += line.dropped;
            break;
        case LineKind::malformed: report(line.fault); break;
        case LineKind::frame: break;
    }
}

void CandumpLogSource::report(LineFault fault) {
    ++position_.statistics.malformed;
    const bool known = !reports_.empty() && position_.lines.lines <= reports_.back().line;
    if (!known && !reports_.full()) (void)reports_.try_push_back({position_.lines.lines, fault});
}

void CandumpLogSource::record_order(base::Time stamp) {
    LogLineCounts& lines = position_.lines;
    const base::Duration back = position_.last_stamp - stamp;
    if (position_.any_frame && back > base::Duration{}) {
        if (lines.runs_back == 0) {
            lines.first_back_line = lines.lines;
            lines.first_back = back;
        }
        if (back > lines.longest_back) lines.longest_back = back;
        ++lines.runs_back;
    }
    position_.last_stamp = stamp;
}

void CandumpLogSource::settle_stamp(CanFrame& frame) {
    record_order(frame.time);
    frame.time = shifted(frame.time, position_.shift);
    if (!position_.any_frame) {
        position_.any_frame = true;
        position_.newest = frame.time;
        return;
    }
    const base::Duration ahead = frame.time - position_.newest;
    if (ahead < base::Duration{} - kStepBack) {
        ++position_.lines.clock_steps;
        position_.shift = position_.shift - ahead;
        frame.time = position_.newest;
    } else if (ahead < base::Duration{}) {
        ++position_.lines.out_of_order;
    } else if (ahead > kLeapAhead && leaps_and_returns(frame.time)) {
        ++position_.lines.leaping_stamps;
        frame.time = position_.newest;
    } else {
        position_.newest = frame.time;
    }
}

/// Looks at the frame that follows: does it lie before this one, near what came earlier?
bool CandumpLogSource::leaps_and_returns(base::Time stamp) {
    const LogPosition here = position_;
    CanFrame following;
    const bool found = parse_next_frame(following);
    seek(here);
    const base::Time next = shifted(following.time, here.shift);
    return found && next < stamp - kStepBack && next >= here.newest - kStepBack;
}

std::uint8_t CandumpLogSource::channel_of(std::string_view name) {
    if (last_channel_ < names_.size() && names_[last_channel_].view() == name) return last_channel_;
    for (std::size_t i = 0; i < names_.size(); ++i)
        if (names_[i].view() == name) return last_channel_ = static_cast<std::uint8_t>(i);
    if (!names_.try_push_back(base::FixedString<15>(name))) return static_cast<std::uint8_t>(kMaxLogInterfaces);
    return last_channel_ = static_cast<std::uint8_t>(names_.size() - 1);
}

}  // namespace tedavis::bus
