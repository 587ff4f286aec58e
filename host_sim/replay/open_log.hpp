/// A recorded log with random access to its bytes: the file itself or, for a gzip-compressed one, its content, unpacked into
/// memory.
#pragma once

#include <memory>
#include <string>

#include "render_core/base/ports/byte_source.hpp"

namespace tedavis::host_sim {

/// Compressed files are recognized by their first bytes. Throws UserError where the file cannot be opened or unpacked.
[[nodiscard]] std::unique_ptr<base::ByteSource> open_log(const std::string& path);

}  // namespace tedavis::host_sim
