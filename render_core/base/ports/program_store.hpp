/// Port: a store of linked shader programs for a device without a shader compiler. A program's key is derived from its sources
/// and from the driver that linked it. A desktop computer with a compiler fills the store. Implemented in platform/programs.
///
/// Thread  one. Used while the display starts, never later.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/span.hpp"

namespace tedavis::base {

struct StoredProgram {
    std::uint32_t format = 0;  ///< the driver's number of the binary format
    Span<const unsigned char> binary;
};

class ProgramStore {
public:
    virtual ~ProgramStore() = default;
    /// Returns false where no program has that key. Otherwise `program` points to data that stay valid until the next call.
    [[nodiscard]] virtual bool find(std::uint64_t key, StoredProgram& program) = 0;
    /// Returns a buffer for a binary of `bytes`, to be filled before keep(); empty where there is none.
    [[nodiscard]] virtual Span<unsigned char> room(std::size_t bytes) = 0;
    /// Stores the binary written to room(); `name` is informative. Returns false where it cannot be stored.
    [[nodiscard]] virtual bool keep(std::uint64_t key, std::string_view name, const StoredProgram& program) = 0;
};

}  // namespace tedavis::base
