/// The budget table of a device: every fixed capacity of the runtime, by name, with its bytes, owner and reason.
///
/// One reservation is made at start and cut by this table; nothing allocates afterwards. A start whose lines do not fit
/// the reservation is refused and the first line that does not fit is named.
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
    ResourceUse use;  ///< bytes; filled by the owner
};

inline constexpr std::size_t kMaxBudgetLines = 32;

class BudgetTable {
public:
    /// False when the table is full or the name is taken.
    [[nodiscard]] bool try_add(const BudgetLine& line);
    [[nodiscard]] BudgetLine* find(std::string_view name);
    [[nodiscard]] const BudgetLine* find(std::string_view name) const;
    [[nodiscard]] std::uint64_t total(MemoryKind kind) const;
    [[nodiscard]] std::uint64_t in_use(MemoryKind kind) const;
    [[nodiscard]] Span<const BudgetLine> lines() const { return {lines_.data(), lines_.size()}; }

private:
    FixedVector<BudgetLine, kMaxBudgetLines> lines_;
};

/// Hands out memory of one block front to back; frees nothing but everything at once. Not thread-safe.
class Arena {
public:
    Arena() = default;
    Arena(void* block, std::size_t bytes) : block_(static_cast<unsigned char*>(block)) { use_.capacity = bytes; }

    /// Zero-filled and aligned; null (and one more refusal) when it does not fit.
    [[nodiscard]] void* allocate(std::size_t bytes, std::size_t alignment);
    /// An empty span when it does not fit. T must be trivially copyable; elements are zero bytes.
    template <class T>
    [[nodiscard]] Span<T> allocate_array(std::size_t count) {
        static_assert(std::is_trivially_copyable_v<T>);
        if (count != 0 && count > use_.capacity / sizeof(T)) {
            ++use_.refused;
            return {};
        }
        void* memory = allocate(count * sizeof(T), alignof(T));
        return memory == nullptr ? Span<T>() : Span<T>(static_cast<T*>(memory), count);
    }
    /// A child arena of its own; empty (capacity 0) when it does not fit. Its bytes stay untouched until it hands them out, so
    /// that a budget costs no memory of the machine before it is used.
    [[nodiscard]] Arena carve(std::size_t bytes);
    void reset() { use_.in_use = 0; }
    [[nodiscard]] const ResourceUse& use() const { return use_; }

private:
    [[nodiscard]] void* place(std::size_t bytes, std::size_t alignment);

    unsigned char* block_ = nullptr;
    ResourceUse use_;
};

}  // namespace tedavis::base
