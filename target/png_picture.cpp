#include "target/png_picture.hpp"

#include <algorithm>
#include <cstring>

#include "render_core/base/check.hpp"
#include "render_core/base/hash.hpp"

namespace tedavis::target {
namespace {

constexpr std::uint8_t kSignature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::size_t kChunkFrame = 12;  // length, name, checksum
constexpr std::size_t kHeaderBytes = 13;
constexpr std::size_t kStreamFrame = 6;  // the zlib stream's header and checksum
constexpr std::size_t kBlockFrame = 5;
constexpr std::size_t kBlockBytes = 65535;  // of a stored block (RFC 1951)
constexpr std::uint32_t kAdlerModulus = 65521;

/// A filter byte, then three bytes a pixel.
std::size_t row_bytes(std::uint32_t width_px) { return 1 + std::size_t{3} * width_px; }
std::size_t raw_bytes(std::uint32_t width_px, std::uint32_t height_px) { return row_bytes(width_px) * height_px; }
std::size_t stream_bytes(std::size_t raw) { return kStreamFrame + raw + (raw + kBlockBytes - 1) / kBlockBytes * kBlockFrame; }

class PngWriter {
public:
    explicit PngWriter(base::Span<std::uint8_t> out) : out_(out) {}

    void signature() { put(kSignature, sizeof kSignature); }
    void begin_chunk(const char* name, std::size_t bytes) {
        put_32(static_cast<std::uint32_t>(bytes));
        chunk_ = at_;
        put(name, 4);
    }
    void end_chunk() { put_32(base::crc32(out_.data() + chunk_, at_ - chunk_)); }
    void put(const void* bytes, std::size_t count) {
        std::memcpy(out_.data() + at_, bytes, count);
        at_ += count;
    }
    void put_8(std::uint8_t byte) { out_[at_++] = byte; }
    void put_32(std::uint32_t value) {
        for (int shift = 24; shift >= 0; shift -= 8) put_8(static_cast<std::uint8_t>(value >> shift));
    }
    /// One byte of the uncompressed rows: opens a stored block where one begins. `left`: bytes from this one on.
    void put_raw(std::uint8_t byte, std::size_t left) {
        if (in_block_ == 0) begin_block(left);
        --in_block_;
        put_8(byte);
        low_ = (low_ + byte) % kAdlerModulus;
        high_ = (high_ + low_) % kAdlerModulus;
    }
    void put_adler() { put_32((high_ << 16) | low_); }
    [[nodiscard]] std::size_t written() const { return at_; }

private:
    void begin_block(std::size_t left) {
        in_block_ = std::min(left, kBlockBytes);
        const auto length = static_cast<std::uint16_t>(in_block_), inverse = static_cast<std::uint16_t>(~length);
        put_8(in_block_ == left ? 1 : 0);
        for (const std::uint16_t number : {length, inverse}) {
            put_8(static_cast<std::uint8_t>(number & 0xFF));
            put_8(static_cast<std::uint8_t>(number >> 8));
        }
    }

    base::Span<std::uint8_t> out_;
    std::size_t at_ = 0, chunk_ = 0, in_block_ = 0;
    std::uint32_t low_ = 1, high_ = 0;  // Adler-32 (RFC 1950)
};

void put_rows(std::uint32_t width_px, std::uint32_t height_px, base::Span<const std::uint8_t> rgba, PngWriter& png) {
    std::size_t left = raw_bytes(width_px, height_px);
    for (std::uint32_t row = height_px; row-- > 0;) {
        png.put_raw(0, left--);
        const std::uint8_t* pixel = rgba.data() + std::size_t{4} * width_px * row;
        for (std::uint32_t column = 0; column < width_px; ++column, pixel += 4)
            for (int channel = 0; channel < 3; ++channel) png.put_raw(pixel[channel], left--);
    }
}

}  // namespace

std::size_t png_bytes(std::uint32_t width_px, std::uint32_t height_px) noexcept {
    return sizeof kSignature + 3 * kChunkFrame + kHeaderBytes + stream_bytes(raw_bytes(width_px, height_px));
}

void write_png(std::uint32_t width_px, std::uint32_t height_px, base::Span<const std::uint8_t> rgba,
               base::Span<std::uint8_t> out) noexcept {
    TEDAVIS_CHECK(out.size() == png_bytes(width_px, height_px) && rgba.size() == std::size_t{4} * width_px * height_px);
    PngWriter png(out);
    png.signature();
    png.begin_chunk("IHDR", kHeaderBytes);
    png.put_32(width_px);
    png.put_32(height_px);
    constexpr std::uint8_t kRgb8[5] = {8, 2, 0, 0, 0};
    png.put(kRgb8, sizeof kRgb8);
    png.end_chunk();
    png.begin_chunk("IDAT", stream_bytes(raw_bytes(width_px, height_px)));
    constexpr std::uint8_t kStoredStream[2] = {0x78, 0x01};
    png.put(kStoredStream, sizeof kStoredStream);
    put_rows(width_px, height_px, rgba, png);
    png.put_adler();
    png.end_chunk();
    png.begin_chunk("IEND", 0);
    png.end_chunk();
    TEDAVIS_CHECK(png.written() == out.size());
}

}  // namespace tedavis::target
