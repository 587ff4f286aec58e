/// Reads whole input files; throws UserError where one cannot be read.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tedavis::host_sim {

/// To be called before a file is opened in another way: throws UserError where it is missing, a folder or a device.
void require_regular_file(const std::string& path);
/// The bytes of a file.
[[nodiscard]] std::string read_file(const std::string& path);
/// The same for binary data.
[[nodiscard]] std::vector<std::uint8_t> read_bytes(const std::string& path);
/// The bytes of a file, unpacked when it is gzip-compressed (told by its first bytes, not its name). A truncated or
/// damaged stream is refused. `max_bytes` bounds the unpacked size.
[[nodiscard]] std::string read_file_unpacked(const std::string& path, std::size_t max_bytes = std::size_t{1} << 31);

/// Throws UserError where the output would replace one of its own inputs.
void require_other_file(const std::string& output, const std::vector<std::string>& inputs);
/// Throws UserError where the output would replace a file that does not begin with `beginning`, as results of this kind do; the
/// message names the `kind` ("scene database"). Empty files may be replaced; paths that are no files are not checked.
void require_replaceable(const std::string& output, std::string_view beginning, const std::string& kind);
/// The same with a function that examines the first bytes, at most 64.
using BeginsAsOwn = std::function<bool(std::string_view)>;
void require_replaceable(const std::string& output, const BeginsAsOwn& is_own, const std::string& kind);
/// The same for candump logs, which do not state their program: the first line must begin with a time in brackets.
void require_replaceable_log(const std::string& output);

}  // namespace tedavis::host_sim
