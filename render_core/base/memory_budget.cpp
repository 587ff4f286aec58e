#include "render_core/base/memory_budget.hpp"

#include <cstring>

namespace tedavis::base {

bool BudgetTable::try_add(const BudgetLine& line) { return find(line.name.view()) == nullptr && lines_.try_push_back(line); }

BudgetLine* BudgetTable::find(std::string_view name) {
    for (BudgetLine& line : lines_)
        if (line.name.view() == name) return &line;
    return nullptr;
}

const BudgetLine* BudgetTable::find(std::string_view name) const { return const_cast<BudgetTable*>(this)->find(name); }

std::uint64_t BudgetTable::total(MemoryKind kind) const {
    std::uint64_t sum = 0;
    for (const BudgetLine& line : lines_)
        if (line.kind == kind) sum += line.bytes;
    return sum;
}

std::uint64_t BudgetTable::in_use(MemoryKind kind) const {
    std::uint64_t sum = 0;
    for (const BudgetLine& line : lines_)
        if (line.kind == kind) sum += line.use.in_use;
    return sum;
}

void* Arena::allocate(std::size_t bytes, std::size_t alignment) {
    void* memory = place(bytes, alignment);
    if (memory != nullptr) std::memset(memory, 0, bytes);
    return memory;
}

void* Arena::place(std::size_t bytes, std::size_t alignment) {
    TEDAVIS_CHECK(alignment != 0 && (alignment & (alignment - 1)) == 0);
    const auto address = reinterpret_cast<std::uintptr_t>(block_) + use_.in_use;
    const std::size_t padding = (alignment - address % alignment) % alignment;
    const std::uint64_t room = use_.capacity - use_.in_use;
    if (padding > room || bytes > room - padding) {
        refuse(bytes + alignment);
        return nullptr;
    }
    unsigned char* memory = block_ + use_.in_use + padding;
    use_.take(padding + bytes);
    return memory;
}

void Arena::refuse(std::uint64_t bytes) {
    ++use_.refused;
    if (refused_bytes_ < kMaxRefusal) refused_bytes_ += bytes < kMaxRefusal ? bytes : kMaxRefusal;
}

Arena Arena::carve(std::size_t bytes) {
    void* memory = place(bytes, alignof(std::max_align_t));
    return memory == nullptr ? Arena() : Arena(memory, bytes);
}

}  // namespace tedavis::base
