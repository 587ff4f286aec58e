/// Writes frames as a candump log.
#pragma once

#include <cstdint>
#include <string_view>

#include "bus/candump/candump_line.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"

namespace tedavis::bus {

/// Port: receives the text and writes it, for example to a file or a buffer. The caller of the writer implements it.
class TextSink {
public:
    virtual ~TextSink() = default;
    /// Returns false if not all bytes could be written.
    [[nodiscard]] virtual bool write(const char* text, std::size_t count) = 0;
};

/// Thread  one. Memory  fixed, inside. Failure  write() returns false and refused() counts the frame if the candump format cannot
/// express it, its channel has no name, or the sink did not write it.
class CandumpLogWriter {
public:
    /// Frames of channel n are written with the name at index n, of 16 names at most; frames of a channel without a name are
    /// refused. With `direction` each line states whether its frame was received or sent. The sink must outlive the writer.
    CandumpLogWriter(TextSink& sink, base::Span<const std::string_view> interface_names, StampDigits digits, bool direction);

    [[nodiscard]] bool write(const CanFrame& frame);
    [[nodiscard]] std::uint64_t written() const { return written_; }
    [[nodiscard]] std::uint64_t refused() const { return refused_; }

private:
    TextSink& sink_;
    base::FixedVector<base::FixedString<15>, 16> names_;
    StampDigits digits_;
    bool direction_;
    std::uint64_t written_ = 0;
    std::uint64_t refused_ = 0;
};

}  // namespace tedavis::bus
