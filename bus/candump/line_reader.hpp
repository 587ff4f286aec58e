/// Lines of a text that lies in memory or is read through a window, alike.
///
/// Memory  in memory mode none (the text, perhaps a mapped file, must outlive the reader); in window mode the caller's
/// window, so that a log of any size needs no more. Failure  a line longer than kMaxLogLine is skipped and named.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/ports/byte_source.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::bus {

inline constexpr std::size_t kMaxLogLine = 1024;
inline constexpr std::size_t kMinLogWindow = 4 * kMaxLogLine;

class LineReader {
public:
    enum class Status : std::uint8_t { line, too_long, end, failed };

    explicit LineReader(base::Span<const char> text);
    /// `window` of at least kMinLogWindow bytes; 64 KiB and more read well.
    LineReader(base::ByteSource& source, base::Span<char> window);

    /// The next line without its newline, valid until the next call; the last line needs no newline.
    [[nodiscard]] Status next(std::string_view& line);
    /// Bytes before the next line.
    [[nodiscard]] std::uint64_t offset() const { return window_start_ + at_; }
    /// Goes on at this byte; beyond the end the text is at its end.
    void seek(std::uint64_t offset);

private:
    [[nodiscard]] bool whole_text_seen() const { return window_start_ + filled_ == total_; }
    [[nodiscard]] bool refill();
    [[nodiscard]] Status skip_line();

    base::ByteSource* source_ = nullptr;  // null in memory mode
    base::Span<char> window_;
    const char* text_ = nullptr;      // the window's or the whole text's first byte
    std::uint64_t total_ = 0;         // bytes of the whole text
    std::uint64_t window_start_ = 0;  // offset of text_[0]
    std::size_t filled_ = 0;          // bytes at text_
    std::size_t at_ = 0;              // first unread byte of them
};

}  // namespace tedavis::bus
