#include "bus/candump/line_reader.hpp"

#include <cstring>

namespace tedavis::bus {

LineReader::LineReader(base::Span<const char> text) : text_(text.data()), total_(text.size()), filled_(text.size()) {}

LineReader::LineReader(base::ByteSource& source, base::Span<char> window)
    : source_(&source), window_(window), text_(window.data()), total_(source.size()) {
    TEDAVIS_CHECK(window.size() >= kMinLogWindow);
}

LineReader::Status LineReader::next(std::string_view& line) {
    while (true) {
        const std::size_t left = filled_ - at_;
        const char* start = text_ + at_;
        const std::size_t look = left < kMaxLogLine + 1 ? left : kMaxLogLine + 1;
        if (const void* newline = look > 0 ? std::memchr(start, '\n', look) : nullptr) {
            line = {start, static_cast<std::size_t>(static_cast<const char*>(newline) - start)};
            at_ += line.size() + 1;
            return Status::line;
        }
        if (left > kMaxLogLine) return skip_line();
        if (whole_text_seen()) {
            line = {start, left};
            at_ = filled_;
            return left > 0 ? Status::line : Status::end;
        }
        if (!refill()) return Status::failed;
    }
}

LineReader::Status LineReader::skip_line() {
    while (true) {
        const std::size_t left = filled_ - at_;
        if (const void* newline = left > 0 ? std::memchr(text_ + at_, '\n', left) : nullptr) {
            at_ = static_cast<std::size_t>(static_cast<const char*>(newline) - text_) + 1;
            return Status::too_long;
        }
        at_ = filled_;
        if (whole_text_seen()) return Status::too_long;
        if (!refill()) return Status::failed;
    }
}

/// Keeps the unread bytes and reads on behind them; in memory mode everything is seen and this is never reached.
bool LineReader::refill() {
    const std::size_t kept = filled_ - at_;
    std::memmove(window_.data(), window_.data() + at_, kept);
    window_start_ += at_;
    at_ = 0;
    filled_ = kept;
    const std::uint64_t left = total_ - window_start_ - kept;
    const std::size_t room = window_.size() - kept;
    const std::size_t count = left < room ? static_cast<std::size_t>(left) : room;
    if (!source_->read(window_start_ + kept, window_.data() + kept, count)) return false;
    filled_ += count;
    return true;
}

void LineReader::seek(std::uint64_t offset) {
    const std::uint64_t wanted = offset < total_ ? offset : total_;
    if (wanted >= window_start_ && wanted <= window_start_ + filled_) {
        at_ = static_cast<std::size_t>(wanted - window_start_);
        return;
    }
    window_start_ = wanted;
    filled_ = 0;
    at_ = 0;
}

}  // namespace tedavis::bus
