/// Reads whole input files; throws UserError where one cannot be read.
#pragma once

#include <string>

namespace tedavis::host_sim {

/// The bytes of a file.
[[nodiscard]] std::string read_file(const std::string& path);
/// The bytes of a file, unpacked when it is gzip-compressed (told by its first bytes, not its name). A truncated or
/// damaged stream is refused. `max_bytes` bounds the unpacked size.
[[nodiscard]] std::string read_file_unpacked(const std::string& path, std::size_t max_bytes = std::size_t{1} << 31);

}  // namespace tedavis::host_sim
