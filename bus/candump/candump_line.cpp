#include "bus/candump/candump_line.hpp"

#include <array>

#include "bus/frame/fd_length.hpp"

namespace tedavis::bus {
namespace {

constexpr std::uint8_t kNoDigit = 0xFF;
constexpr std::uint32_t kErrorFrameBit = 0x20000000u;
constexpr std::size_t kMaxInterfaceName = 15;  // IFNAMSIZ without its zero

constexpr std::array<std::uint8_t, 256> make_hex_digits() {
    std::array<std::uint8_t, 256> digits{};
    for (auto& digit : digits) digit = kNoDigit;
    for (std::uint8_t i = 0; i < 10; ++i) digits['0' + i] = i;
    for (std::uint8_t i = 0; i < 6; ++i) {
        digits['A' + i] = static_cast<std::uint8_t>(10 + i);
        digits['a' + i] = static_cast<std::uint8_t>(10 + i);
    }
    return digits;
}
constexpr std::array<std::uint8_t, 256> kHexDigits = make_hex_digits();

std::uint8_t hex_digit(char c) { return kHexDigits[static_cast<unsigned char>(c)]; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// Reads a line from front to back; every look beyond the end answers '\0'.
struct Cursor {
    const char* at;
    const char* end;

    [[nodiscard]] std::size_t left() const { return static_cast<std::size_t>(end - at); }
    [[nodiscard]] char peek() const { return at < end ? *at : '\0'; }
    [[nodiscard]] bool take(char wanted) {
        if (peek() != wanted) return false;
        ++at;
        return true;
    }
    std::size_t skip_blanks() {
        const char* start = at;
        while (at < end && is_blank(*at)) ++at;
        return static_cast<std::size_t>(at - start);
    }
};

/// Decimal digits, at most `limit`; returns how many.
std::size_t take_decimal(Cursor& cursor, std::size_t limit, std::int64_t& value) {
    value = 0;
    std::size_t count = 0;
    while (count < limit && cursor.at < cursor.end && *cursor.at >= '0' && *cursor.at <= '9') {
        value = value * 10 + (*cursor.at++ - '0');
        ++count;
    }
    return count;
}

bool take_time(Cursor& cursor, base::Time& time) {
    std::int64_t seconds = 0;
    std::int64_t fraction = 0;
    if (!cursor.take('(') || take_decimal(cursor, 11, seconds) == 0 || seconds >= kLatestStamp.ns / 1'000'000'000 ||
        !cursor.take('.'))
        return false;
    const std::size_t digits = take_decimal(cursor, 9, fraction);
    if ((digits != 6 && digits != 9) || !cursor.take(')')) return false;
    time.ns = seconds * 1'000'000'000 + (digits == 6 ? fraction * 1000 : fraction);
    return true;
}

bool take_interface(Cursor& cursor, std::string_view& name) {
    if (cursor.skip_blanks() == 0) return false;
    const char* start = cursor.at;
    while (cursor.at < cursor.end && !is_blank(*cursor.at)) ++cursor.at;
    name = {start, static_cast<std::size_t>(cursor.at - start)};
    return !name.empty() && name.size() <= kMaxInterfaceName && cursor.skip_blanks() > 0;
}

LineFault take_identifier(Cursor& cursor, CanFrame& frame) {
    std::uint32_t id = 0;
    std::size_t digits = 0;
    for (; digits < 9; ++digits, ++cursor.at) {
        const std::uint8_t digit = hex_digit(cursor.peek());
        if (digit == kNoDigit) break;
        id = id << 4 | digit;
    }
    if (!cursor.take('#')) return LineFault::identifier;
    if (digits == 5) return LineFault::can_xl;
    if (digits == 3 && id <= 0x7FF) {
        frame.id = id;
        return LineFault::none;
    }
    if (digits != 8 || id >= 2 * kErrorFrameBit) return LineFault::identifier;
    const bool error = (id & kErrorFrameBit) != 0;
    frame.id = id & ~kErrorFrameBit;
    frame.extended = !error;
    frame.kind = error ? FrameKind::error : FrameKind::data;
    return LineFault::none;
}

/// Hex pairs with optional dots between them, at most `limit` bytes; stops at the first other character.
LineFault take_bytes(Cursor& cursor, std::size_t limit, CanFrame& frame) {
    std::size_t count = 0;
    while (true) {
        if (count > 0 && cursor.peek() == '.') ++cursor.at;
        const std::uint8_t high = hex_digit(cursor.peek());
        if (high == kNoDigit) break;
        const std::uint8_t low = cursor.left() > 1 ? hex_digit(cursor.at[1]) : kNoDigit;
        if (low == kNoDigit) return LineFault::data;
        if (count == limit) return LineFault::length;
        frame.data[count++] = static_cast<std::uint8_t>(high << 4 | low);
        cursor.at += 2;
    }
    frame.length = static_cast<std::uint8_t>(count);
    return LineFault::none;
}

LineFault take_raw_length_code(Cursor& cursor, CanFrame& frame) {
    if (!cursor.take('_')) return LineFault::none;
    const std::uint8_t code = hex_digit(cursor.peek());
    if (frame.length != 8 || code == kNoDigit || code < 9) return LineFault::raw_length_code;
    ++cursor.at;
    frame.raw_dlc = code;
    return LineFault::none;
}

LineFault take_remote(Cursor& cursor, CanFrame& frame) {
    if (frame.kind == FrameKind::error) return LineFault::data;
    frame.kind = FrameKind::remote;
    const char next = cursor.peek();
    if (next >= '0' && next <= '9') {
        if (next == '9') return LineFault::length;
        frame.length = static_cast<std::uint8_t>(next - '0');
        ++cursor.at;
    }
    return take_raw_length_code(cursor, frame);
}

LineFault take_fd(Cursor& cursor, CanFrame& frame) {
    const std::uint8_t flags = hex_digit(cursor.peek());
    if (frame.kind == FrameKind::error || flags == kNoDigit) return LineFault::fd_flags;
    ++cursor.at;
    frame.kind = FrameKind::fd;
    frame.fd_flags = flags;
    const LineFault fault = take_bytes(cursor, frame.data.size(), frame);
    if (fault != LineFault::none) return fault;
    return is_fd_length(frame.length) ? LineFault::none : LineFault::length;
}

LineFault take_frame(Cursor& cursor, CanFrame& frame) {
    const LineFault fault = take_identifier(cursor, frame);
    if (fault != LineFault::none) return fault;
    if (cursor.take('R')) return take_remote(cursor, frame);
    if (cursor.take('#')) return take_fd(cursor, frame);
    const LineFault bytes = take_bytes(cursor, 8, frame);
    return bytes != LineFault::none ? bytes : take_raw_length_code(cursor, frame);
}

LineFault take_end(Cursor& cursor, CanFrame& frame) {
    const std::size_t blanks = cursor.skip_blanks();
    if (cursor.left() == 0) return LineFault::none;
    if (blanks == 0) return LineFault::data;
    frame.transmitted = cursor.peek() == 'T';
    if (!cursor.take('T') && !cursor.take('R')) return LineFault::trailing_text;
    cursor.skip_blanks();
    return cursor.left() == 0 ? LineFault::none : LineFault::trailing_text;
}

CandumpLine not_a_frame(std::string_view line) {
    constexpr std::string_view kDropReport = "DROPCOUNT: dropped ";
    Cursor cursor{line.data(), line.data() + line.size()};
    CandumpLine result;
    cursor.skip_blanks();
    result.kind = cursor.left() == 0 ? LineKind::blank : LineKind::other;
    if (line.substr(0, kDropReport.size()) != kDropReport) return result;
    cursor.at = line.data() + kDropReport.size();
    std::int64_t dropped = 0;
    if (take_decimal(cursor, 10, dropped) == 0 || dropped > 0xFFFFFFFFll) return result;
    result.kind = LineKind::drop_report;
    result.dropped = static_cast<std::uint32_t>(dropped);
    return result;
}

CandumpLine malformed(LineFault fault) {
    CandumpLine result;
    result.fault = fault;
    return result;
}

}  // namespace

const char* describe(LineFault fault) noexcept {
    switch (fault) {
        case LineFault::none: return "nothing is wrong";
        case LineFault::time_stamp: return "the time stamp is not (seconds.fraction) with 6 or 9 digits";
        case LineFault::interface_name: return "the interface name is missing or longer than 15 characters";
        case LineFault::identifier: return "the identifier is not 3 hex digits up to 7FF or 8 hex digits up to 1FFFFFFF";
        case LineFault::data: return "the data bytes are not pairs of hex digits";
        case LineFault::length: return "a frame cannot have this number of data bytes";
        case LineFault::fd_flags: return "the CAN FD flag digit is missing or the identifier is not that of an FD frame";
        case LineFault::raw_length_code: return "the raw length code is not 9..F after a length of eight";
        case LineFault::can_xl: return "CAN XL frames are not supported; record without them";
        case LineFault::trailing_text: return "there is text after the frame";
        case LineFault::too_long: return "the line is longer than any frame";
    }
    return "nothing is wrong";
}

CandumpLine parse_candump_line(std::string_view line, CanFrame& frame) noexcept {
    if (line.empty() || line[0] != '(') return not_a_frame(line);
    Cursor cursor{line.data(), line.data() + line.size()};
    CandumpLine result;
    frame = CanFrame();
    if (!take_time(cursor, frame.time)) return malformed(LineFault::time_stamp);
    if (!take_interface(cursor, result.interface_name)) return malformed(LineFault::interface_name);
    LineFault fault = take_frame(cursor, frame);
    if (fault == LineFault::none) fault = take_end(cursor, frame);
    if (fault != LineFault::none) return malformed(fault);
    result.kind = LineKind::frame;
    return result;
}

namespace {

/// Appends to a buffer known to be large enough (kMaxCandumpLine).
struct Text {
    char* at;

    void put(char c) { *at++ = c; }
    void put(std::string_view text) {
        for (const char c : text) put(c);
    }
    void decimal(std::int64_t value, int digits) {
        for (int i = digits - 1; i >= 0; --i, value /= 10) at[i] = static_cast<char>('0' + value % 10);
        at += digits;
    }
    void hex(std::uint32_t value, int digits) {
        for (int i = digits - 1; i >= 0; --i, value >>= 4) at[i] = "0123456789ABCDEF"[value & 15];
        at += digits;
    }
};

void put_content(Text& text, const CanFrame& frame) {
    if (frame.kind == FrameKind::remote) {
        text.put('R');
        if (frame.length > 0) text.hex(frame.length, 1);
    } else {
        if (frame.kind == FrameKind::fd) {
            text.put('#');
            text.hex(frame.fd_flags, 1);
        }
        for (std::size_t i = 0; i < frame.length; ++i) text.hex(frame.data[i], 2);
    }
    if (frame.raw_dlc > 8 && frame.length == 8) {
        text.put('_');
        text.hex(frame.raw_dlc, 1);
    }
}

}  // namespace

std::size_t format_candump_line(const CanFrame& frame, std::string_view interface_name, StampDigits digits, bool direction,
                                base::Span<char> out) noexcept {
    const bool named = !interface_name.empty() && interface_name.size() <= kMaxInterfaceName;
    const std::size_t longest = frame.kind == FrameKind::fd ? 64 : 8;
    if (out.size() < kMaxCandumpLine || frame.time.ns < 0 || !named || frame.length > longest) return 0;
    Text text{out.data()};
    text.put('(');
    text.decimal(frame.time.ns / 1'000'000'000, 10);
    text.put('.');
    const std::int64_t fraction = frame.time.ns % 1'000'000'000;
    text.decimal(digits == StampDigits::micro ? fraction / 1000 : fraction, static_cast<int>(digits));
    text.put(") ");
    text.put(interface_name);
    text.put(' ');
    const bool error = frame.kind == FrameKind::error;
    text.hex(error ? frame.id | kErrorFrameBit : frame.id, error || frame.extended ? 8 : 3);
    text.put('#');
    put_content(text, frame);
    if (direction) text.put(frame.transmitted ? " T" : " R");
    text.put('\n');
    return static_cast<std::size_t>(text.at - out.data());
}

}  // namespace tedavis::bus
