/// Bytes that are already in memory as a ByteSource. Owns nothing; the bytes must outlive it.
#pragma once

#include <cstring>

#include "render_core/base/ports/byte_source.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::platform {

class MemoryByteSource final : public base::ByteSource {
public:
    explicit MemoryByteSource(base::Span<const unsigned char> bytes) : bytes_(bytes) {}

    [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
    [[nodiscard]] bool read(std::uint64_t offset, void* destination, std::size_t count) override {
        if (count > bytes_.size() || offset > bytes_.size() - count) return false;
        if (count > 0) std::memcpy(destination, bytes_.data() + offset, count);
        return true;
    }

private:
    base::Span<const unsigned char> bytes_;
};

}  // namespace tedavis::platform
