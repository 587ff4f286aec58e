/// Reads a text line by line, either from memory or through a window of fixed size.
///
/// Memory  in memory mode none (the text, perhaps a mapped file, must outlive the reader); in window mode the caller's window,
/// whatever the size of the log. Failure  a line longer than kMaxLogLine is skipped and reported by its status.
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
    /// `window` has at least kMinLogWindow bytes; 64 KiB or more read fast.
    LineReader(base::ByteSource& source, base::Span<char> window);

    /// Returns the next line without its newline; it stays valid until the next call. The last line needs no newline.
    [[nodiscard]] Status next(std::string_view& line);
    /// Offset of the next line, bytes.
    [[nodiscard]] std::uint64_t offset() const { return window_start_ + at_; }
    /// Continues at this byte offset; an offset beyond the end means the end.
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
