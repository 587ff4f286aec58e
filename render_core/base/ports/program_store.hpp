/// What the core needs on a device without a compiler: linked programs that were made beforehand, found by a key of what they
/// were made from and by which driver. A desk that has a compiler fills such a store. Implemented in platform/programs.
///
/// Thread  one. Used while the display starts, never later.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/span.hpp"

namespace tedavis::base {

struct StoredProgram {
    std::uint32_t format = 0;  ///< the driver's own number for it
    Span<const unsigned char> binary;
};

class ProgramStore {
public:
    virtual ~ProgramStore() = default;
    /// False where there is none with that key. What `program` then points to stays until the next call.
    [[nodiscard]] virtual bool find(std::uint64_t key, StoredProgram& program) = 0;
    /// Room to write a binary of `bytes` into before keep(); empty where there is none.
    [[nodiscard]] virtual Span<unsigned char> room(std::size_t bytes) = 0;
    /// Keeps what was written to room(); `name` is for people. False where it cannot be kept.
    [[nodiscard]] virtual bool keep(std::uint64_t key, std::string_view name, const StoredProgram& program) = 0;
};

}  // namespace tedavis::base
