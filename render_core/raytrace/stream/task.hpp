/// A node of the functional model (thesis 6.2.2.3): a function of n words that gives up to m tokens, for many calls at once.
#pragma once

#include <type_traits>

#include "render_core/base/check.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/raytrace/stream/token.hpp"

/// struct TEDAVIS_RECORD Name {...}: may be read where words were written.
#define TEDAVIS_RECORD __attribute__((may_alias))

namespace tedavis::raytrace {

class TokenWriter;

/// Calls of one task, gathered from the stream. Arguments are records, one behind the other: that is how a call's words lie in
/// the stream, so calls that stand together are handed on without a copy, and gathering one is one copy of its words. A kernel
/// that wants a structure of arrays turns sixteen records in its registers.
struct Batch {
    const std::uint32_t* arguments = nullptr;
    std::uint32_t count = 0;
    std::uint32_t words = 0;  ///< of a record
    TaskId self = kNoTask;
    TaskId next = kNoTask;  ///< what follows in the network

    [[nodiscard]] const std::uint32_t* record(std::uint32_t n) const { return arguments + std::size_t{n} * words; }
    /// All records, as structs of 32-bit words that are declared with TEDAVIS_RECORD.
    template <class Record>
    [[nodiscard]] const Record* records() const {
        static_assert(std::is_trivially_copyable_v<Record> && alignof(Record) == alignof(std::uint32_t));
        TEDAVIS_CHECK(sizeof(Record) == words * sizeof(std::uint32_t));
        return reinterpret_cast<const Record*>(arguments);
    }
};

/// Goes through the calls in order and says after each that it is done (TokenWriter), but for one that gives nothing at all. What
/// a call gives must depend on its arguments and the context alone, not on the calls beside it; what it writes elsewhere (pixels)
/// must lie in a place of its own. It may run on several threads at once.
using BatchFunction = void (*)(void* context, const Batch& batch, TokenWriter& out);

struct Task {
    base::FixedString<31> name;
    std::uint32_t arguments = 0;     ///< words of a call, below kMaxPatternWords
    std::uint32_t most_outputs = 0;  ///< tokens that one call gives, to kMaxOutputWords
    BatchFunction run = nullptr;
    void* context = nullptr;  ///< borrowed
    TaskId next = kNoTask;
    std::uint32_t lanes = 16;  ///< calls that fill the kernel, 1 or more
    /// What a call leaves elsewhere for those that follow it, in words: so few calls run together that it stays in a cache.
    std::uint32_t left_words = 0;
    std::uint32_t most_count = 0;  ///< calls that one token may stand for; 0 for as many as the limits of token.hpp allow
};

}  // namespace tedavis::raytrace
