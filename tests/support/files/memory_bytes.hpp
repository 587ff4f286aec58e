/// A ByteSource over bytes in memory, for tests.
#pragma once

#include <cstring>
#include <vector>

#include "render_core/base/ports/byte_source.hpp"

namespace tedavis::test_support {

class MemoryBytes : public base::ByteSource {
public:
    explicit MemoryBytes(const std::vector<std::uint8_t>& bytes) : bytes_(&bytes) {}
    [[nodiscard]] std::uint64_t size() const override { return bytes_->size(); }
    [[nodiscard]] bool read(std::uint64_t offset, void* destination, std::size_t count) override {
        if (offset > bytes_->size() || count > bytes_->size() - offset) return false;
        std::memcpy(destination, bytes_->data() + offset, count);
        return true;
    }

private:
    const std::vector<std::uint8_t>* bytes_;
};

}  // namespace tedavis::test_support
