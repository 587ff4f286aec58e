/// Writes a bus log to a stream. The stream must outlive the sink.
#pragma once

#include <ostream>

#include "bus/candump/candump_log_writer.hpp"

namespace tedavis::host_sim {

class StreamSink final : public bus::TextSink {
public:
    explicit StreamSink(std::ostream& stream) : stream_(stream) {}
    bool write(const char* text, std::size_t count) override {
        return static_cast<bool>(stream_.write(text, static_cast<std::streamsize>(count)));
    }

private:
    std::ostream& stream_;
};

}  // namespace tedavis::host_sim
