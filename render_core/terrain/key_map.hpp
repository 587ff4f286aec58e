/// A hash table of fixed capacity from non-zero 64-bit keys to 32-bit values; open addressing with linear steps.
///
/// Memory  from an arena at start(). Bounded: at most half of the places are used, so a search ends. Thread  one.
#pragma once

#include <cstdint>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::terrain {

class KeyMap {
public:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    [[nodiscard]] bool start(base::Arena& arena, std::uint32_t max_entries);
    /// kNone when it is not in it.
    [[nodiscard]] std::uint32_t find(std::uint64_t key) const;
    /// Gives a key that is in it another value.
    void change(std::uint64_t key, std::uint32_t value);
    /// False when max_entries are in it. The key must not be in it yet.
    [[nodiscard]] bool insert(std::uint64_t key, std::uint32_t value);
    /// Does nothing when the key is not in it.
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
