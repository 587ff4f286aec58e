/// A node of the functional model (thesis 6.2.2.3): a function of n words that writes up to m tokens, executed for many calls
/// at once.
#pragma once

#include <type_traits>

#include "render_core/base/check.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/raytrace/stream/token.hpp"

/// Attribute of record types, struct TEDAVIS_RECORD Name {...}: lets memory that was written as words be read as records.
#define TEDAVIS_RECORD __attribute__((may_alias))

namespace tedavis::raytrace {

class TokenWriter;

/// Calls of one task, gathered from the stream. Arguments are an array of records, the layout of a call's words in the stream,
/// so consecutive calls need no copy, and other calls one copy. A kernel that needs a structure of arrays transposes sixteen
/// records in registers.
struct Batch {
    const std::uint32_t* arguments = nullptr;
    std::uint32_t count = 0;
    std::uint32_t words = 0;  ///< of a record
    TaskId self = kNoTask;
    TaskId next = kNoTask;  ///< the next task in the network

    [[nodiscard]] const std::uint32_t* record(std::uint32_t n) const { return arguments + std::size_t{n} * words; }
    /// All records, as structs of 32-bit words that are declared with TEDAVIS_RECORD.
    template <class Record>
    [[nodiscard]] const Record* records() const {
        static_assert(std::is_trivially_copyable_v<Record> && alignof(Record) == alignof(std::uint32_t));
        TEDAVIS_CHECK(sizeof(Record) == words * sizeof(std::uint32_t));
        return reinterpret_cast<const Record*>(arguments);
    }
};

/// Processes the calls in order and calls done() after each (TokenWriter), except for calls without output. The output of a
/// call must depend only on its arguments and the context, not on other calls; other results (pixels) must be written to a
/// separate location for each call. It may run on several threads at once.
using BatchFunction = void (*)(void* context, const Batch& batch, TokenWriter& out);

struct Task {
    base::FixedString<31> name;
    std::uint32_t arguments = 0;     ///< argument words of a call, below kMaxPatternWords
    std::uint32_t most_outputs = 0;  ///< largest number of tokens that a call writes, up to kMaxOutputWords
    BatchFunction run = nullptr;
    void* context = nullptr;  ///< borrowed
    TaskId next = kNoTask;
    std::uint32_t lanes = 16;  ///< calls that fill the kernel, 1 or more
    /// Words that a call writes elsewhere for the following calls; the number of calls executed together is limited so that
    /// they stay in a cache.
    std::uint32_t left_words = 0;
    std::uint32_t most_count = 0;  ///< calls that one token may stand for; 0 for as many as the limits of token.hpp allow
};

}  // namespace tedavis::raytrace
