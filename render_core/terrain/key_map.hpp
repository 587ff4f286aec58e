/// A hash table of fixed capacity from non-zero 64-bit keys to 32-bit values; open addressing with linear probing.
///
/// Memory  from an arena at start(). Bounded: at most half of the places are used, so a search terminates. Thread  one.
#pragma once

#include <cstdint>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::terrain {

class KeyMap {
public:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    [[nodiscard]] bool start(base::Arena& arena, std::uint32_t max_entries);
    /// Returns the key's value, or kNone.
    [[nodiscard]] std::uint32_t find(std::uint64_t key) const;
    /// Changes the value of a key that is in the table.
    void change(std::uint64_t key, std::uint32_t value);
    /// Returns false when the table is full. The key must not be in the table yet.
    [[nodiscard]] bool insert(std::uint64_t key, std::uint32_t value);
    /// Removes a key; does nothing when it is not in the table.
    void erase(std::uint64_t key);
    void clear();
    [[nodiscard]] std::uint32_t size() const { return size_; }
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t max_entries);

private:
    struct Place {
        std::uint64_t key;
        std::uint32_t value;
    };
    [[nodiscard]] std::size_t home(std::uint64_t key) const;

    base::Span<Place> places_;
    std::uint32_t mask_ = 0, size_ = 0, max_entries_ = 0;
};

}  // namespace tedavis::terrain
