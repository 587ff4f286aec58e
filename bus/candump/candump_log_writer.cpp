#include "bus/candump/candump_log_writer.hpp"

namespace tedavis::bus {

CandumpLogWriter::CandumpLogWriter(TextSink& sink, base::Span<const std::string_view> interface_names, StampDigits digits,
                                   bool direction)
    : sink_(sink), digits_(digits), direction_(direction) {
    for (const std::string_view name : interface_names) TEDAVIS_CHECK(names_.try_push_back(base::FixedString<15>(name)));
}

bool CandumpLogWriter::write(const CanFrame& frame) {
    char line[kMaxCandumpLine];
    const bool named = frame.channel < names_.size();
    const std::size_t size = named ? format_candump_line(frame, names_[frame.channel].view(), digits_, direction_, line) : 0;
    const bool done = size > 0 && sink_.write(line, size);
    ++(done ? written_ : refused_);
    return done;
}

}  // namespace tedavis::bus
