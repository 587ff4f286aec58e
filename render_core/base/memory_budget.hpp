/// The budget table of a device: every fixed capacity of the runtime with its name, bytes, owner and reason.
///
/// One memory reservation is made at start and divided by this table; nothing allocates afterwards. The start fails where the
/// lines do not fit the reservation, and the message names the first line that does not fit.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/resource_use.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::base {

enum class MemoryKind : std::uint8_t { cpu, gpu };

struct BudgetLine {
    FixedString<31> name;
    FixedString<31> owner;
    FixedString<95> reason;
    MemoryKind kind = MemoryKind::cpu;
    std::uint64_t bytes = 0;
    ResourceUse use;  ///< bytes; updated by the owner
};

inline constexpr std::size_t kMaxBudgetLines = 32;

class BudgetTable {
public:
    /// Returns false when the table is full or the name exists already.
    [[nodiscard]] bool try_add(const BudgetLine& line);
    [[nodiscard]] BudgetLine* find(std::string_view name);
    [[nodiscard]] const BudgetLine* find(std::string_view name) const;
    [[nodiscard]] std::uint64_t total(MemoryKind kind) const;
    [[nodiscard]] std::uint64_t in_use(MemoryKind kind) const;
    [[nodiscard]] Span<const BudgetLine> lines() const { return {lines_.data(), lines_.size()}; }

private:
    FixedVector<BudgetLine, kMaxBudgetLines> lines_;
};

/// Allocates from one block, front to back; memory can only be released all at once. Not thread-safe.
class Arena {
public:
    Arena() = default;
    Arena(void* block, std::size_t bytes) : block_(static_cast<unsigned char*>(block)) { use_.capacity = bytes; }

    /// Returns zero-filled, aligned memory; returns null and counts a refusal when it does not fit.
    [[nodiscard]] void* allocate(std::size_t bytes, std::size_t alignment);
    /// Allocates `count` elements of zero bytes; returns an empty span when they do not fit. T must be trivially copyable.
    template <class T>
    [[nodiscard]] Span<T> allocate_array(std::size_t count) {
        static_assert(std::is_trivially_copyable_v<T>);
        if (count != 0 && count > use_.capacity / sizeof(T)) {
            refuse(count > kMaxRefusal / sizeof(T) ? kMaxRefusal : count * sizeof(T) + alignof(T));
            return {};
        }
        void* memory = allocate(count * sizeof(T), alignof(T));
        return memory == nullptr ? Span<T>() : Span<T>(static_cast<T*>(memory), count);
    }
    /// Returns a child arena, of capacity 0 when it does not fit. Its bytes are not touched before they are allocated, so an
    /// unused budget takes no physical memory.
    [[nodiscard]] Arena carve(std::size_t bytes);
    void reset() {
        use_.in_use = 0;
        refused_bytes_ = 0;
    }
    [[nodiscard]] const ResourceUse& use() const { return use_; }
    /// What all the requests that were refused since reset() asked for, with their alignment: so much more would have held them.
    [[nodiscard]] std::uint64_t refused_bytes() const { return refused_bytes_; }

private:
    static constexpr std::uint64_t kMaxRefusal = std::uint64_t{1} << 48;  // so that sums hold

    [[nodiscard]] void* place(std::size_t bytes, std::size_t alignment);
    void refuse(std::uint64_t bytes);

    unsigned char* block_ = nullptr;
    ResourceUse use_;
    std::uint64_t refused_bytes_ = 0;
};

}  // namespace tedavis::base
