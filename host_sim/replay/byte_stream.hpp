/// Converts plain values and texts to bytes and back, in native byte order, for files that only this machine and this build read.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "render_core/base/hash.hpp"

namespace tedavis::host_sim {

class ByteWriter {
public:
    template <class T>
    void put(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void put_text(std::string_view text) {
        put(std::uint64_t{text.size()});
        bytes_.append(text);
    }
    [[nodiscard]] std::string take() { return std::move(bytes_); }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

/// Reads beyond the end return zero or an empty text and make good() false. The bytes must outlive the reader and its texts.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

    template <class T>
    [[nodiscard]] T get() {
        static_assert(std::is_trivially_copyable_v<T>);
        T value{};
        const std::string_view part = next(sizeof value);
        if (!part.empty()) std::memcpy(&value, part.data(), sizeof value);
        return value;
    }
    [[nodiscard]] std::string_view get_text() { return next(get<std::uint64_t>()); }
    [[nodiscard]] bool good() const { return good_; }
    [[nodiscard]] std::size_t left() const { return bytes_.size(); }

private:
    std::string_view next(std::uint64_t count) {
        good_ = good_ && count <= bytes_.size();
        if (!good_) return {};
        const std::string_view part = bytes_.substr(0, static_cast<std::size_t>(count));
        bytes_.remove_prefix(part.size());
        return part;
    }

    std::string_view bytes_;
    bool good_ = true;
};

inline std::uint64_t checksum_of(std::string_view bytes) {
    base::Fnv1a64 hash;
    hash.add(bytes.data(), bytes.size());
    return hash.value();
}

}  // namespace tedavis::host_sim
