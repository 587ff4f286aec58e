/// A recorded log as bytes to read anywhere in: the file itself, or what a gzip-compressed one holds, which lies in memory then.
#pragma once

#include <memory>
#include <string>

#include "render_core/base/ports/byte_source.hpp"

namespace tedavis::host_sim {

/// Compressed files are told by their first bytes. Throws UserError where the file cannot be opened or unpacked.
[[nodiscard]] std::unique_ptr<base::ByteSource> open_log(const std::string& path);

}  // namespace tedavis::host_sim
