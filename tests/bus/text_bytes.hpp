/// A text as a byte source that can be told to fail, and which reports how much was read.
#pragma once

#include <cstring>
#include <limits>
#include <string>

#include "render_core/base/ports/byte_source.hpp"

namespace tedavis::bus {

class TextBytes final : public base::ByteSource {
public:
    explicit TextBytes(const std::string& text) : text_(text) {}
    [[nodiscard]] std::uint64_t size() const override { return text_.size(); }
    [[nodiscard]] bool read(std::uint64_t offset, void* destination, std::size_t count) override {
        if (offset + count > text_.size() || offset + count > limit_) return false;
        std::memcpy(destination, text_.data() + offset, count);
        bytes_read_ += count;
        return true;
    }
    void fail_beyond(std::uint64_t offset) { limit_ = offset; }
    [[nodiscard]] std::uint64_t bytes_read() const { return bytes_read_; }

private:
    const std::string& text_;
    std::uint64_t limit_ = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t bytes_read_ = 0;
};

}  // namespace tedavis::bus
